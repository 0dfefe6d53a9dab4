// Layouts of symmetric cuts: pairs of mirrored charts side by side, symmetric charts upright, with all margins; and as usual where
// charts are not mirrored.

#include "../BGL/check.h"
#include "charts_to_pack.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <vector>

namespace symmetric_layout_test {

using CGAL::Surface_mesh_cutting::Chart_rotation;
using CGAL::Surface_mesh_cutting::Symmetry;
using Vertex = Mesh::Vertex_index;
using Polygon = std::vector<Kernel::Point_2>;

// Charts that x -> -x maps to each other or to themselves, turned in the plane in all ways. All are in one piece each.
struct Mirrored_charts
{
  Charts charts;
  std::vector<std::vector<Vertex> > parts;
  std::vector<Vertex> image; // per vertex

  Mirrored_charts(CGAL::Random& random, int pairs, int selves)
  {
    for(int i = 0; i < pairs; ++i)
    {
      Polygon polygon;
      const int corners = random.get_int(3, 20);
      const Kernel::Point_2 center(4, 5 * i);
      for(int k = 0; k < corners; ++k)
        polygon.push_back(on_star(center, 2 * CGAL_PI * k / corners, random.get_double(0.5, 2)));
      add(polygon, center);
      for(Kernel::Point_2& p : polygon)
        p = mirrored(p);
      std::reverse(polygon.begin(), polygon.end());
      add(polygon, mirrored(center));
    }
    for(int i = 0; i < selves; ++i)
    {
      Polygon right, left;
      const int corners = random.get_int(2, 9);
      const Kernel::Point_2 center(0, 5 * i);
      for(int k = 0; k < corners; ++k)
      {
        right.push_back(on_star(center, CGAL_PI * ((k + 0.5) / corners - 0.5), random.get_double(0.5, 2)));
        left.push_back(mirrored(right.back()));
      }
      right.insert(right.end(), left.rbegin(), left.rend());
      add(right, center);
    }
    find_images();
    for(const std::vector<Vertex>& part : parts)
      turn(part, random.get_double(0, 2 * CGAL_PI));
  }

  const Kernel::Point_2& uv(Vertex v) const
  {
    auto h = charts.mesh.halfedge(v);
    return charts.uv[charts.mesh.is_border(h) ? charts.mesh.opposite(charts.mesh.next(h)) : h];
  }

private:
  static Kernel::Point_2 on_star(const Kernel::Point_2& center, double angle, double radius)
  { return {center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle)}; }

  static Kernel::Point_2 mirrored(const Kernel::Point_2& p) { return {-p.x(), p.y()}; }

  void add(const Polygon& polygon, const Kernel::Point_2& center)
  {
    const int first = int(charts.mesh.number_of_vertices());
    charts.add(polygon, center);
    parts.emplace_back();
    for(int v = first; v < int(charts.mesh.number_of_vertices()); ++v)
      parts.back().push_back(Vertex(Mesh::size_type(v)));
  }

  void find_images()
  {
    std::map<Kernel::Point_3, Vertex> at;
    for(const Vertex v : charts.mesh.vertices())
      at[charts.mesh.point(v)] = v;
    for(const Vertex v : charts.mesh.vertices())
    {
      const Kernel::Point_3& p = charts.mesh.point(v);
      image.push_back(at.at(Kernel::Point_3(p.x() == 0 ? 0 : -p.x(), p.y(), p.z())));
    }
  }

  void turn(const std::vector<Vertex>& part, double angle)
  {
    for(const Vertex v : part)
      for(const auto h : CGAL::halfedges_around_target(v, charts.mesh))
        if(!charts.mesh.is_border(h))
        {
          const Kernel::Point_2 p = charts.uv[h];
          charts.uv[h] = {std::cos(angle) * p.x() - std::sin(angle) * p.y(), std::sin(angle) * p.x() + std::cos(angle) * p.y()};
        }
  }
};

// Whether a part and its image are mirrored, with a vertical axis; else with a horizontal one.
bool is_mirrored(const Mirrored_charts& all, const std::vector<Vertex>& part, bool is_vertical)
{
  const auto across = [&](const Kernel::Point_2& p) { return is_vertical ? p.x() : p.y(); };
  const auto along = [&](const Kernel::Point_2& p) { return is_vertical ? p.y() : p.x(); };
  const double sum = across(all.uv(part.front())) + across(all.uv(all.image[part.front()]));
  return std::all_of(part.begin(), part.end(), [&](Vertex v)
  {
    const Kernel::Point_2 &p = all.uv(v), &q = all.uv(all.image[v]);
    return std::abs(across(p) + across(q) - sum) < 1e-9 && std::abs(along(p) - along(q)) < 1e-9;
  });
}

// Between the boxes of a part and its image, to the right or to the left.
double gap(const Mirrored_charts& all, const std::vector<Vertex>& part)
{
  double low[2], high[2];
  std::fill(low, low + 2, std::numeric_limits<double>::infinity());
  std::fill(high, high + 2, -std::numeric_limits<double>::infinity());
  for(const Vertex v : part)
    for(const int k : {0, 1})
    {
      const double x = all.uv(k == 0 ? v : all.image[v]).x();
      low[k] = (std::min)(low[k], x);
      high[k] = (std::max)(high[k], x);
    }
  return (std::max)(low[1] - high[0], low[0] - high[1]);
}

template <typename Parameters>
double check_packed(Mirrored_charts& all, const Parameters& np, double margin, int size, int pages = 1)
{
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(all.charts.mesh, all.charts.is_cut, all.charts.uv, np);
  CHECK(result && result.number_of_charts == int(all.parts.size()));
  CHECK(CGAL::Surface_mesh_cutting::certify_packing(all.charts.mesh, all.charts.is_cut, all.charts.uv, np));
  check_distances(all.charts, margin, size, pages);
  check_similarity(all.charts, result.scale);
  return result.fill;
}

void test_upright(CGAL::Random& random)
{
  for(const auto& [pairs, selves] : std::vector<std::pair<int, int> >{{1, 0}, {0, 1}, {0, 2}, {3, 2}, {12, 9}})
    for(const double margin : {0., 2., 20.})
    {
      Mirrored_charts all(random, pairs, selves);
      const double fill = check_packed(all, parameters::symmetry(Symmetry::X).chart_rotation(Chart_rotation::UPRIGHT)
                                              .margin(margin).texture_size(512).effort(Effort::FAST), margin, 512);
      std::cout << pairs << " pairs, " << selves << " symmetric charts, margin " << margin << ": fill " << fill << std::endl;
      for(const std::vector<Vertex>& part : all.parts)
        CHECK(is_mirrored(all, part, true));
      for(std::size_t i = 0; i < std::size_t(2 * pairs); ++i)
        CHECK(gap(all, all.parts[i]) >= margin / 512 && gap(all, all.parts[i]) <= 2.2 * margin / 512 + 2e-5);
    }
}

// Each axis is vertical or horizontal.
void test_quarter(CGAL::Random& random)
{
  Mirrored_charts all(random, 5, 4);
  const auto np = parameters::symmetry(Symmetry::AUTOMATIC).chart_rotation(Chart_rotation::QUARTER).effort(Effort::FAST);
  check_packed(all, np, 2, 1024);
  for(const std::vector<Vertex>& part : all.parts)
    CHECK(is_mirrored(all, part, true) || is_mirrored(all, part, false));
}

// Pairs stay together, however they are turned: all lines from vertices to their images are parallel.
void test_turned(CGAL::Random& random)
{
  for(const Chart_rotation rotation : {Chart_rotation::ANY, Chart_rotation::AUTOMATIC, Chart_rotation::NONE})
  {
    Mirrored_charts all(random, 4, 0);
    check_packed(all, parameters::symmetry(Symmetry::X).chart_rotation(rotation).effort(Effort::FAST), 2, 1024);
    for(const std::vector<Vertex>& part : all.parts)
    {
      const Kernel::Vector_2 first = all.uv(all.image[part.front()]) - all.uv(part.front());
      for(const Vertex v : part)
      {
        const Kernel::Vector_2 d = all.uv(all.image[v]) - all.uv(v);
        CHECK(std::abs(first.x() * d.y() - first.y() * d.x()) < 1e-9 && first * d > 0);
      }
    }
  }
}

// At a given scale, on pages: pairs are not divided.
void test_pages(CGAL::Random& random)
{
  Mirrored_charts all(random, 6, 3);
  const auto np = parameters::symmetry(Symmetry::X).chart_rotation(Chart_rotation::UPRIGHT).texels_per_unit(60).texture_size(512);
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(all.charts.mesh, all.charts.is_cut, all.charts.uv, np);
  CHECK(result && result.page_fills.size() > 1 && std::abs(result.scale - 60. / 512) < 1e-12);
  check_distances(all.charts, 2, 512, int(result.page_fills.size()));
  for(const std::vector<Vertex>& part : all.parts)
    CHECK(is_mirrored(all, part, true));
}

// Where a surface or its cut has no symmetry, all is as without; margins that leave pairs no room.
void test_others(CGAL::Random& random)
{
  Charts charts = random_stars(random, 5), same = copy_of(charts), upright = copy_of(charts), quarter = copy_of(charts);
  const auto pack = [](Charts& c, const auto& np)
  { CHECK(CGAL::Surface_mesh_cutting::pack_charts(c.mesh, c.is_cut, c.uv, np)); };
  const auto has_equal_uvs = [](const Charts& a, const Charts& b) { return std::equal(a.uv.begin(), a.uv.end(), b.uv.begin()); };
  pack(charts, parameters::effort(Effort::FAST));
  pack(same, parameters::effort(Effort::FAST).symmetry(Symmetry::AUTOMATIC));
  pack(upright, parameters::effort(Effort::FAST).chart_rotation(Chart_rotation::UPRIGHT));
  pack(quarter, parameters::effort(Effort::FAST).chart_rotation(Chart_rotation::QUARTER));
  CHECK(has_equal_uvs(charts, same) && has_equal_uvs(upright, quarter));

  // A cut of one chart that its image does not have.
  Mirrored_charts all(random, 2, 1);
  const Mesh& mesh = all.charts.mesh;
  const auto edge = *std::find_if(mesh.edges_begin(), mesh.edges_end(), [&](auto e) { return !mesh.is_border(e); });
  all.charts.is_cut[edge] = true;
  Charts plain = copy_of(all.charts);
  pack(plain, parameters::effort(Effort::FAST));
  pack(all.charts, parameters::effort(Effort::FAST).symmetry(Symmetry::X));
  CHECK(has_equal_uvs(plain, all.charts));
}

} // namespace symmetric_layout_test

int main(int argc, char** argv)
{
  using namespace symmetric_layout_test;
  CGAL::Random random(argc > 1 ? unsigned(std::atoi(argv[1])) : 1);
  std::cout << "seed " << random.get_seed() << std::endl;
  test_upright(random);
  test_quarter(random);
  test_turned(random);
  test_pages(random);
  test_others(random);
  return test::exit_status();
}
