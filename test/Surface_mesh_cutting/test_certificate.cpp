// The exact certificate of injectivity against a test of all pairs of triangles.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_cutting/internal/base.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace certificate_test {

using namespace CGAL::Surface_mesh_cutting::internal;
using Eigen::Vector2d;

CGAL::Sign exact_side(const Vector2d& a, const Vector2d& b, const Vector2d& c)
{
  using FT = CGAL::Exact_rational;
  return CGAL::sign((FT(b.x()) - FT(a.x())) * (FT(c.y()) - FT(a.y())) - (FT(b.y()) - FT(a.y())) * (FT(c.x()) - FT(a.x())));
}

// A flat surface that grows triangle by triangle.
struct Surface
{
  std::vector<Triangle> triangles;
  std::vector<Vector2d> uv;

  std::vector<int> opposites() const
  {
    std::map<std::pair<int, int>, int> halfedges;
    for(int h = 0; h < 3 * int(triangles.size()); ++h)
      halfedges[{triangles[h / 3][h % 3], triangles[h / 3][(h + 1) % 3]}] = h;
    std::vector<int> result;
    for(int h = 0; h < 3 * int(triangles.size()); ++h)
    {
      const auto it = halfedges.find({triangles[h / 3][(h + 1) % 3], triangles[h / 3][h % 3]});
      result.push_back(it == halfedges.end() ? -1 : it->second);
    }
    return result;
  }

  Corner_table chart() const { return Corner_table(triangles, opposites(), int(uv.size())); }

  // Adds a triangle if it is counterclockwise.
  bool add(const Triangle& t)
  {
    if(exact_side(uv[t[0]], uv[t[1]], uv[t[2]]) != CGAL::POSITIVE)
      return false;
    triangles.push_back(t);
    return true;
  }

  void add_part(const std::vector<Vector2d>& points, const std::vector<Triangle>& part)
  {
    const int first = int(uv.size());
    uv.insert(uv.end(), points.begin(), points.end());
    for(const Triangle& t : part)
      triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }

  // Triangles that overlap: no edge of one has the other one on its outer side.
  bool has_overlap() const
  {
    const auto is_separated = [this](const Triangle& s, const Triangle& t)
    {
      for(int k = 0; k < 3; ++k)
        if(std::all_of(t.begin(), t.end(), [&](int v)
                       { return exact_side(uv[s[k]], uv[s[(k + 1) % 3]], uv[v]) != CGAL::POSITIVE; }))
          return true;
      return false;
    };
    for(std::size_t i = 0; i < triangles.size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        if(!is_separated(triangles[i], triangles[j]) && !is_separated(triangles[j], triangles[i]))
          return true;
    return false;
  }
};

Vector2d random_point(int size, CGAL::Random& random)
{
  return Vector2d(random.get_int(0, size), random.get_int(0, size));
}

// A disk of `n` triangles over a small grid, so that contacts of all kinds are common. With `fan`,
// neighboring border edges are often closed by a triangle, which makes inner vertices and angles of
// more than a full turn.
void grow_disk(Surface& surface, int n, int size, bool fan, CGAL::Random& random)
{
  const int first = int(surface.uv.size());
  const std::size_t first_triangle = surface.triangles.size();
  for(int k = 0; k < 3; ++k)
    surface.uv.push_back(Vector2d());
  do
    for(int k = 0; k < 3; ++k)
      surface.uv[first + k] = random_point(size, random);
  while(!surface.add({first, first + 1, first + 2}));
  std::vector<int> border = {first, first + 1, first + 2};
  for(int attempts = 0; attempts < 50 * n && int(surface.triangles.size() - first_triangle) < n; ++attempts)
  {
    const int i = random.get_int(0, int(border.size()));
    const int v = border[i], w = border[(i + 1) % border.size()], x = border[(i + 2) % border.size()];
    if(fan && border.size() > 4 && random.get_bool())
    {
      // The edge from v to x must be new.
      const bool is_new = std::none_of(surface.triangles.begin(), surface.triangles.end(), [&](const Triangle& t)
      { return std::count(t.begin(), t.end(), v) && std::count(t.begin(), t.end(), x); });
      if(is_new && surface.add({x, w, v}))
        border.erase(border.begin() + (i + 1) % border.size());
      continue;
    }
    const int u = int(surface.uv.size());
    surface.uv.push_back(random_point(size, random));
    if(surface.add({w, v, u}))
      border.insert(border.begin() + i + 1, u);
    else
      surface.uv.pop_back();
  }
}

// How many of the random surfaces have no overlap.
int test_random(int runs, int charts, int triangles, int size, bool fan, CGAL::Random& random)
{
  int injective = 0;
  for(int i = 0; i < runs; ++i)
  {
    Surface surface;
    for(int c = 0; c < charts; ++c)
      grow_disk(surface, random.get_int(1, triangles + 1), size, fan, random);
    const Corner_table chart = surface.chart();
    CHECK(check_disks(chart));
    const Certificate certificate = certify(chart, surface.uv, true);
    CHECK(certificate.flips == 0);
    CHECK((certificate.overlaps() > 0) == surface.has_overlap());
    CHECK(bool(certificate) == (certificate.overlaps() == 0));
    CHECK(bool(certificate.status()) == bool(certificate));
    CHECK(certify(chart, surface.uv, false));
    // The same at the limits of double precision.
    std::vector<Vector2d> uv = surface.uv;
    for(Vector2d& p : uv)
      p = std::ldexp(1., i % 2 ? 1010 : -1070) * p;
    CHECK(certify(chart, uv, true).crossings == certificate.crossings);
    CHECK(certify(chart, uv, true).containments == certificate.containments);
    injective += certificate.overlaps() == 0;
  }
  return injective;
}

// Charts that lie apart, touch, coincide, contain each other.
void test_squares()
{
  const auto square = [](double x, double y, double size)
  {
    return std::vector<Vector2d>{Vector2d(x, y), Vector2d(x + size, y), Vector2d(x + size, y + size), Vector2d(x, y + size)};
  };
  const std::vector<Triangle> two = {{0, 1, 2}, {0, 2, 3}};
  const auto check = [&](const std::vector<Vector2d>& other, int crossings, int containments)
  {
    for(bool swap : {false, true})
    {
      Surface surface;
      surface.add_part(swap ? other : square(0, 0, 4), two);
      surface.add_part(swap ? square(0, 0, 4) : other, two);
      const Certificate c = certify(surface.chart(), surface.uv, true);
      CHECK((c.crossings > 0) == (crossings > 0) && c.containments == containments);
      CHECK((c.overlaps() > 0) == surface.has_overlap());
    }
  };
  check(square(5, 0, 4), 0, 0);   // apart
  check(square(4, 0, 4), 0, 0);   // a common side
  check(square(4, 1, 2), 0, 0);   // a part of a side
  check(square(4, 4, 2), 0, 0);   // a common corner
  check(square(0, 0, 4), 1, 0);   // on top of each other
  check(square(1, 1, 2), 0, 1);   // inside
  check(square(0, 1, 2), 1, 0);   // inside, touching
  check(square(0, 0, 2), 1, 0);   // inside, at a corner
  check(square(2, 2, 4), 1, 0);   // crossing
  check(square(2, 0, 4), 1, 0);   // crossing along sides
  check({Vector2d(2, 0), Vector2d(4, 2), Vector2d(2, 4), Vector2d(0, 2)}, 1, 0); // touching from inside
}

// A chart in the hole of another one, and between its arms.
void test_ring()
{
  Surface ring; // an annulus around (0, 0), from radius 2 to 4
  std::vector<Vector2d> points;
  std::vector<Triangle> triangles;
  for(int i = 0; i < 4; ++i)
  {
    const Vector2d d[4] = {Vector2d(1, 1), Vector2d(-1, 1), Vector2d(-1, -1), Vector2d(1, -1)};
    points.push_back(2 * d[i]);
    points.push_back(4 * d[i]);
    const int a = 2 * i, b = (2 * i + 2) % 8;
    triangles.push_back({a, a + 1, b});
    triangles.push_back({b, a + 1, b + 1});
  }
  ring.add_part(points, triangles);
  CHECK(!check_disks(ring.chart()));
  CHECK(check_disks(ring.chart()).finding.indices.size() == 8);
  CHECK(certify(ring.chart(), ring.uv, true));
  Surface inside = ring;
  inside.add_part({Vector2d(-1, -1), Vector2d(1, -1), Vector2d(0, 1)}, {{0, 1, 2}});
  CHECK(certify(inside.chart(), inside.uv, true));
  inside.add_part({Vector2d(-9, -9), Vector2d(9, -9), Vector2d(0, 19)}, {{0, 1, 2}});
  CHECK(certify(inside.chart(), inside.uv, true).containments == 2);
}

void test_invalid()
{
  Surface surface;
  surface.add_part({Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1), Vector2d(1, 1)}, {{0, 1, 2}, {2, 1, 3}});
  const Corner_table chart = surface.chart();
  std::vector<Vector2d> corner_uv;
  for(int h = 0; h < 6; ++h)
    corner_uv.push_back(surface.uv[chart.source(h)]);
  CHECK(certify_corners(chart, corner_uv, true));

  std::vector<Vector2d> changed = corner_uv;
  changed[4].x() = std::nextafter(changed[4].x(), 2.);
  Certificate c = certify_corners(chart, changed, true);
  CHECK(!c && c.torn == 1 && c.flips == 0 && c.faces == std::vector<int>{1});
  CHECK(c.status().finding.code == CGAL::Surface_mesh_cutting::Status_code::NOT_CERTIFIED);

  changed = corner_uv;
  changed[5] = Vector2d(0.5, 0.5);
  c = certify_corners(chart, changed, false);
  CHECK(!c && c.flips == 1 && c.torn == 0 && c.faces == std::vector<int>{1});

  changed = corner_uv;
  changed[0].y() = std::numeric_limits<double>::quiet_NaN();
  c = certify_corners(chart, changed, true);
  CHECK(!c && c.flips == 1 && c.non_finite == 1 && c.faces == std::vector<int>{0});

  // Whatever the values, there is an answer.
  CGAL::Random random(1);
  for(int i = 0; i < 200; ++i)
  {
    Surface garbage;
    grow_disk(garbage, 8, 4, true, random);
    for(Vector2d& p : garbage.uv)
      p = random_point(3, random);
    certify(garbage.chart(), garbage.uv, true);
  }
}

// A spiral of many turns: its boxes nest deeply, its parts do not touch.
void test_large(int n)
{
  Surface surface;
  std::vector<Vector2d> points;
  std::vector<Triangle> triangles;
  for(int i = 0; i < n; ++i)
  {
    const double angle = 0.01 * i, radius = 1 + angle;
    for(double r : {radius, radius + 3})
      points.push_back(r * Vector2d(std::cos(angle), std::sin(angle)));
    if(i > 0)
    {
      triangles.push_back({2 * i - 2, 2 * i - 1, 2 * i});
      triangles.push_back({2 * i, 2 * i - 1, 2 * i + 1});
    }
  }
  surface.add_part(points, triangles);
  CHECK(certify(surface.chart(), surface.uv, true));
}

} // namespace certificate_test

int main()
{
  using namespace certificate_test;
  CGAL::Random random(11);
  const int runs = 1000;
  int injective = 0, all = 0;
  for(bool fan : {false, true})
    for(int size : {4, 8, 1000})
      for(int charts : {1, 2, 4})
        for(int triangles : {2, 8})
        {
          injective += test_random(runs / charts, charts, triangles / charts + 1, size, fan, random);
          all += runs / charts;
        }
  // Neither answer is rare.
  CHECK(injective > all / 10 && injective < all - all / 10);
  test_squares();
  test_ring();
  test_invalid();
  test_large(20000);
  return test::exit_status();
}
