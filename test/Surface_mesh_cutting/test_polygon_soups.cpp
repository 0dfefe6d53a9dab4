// Polygon soups of all kinds are unwrapped: what is said about them is compared with brute force, and the UVs with what
// every map has to satisfy.

#include "../BGL/check.h"
#include "polygon_soups.h"
#include "soup_definitions.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrapped_polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/unwrap_polygon_soup.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/algorithm.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace polygon_soups_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using Kernel = CGAL::Simple_cartesian<double>;
using test::Polygon;
using test::Soup;
using Kind = SMC::Interpretation_kind;
using Corner_uvs = std::vector<std::vector<Kernel::Point_2> >;

std::vector<Kernel::Point_3> points_of(const Soup& soup)
{
  std::vector<Kernel::Point_3> points;
  for(const std::array<double, 3>& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

const SMC::Interpretation* find(const SMC::Unwrap_soup_result& result, Kind kind)
{
  for(const SMC::Interpretation& i : result.interpreted)
    if(i.kind == kind)
      return &i;
  return nullptr;
}

std::size_t count(const SMC::Unwrap_soup_result& result, Kind kind)
{
  const SMC::Interpretation* const found = find(result, kind);
  return found == nullptr ? 0 : found->count();
}

std::vector<std::size_t> polygons(const SMC::Unwrap_soup_result& result, Kind kind)
{
  const SMC::Interpretation* const found = find(result, kind);
  return found == nullptr ? std::vector<std::size_t>() : found->polygons;
}

double signed_area(const std::vector<Kernel::Point_2>& polygon)
{
  double sum = 0;
  for(std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += CGAL::to_double(CGAL::area(polygon[0], polygon[i], polygon[i + 1]));
  return sum;
}

void check_findings(const std::string& name, const Soup& soup, const SMC::Unwrap_soup_result& result)
{
  const test::Brute_force expected(soup);
  CHECK(polygons(result, Kind::DEGENERATE_FACES) == expected.degenerate, name + ": degenerate faces");
  CHECK(polygons(result, Kind::DUPLICATE_FACES) == expected.duplicates, name + ": duplicate faces");
  const SMC::Interpretation* const vertices = find(result, Kind::NON_MANIFOLD_VERTICES);
  CHECK((vertices == nullptr ? std::vector<std::size_t>() : vertices->vertices) == expected.non_manifold_vertices,
        name + ": non-manifold vertices");
  std::set<std::pair<std::size_t, std::size_t> > many, one_sided;
  for(const auto& [edge, at_edge] : expected.edges)
    if(at_edge.size() > 2)
      many.insert(edge);
  const SMC::Interpretation* const edges = find(result, Kind::NON_MANIFOLD_EDGES);
  CHECK((edges == nullptr ? 0 : edges->edges.size()) == many.size(), name + ": number of non-manifold edges");
  if(edges != nullptr)
    for(const auto& edge : edges->edges)
      CHECK(many.count({edge[0], edge[1]}) == 1, name + ": non-manifold edge");

  // After the turns, neighbors agree except at the edges that are named.
  if(const SMC::Interpretation* const open = find(result, Kind::NON_ORIENTABLE_EDGES))
    for(const auto& edge : open->edges)
      one_sided.insert({edge[0], edge[1]});
  // A polygon and its reverse are no neighbors, and a bridge of a polygon has that on both sides.
  const std::vector<std::size_t> turned = polygons(result, Kind::REORIENTED_FACES);
  for(const auto& [edge, at_edge] : expected.edges)
    if(at_edge.size() == 2 && at_edge[0] != at_edge[1] && !test::are_reverse(soup.faces[at_edge[0]], soup.faces[at_edge[1]]))
    {
      int up = 0;
      for(const std::size_t p : at_edge)
      {
        const Polygon polygon = test::without_repetitions(soup.faces[p]);
        const std::size_t k = std::find(polygon.begin(), polygon.end(), edge.first) - polygon.begin();
        const bool is_upward = polygon[(k + 1) % polygon.size()] == edge.second;
        up += is_upward != std::binary_search(turned.begin(), turned.end(), p);
      }
      CHECK((up == 1) != (one_sided.count(edge) == 1), name + ": orientation at an edge");
    }
}

SMC::Unwrap_soup_result unwrap(const std::string& name, const Soup& soup, bool do_weld = false)
{
  const std::vector<Kernel::Point_3> points = points_of(soup);
  Corner_uvs uvs;
  const SMC::Unwrap_soup_result result
    = SMC::unwrap_polygon_soup(points, soup.faces, uvs, CGAL::parameters::do_weld_points(do_weld));
  CHECK(result, name + ": " + result.status.message);
  if(!result.has_result)
    return result;
  const SMC::Result_status<SMC::Polygon_soup> certificate
    = SMC::certify_unwrapped_polygon_soup(points, soup.faces, uvs, CGAL::parameters::do_weld_points(do_weld));
  CHECK(certificate, name + ": certificate: " + certificate.message);
  if(!do_weld)
    check_findings(name, soup, result);

  CHECK(uvs.size() == soup.faces.size(), name + ": number of polygons");
  const std::vector<std::size_t> turned = polygons(result, Kind::REORIENTED_FACES);
  std::set<std::size_t> left_out;
  for(Kind kind : {Kind::DEGENERATE_FACES, Kind::DUPLICATE_FACES})
    for(std::size_t p : polygons(result, kind))
      left_out.insert(p);
  for(std::size_t p = 0; p < uvs.size(); ++p)
  {
    CHECK(uvs[p].size() == soup.faces[p].size(), name + ": number of corners");
    for(const Kernel::Point_2& uv : uvs[p])
      CHECK(std::isfinite(uv.x()) && std::isfinite(uv.y()), name + ": finite UVs");
    const double sign = std::binary_search(turned.begin(), turned.end(), p) ? -1 : 1;
    if(left_out.count(p) == 0)
      CHECK(sign * signed_area(uvs[p]) > 0, name + ": a polygon is clockwise");
  }
  return result;
}

void test_polygons()
{
  CHECK(unwrap("flat squares", test::whole_quads(4, 3, false, false)).cut_length == 0, "a disk needs no cut");
  CHECK(unwrap("torus", test::whole_quads(8, 6, true, true)).genus == 1, "genus of the torus");
  CHECK(unwrap("tube", test::whole_quads(8, 3, true, false)).borders == 2, "borders of the tube");
  for(int n : {3, 10, 40})
  {
    const SMC::Unwrap_soup_result star = unwrap("star of " + std::to_string(n), test::star_prism(n));
    CHECK(star.genus == 0 && star.components == 1 && star.interpreted.empty(), "a star is a sphere");
  }
  for(const Soup& soup : {test::whole_quads(4, 3, false, false), test::whole_quads(5, 4, true, true), test::sphere(5, 3), test::star_prism(5)})
    unwrap("midpoints", test::with_midpoints(soup));

  // A flat concave polygon is mapped onto itself.
  Soup concave;
  concave.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0.1, 0}, {0, 4, 0}};
  concave.faces = {{0, 1, 2, 3, 4}};
  CHECK(std::abs(unwrap("concave", concave).average_distortion - 4) < 1e-6, "a flat polygon has no distortion");

  // A pillow of two squares, one of which needs the other diagonal.
  Soup pillow = concave;
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  pillow.faces = {{0, 1, 2, 3}, {3, 2, 1, 0}};
  CHECK(unwrap("pillow", pillow).genus == 0, "a pillow is a sphere");
}

void test_non_manifold()
{
  for(int k : {3, 4, 7, 20})
  {
    const SMC::Unwrap_soup_result result = unwrap("book", test::book(k, 3));
    CHECK(result.components == (k + 1) / 2, "pairs of sheets stay connected");
    CHECK(count(result, Kind::NON_MANIFOLD_EDGES) == 3, "edges of a book");
  }
  // Two tetrahedra that share an edge, or a face that both have, or a vertex, are two closed surfaces.
  const std::vector<std::array<double, 3> > points
    = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {2, 1, 0}, {-1, -1, 0}, {-2, 0, 1}};
  for(const auto& other : std::vector<std::array<std::size_t, 4> >{{{0, 1, 4, 5}}, {{1, 2, 3, 4}}, {{0, 6, 7, 4}}})
  {
    Soup soup = test::tetrahedron(0, 1, 2, 3);
    soup.points = points;
    const Soup second = test::tetrahedron(other[0], other[1], other[2], other[3]);
    soup.faces.insert(soup.faces.end(), second.faces.begin(), second.faces.end());
    const SMC::Unwrap_soup_result result = unwrap("two tetrahedra", soup);
    CHECK(result.components == 2 && result.borders == 0 && result.genus == 0, "two closed tetrahedra");
  }
  // Sheets with a front and a back.
  for(int n : {1, 3, 8})
  {
    Soup two_sided = test::quads(n, n, false, false);
    const std::size_t number = two_sided.faces.size();
    for(std::size_t f = 0; f < number; ++f)
      two_sided.faces.push_back({two_sided.faces[f][2], two_sided.faces[f][1], two_sided.faces[f][0]});
    const SMC::Unwrap_soup_result result = unwrap("two-sided sheet", two_sided);
    CHECK(result.components == 2 && result.borders == 2 && count(result, Kind::REORIENTED_FACES) == 0,
          "front and back of a sheet");
  }
  for(int k : {9, 40, 101})
    CHECK(unwrap("many sheets", test::book(k, 1)).components == (k + 1) / 2, "pairs of many sheets stay connected");
}

// Comparing all pairs of sides would take hours.
void test_edge_of_many_sheets()
{
  constexpr int number = 100000;
  const Soup soup = test::book(number, 1);
  std::vector<SMC::internal::Point> points;
  for(const std::array<double, 3>& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  SMC::internal::Polygons polygons;
  for(const Polygon& polygon : soup.faces)
  {
    polygons.vertices.insert(polygons.vertices.end(), polygon.begin(), polygon.end());
    polygons.close();
  }
  const SMC::internal::Soup_surface surface
    = SMC::internal::read_soup(points, polygons, SMC::internal::Welding(), SMC::internal::Execution::SEQUENTIAL);
  CHECK(std::count(surface.opposites.begin(), surface.opposites.end(), -1) == 3 * number, "sheets in pairs");
}

void test_orientation()
{
  for(int n : {3, 5, 20})
  {
    const SMC::Unwrap_soup_result result = unwrap("Moebius strip", test::moebius_strip(n));
    CHECK(count(result, Kind::NON_ORIENTABLE_EDGES) > 0, "a Moebius strip is opened");
  }
  Soup soup = test::whole_quads(8, 6, true, true);
  for(std::size_t f : {3, 17, 30})
    std::reverse(soup.faces[f].begin(), soup.faces[f].end());
  CHECK(polygons(unwrap("three turned", soup), Kind::REORIENTED_FACES) == std::vector<std::size_t>({3, 17, 30}),
        "the three turned polygons");
}

void test_left_out()
{
  Soup soup = test::whole_quads(8, 6, true, true);
  soup.faces.push_back({soup.faces[5][2], soup.faces[5][3], soup.faces[5][0], soup.faces[5][1]});
  soup.faces.push_back(soup.faces[5]);
  soup.faces.push_back({soup.faces[7][0], soup.faces[7][1], soup.faces[7][0]});
  soup.faces.push_back({4, 4});
  soup.faces.push_back({9});
  soup.faces.push_back({});
  const std::vector<Kernel::Point_3> points = points_of(soup);
  Corner_uvs uvs;
  const SMC::Unwrap_soup_result result = SMC::unwrap_polygon_soup(points, soup.faces, uvs);
  CHECK(result && result.genus == 1 && result.borders == 0, "what is left out leaves no hole");
  CHECK(polygons(result, Kind::DUPLICATE_FACES) == std::vector<std::size_t>({48, 49}), "duplicates");
  CHECK(polygons(result, Kind::DEGENERATE_FACES) == std::vector<std::size_t>({50, 51, 52, 53}), "degenerate");
  CHECK(uvs[49] == uvs[5] && uvs[48][0] == uvs[5][2], "duplicates lie on the former polygon");
  CHECK(uvs[50][0] == uvs[50][2] && uvs[51][0] == uvs[51][1], "one vertex, one UV");
  unwrap("left out", soup);

  // Nothing is left.
  soup.faces = {{0, 1, 0}};
  CHECK(SMC::unwrap_polygon_soup(points, soup.faces, uvs).status.code == SMC::Status_code::EMPTY_MESH, "no surface");
  CHECK(uvs.size() == 54, "without a result, the UVs stay");
  soup.faces = {{0, 1, 2}, {0, 1, 1000}};
  const SMC::Unwrap_soup_result wrong = SMC::unwrap_polygon_soup(points, soup.faces, uvs);
  CHECK(wrong.status.code == SMC::Status_code::WRONG_PARAMETER && wrong.status.faces == std::vector<std::size_t>{1},
        "an index out of range");
}

// A vertex that no polygon uses, a polygon with a hole, and what is no polygon after all.
void test_odd_polygons()
{
  Soup plate;
  plate.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0},
                  {std::nan(""), 0, 0}};
  plate.faces = {{0, 1, 2, 3, 0, 4, 7, 6, 5, 4}};
  const SMC::Unwrap_soup_result whole = unwrap("plate with a hole", plate);
  CHECK(whole.borders == 2 && whole.interpreted.empty(), "a bridge is no border");
  for(int n : {20, 200}) // and a round hole
  {
    Soup round = plate;
    round.points.resize(4);
    round.faces[0] = {0, 1, 2, 3, 0};
    for(int i = 0; i <= n; ++i)
    {
      const double angle = -2 * CGAL_PI * (i % n) / n - 2.3;
      round.faces[0].push_back(4 + std::size_t(i % n));
      if(i < n)
        round.points.push_back({2 + std::cos(angle), 2 + std::sin(angle), 0});
    }
    const SMC::Unwrap_soup_result result = unwrap("plate with a round hole", round);
    CHECK(result.borders == 2 && std::abs(result.average_distortion - 4) < 0.1, "a flat ring");
  }
  plate.points[8] = {9, 0, 0};
  plate.faces = {{0, 1, 2, 0, 3, 8}, {1, 1, 8, 5}, {4, 5, 6, 5}, {4, 5, 4, 7, 4}};
  const std::vector<Kernel::Point_3> points = points_of(plate);
  Corner_uvs uvs;
  const SMC::Unwrap_soup_result result = SMC::unwrap_polygon_soup(points, plate.faces, uvs);
  CHECK(result && polygons(result, Kind::DIVIDED_FACES) == std::vector<std::size_t>({0}), "two loops");
  CHECK(polygons(result, Kind::REPEATED_CORNERS) == std::vector<std::size_t>({1}) && uvs[1][0] == uvs[1][1], "one corner");
  CHECK(polygons(result, Kind::DEGENERATE_FACES) == std::vector<std::size_t>({2, 3}), "there and back");
  CHECK(SMC::certify_unwrapped_polygon_soup(points, plate.faces, uvs), "a certificate");
  uvs[1][1] = Kernel::Point_2(uvs[1][1].x() + 1, uvs[1][1].y());
  CHECK(!SMC::certify_unwrapped_polygon_soup(points, plate.faces, uvs), "a repeated corner elsewhere is torn off");
}

void test_tolerance()
{
  Soup soup = test::without_indices(test::whole_quads(8, 6, true, true));
  CGAL::Random random(1);
  for(std::array<double, 3>& p : soup.points)
    for(double& x : p)
      x += random.get_double(-1e-7, 1e-7);
  const std::vector<Kernel::Point_3> points = points_of(soup);
  Corner_uvs uvs;
  const auto pieces = [&](bool do_weld, double tolerance)
  {
    return SMC::unwrap_polygon_soup(points, soup.faces, uvs,
                                    CGAL::parameters::do_weld_points(do_weld).weld_tolerance(tolerance));
  };
  CHECK(pieces(true, 0).components == 48 && pieces(true, 1e-9).components == 48, "not near enough");
  CHECK(pieces(true, 1e-6).components == 1 && pieces(true, 1e-3).genus == 1, "near enough");
  for(double wrong : {-1., 0.1, std::nan("")})
    CHECK(pieces(true, wrong).status.code == SMC::Status_code::WRONG_PARAMETER, "a wrong tolerance");
  const SMC::Unwrap_soup_result warned = pieces(true, 0);
  CHECK(std::any_of(warned.status.warnings.begin(), warned.status.warnings.end(), [](const auto& warning)
                    { return warning.message.find("weld_tolerance(1e-07)") != std::string::npos; }),
        "a tolerance that helps");
}

void test_welding()
{
  const Soup torus = test::whole_quads(8, 6, true, true);
  const Soup soup = test::without_indices(torus);
  CHECK(unwrap("no indices", soup).components == 48, "each polygon for itself");
  const SMC::Unwrap_soup_result welded = unwrap("welded", soup, true);
  CHECK(welded.components == 1 && welded.genus == 1, "the torus");
  CHECK(count(welded, Kind::WELDED_VERTICES) == soup.points.size() - torus.points.size(), "welded vertices");
}

// Any polygons between few points.
void test_random(CGAL::Random& random)
{
  for(int i = 0; i < 300; ++i)
  {
    Soup soup;
    const int number_of_points = random.get_int(4, 12);
    for(int v = 0; v < number_of_points; ++v)
      soup.points.push_back({random.get_double(), random.get_double(), random.get_double()});
    for(int f = random.get_int(1, 25); f > 0; --f)
    {
      std::vector<std::size_t> vertices(number_of_points);
      std::iota(vertices.begin(), vertices.end(), std::size_t(0));
      CGAL::cpp98::random_shuffle(vertices.begin(), vertices.end(), random);
      Polygon polygon;
      for(int k = random.get_int(3, 5 + i % 4); k > 0 && !vertices.empty(); --k)
      {
        polygon.insert(polygon.end(), random.get_int(0, 5) == 0 ? 2 : 1, vertices.back());
        vertices.pop_back();
      }
      soup.faces.push_back(polygon);
    }
    soup.faces.push_back({0, 1, 2});
    unwrap("random " + std::to_string(i), soup);
  }
}

} // namespace polygon_soups_test

int main()
{
  using namespace polygon_soups_test;
  CGAL::Random random(20261122);
  std::cout << "seed " << random.get_seed() << std::endl;
  test_polygons();
  test_non_manifold();
  test_edge_of_many_sheets();
  test_orientation();
  test_left_out();
  test_odd_polygons();
  test_welding();
  test_tolerance();
  test_random(random);
  return test::exit_status();
}
