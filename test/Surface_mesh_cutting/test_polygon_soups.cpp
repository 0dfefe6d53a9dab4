// Polygon soups of all kinds are unwrapped: what is said about them is compared with brute force, and the UVs with what
// every map has to satisfy.

#include "checks.h"
#include "polygon_soups.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrapped_polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/unwrap_polygon_soup.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace SMC = CGAL::Surface_mesh_cutting;
using Kernel = CGAL::Simple_cartesian<double>;
using test::Polygon;
using test::Soup;
using test::check;
using Kind = SMC::Interpretation_kind;
using Corner_uvs = std::vector<std::vector<Kernel::Point_2> >;

std::vector<Kernel::Point_3> points_of(const Soup& soup)
{
  std::vector<Kernel::Point_3> points;
  for(const std::array<double, 3>& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

bool is_degenerate(const Polygon& polygon)
{
  return polygon.size() < 3 || std::set<std::size_t>(polygon.begin(), polygon.end()).size() < polygon.size();
}

Polygon from_lowest(Polygon polygon)
{
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  return polygon;
}

// What the definitions say.
struct Brute_force
{
  std::vector<std::size_t> degenerate, duplicates, non_manifold_vertices;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t> > edges; // polygons of the surface at them
  std::set<std::size_t> left_out;

  explicit Brute_force(const Soup& soup)
  {
    std::set<Polygon> former;
    std::map<std::size_t, std::set<std::size_t> > polygons_at;
    for(std::size_t p = 0; p < soup.faces.size(); ++p)
    {
      const Polygon& polygon = soup.faces[p];
      if(is_degenerate(polygon))
        degenerate.push_back(p);
      else if(!former.insert(from_lowest(polygon)).second)
        duplicates.push_back(p);
      else
        for(std::size_t k = 0; k < polygon.size(); ++k)
        {
          edges[std::minmax({polygon[k], polygon[(k + 1) % polygon.size()]})].push_back(p);
          polygons_at[polygon[k]].insert(p);
        }
    }
    left_out.insert(degenerate.begin(), degenerate.end());
    left_out.insert(duplicates.begin(), duplicates.end());
    for(const auto& [v, polygons] : polygons_at)
      if(!hang_together(v, polygons))
        non_manifold_vertices.push_back(v);
  }

  bool hang_together(std::size_t v, const std::set<std::size_t>& polygons) const
  {
    std::set<std::size_t> reached = {*polygons.begin()};
    for(std::size_t size = 0; size < reached.size();)
    {
      size = reached.size();
      for(const auto& [edge, at_edge] : edges)
        if((edge.first == v || edge.second == v) &&
           std::any_of(at_edge.begin(), at_edge.end(), [&](std::size_t p) { return reached.count(p) > 0; }))
          reached.insert(at_edge.begin(), at_edge.end());
    }
    return reached.size() == polygons.size();
  }
};

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
  const Brute_force expected(soup);
  check(polygons(result, Kind::DEGENERATE_FACES) == expected.degenerate, name + ": degenerate faces");
  check(polygons(result, Kind::DUPLICATE_FACES) == expected.duplicates, name + ": duplicate faces");
  const SMC::Interpretation* const vertices = find(result, Kind::NON_MANIFOLD_VERTICES);
  check((vertices == nullptr ? std::vector<std::size_t>() : vertices->vertices) == expected.non_manifold_vertices,
        name + ": non-manifold vertices");
  std::set<std::pair<std::size_t, std::size_t> > many, one_sided;
  for(const auto& [edge, at_edge] : expected.edges)
    if(at_edge.size() > 2)
      many.insert(edge);
  const SMC::Interpretation* const edges = find(result, Kind::NON_MANIFOLD_EDGES);
  check((edges == nullptr ? 0 : edges->edges.size()) == many.size(), name + ": number of non-manifold edges");
  if(edges != nullptr)
    for(const auto& edge : edges->edges)
      check(many.count({edge[0], edge[1]}) == 1, name + ": non-manifold edge");

  // After the turns, neighbors agree except at the edges that are named.
  if(const SMC::Interpretation* const open = find(result, Kind::NON_ORIENTABLE_EDGES))
    for(const auto& edge : open->edges)
      one_sided.insert({edge[0], edge[1]});
  const std::vector<std::size_t> turned = polygons(result, Kind::REORIENTED_FACES);
  for(const auto& [edge, at_edge] : expected.edges)
    if(at_edge.size() == 2)
    {
      int up = 0;
      for(const std::size_t p : at_edge)
      {
        const Polygon& polygon = soup.faces[p];
        const std::size_t k = std::find(polygon.begin(), polygon.end(), edge.first) - polygon.begin();
        const bool is_upward = polygon[(k + 1) % polygon.size()] == edge.second;
        up += is_upward != std::binary_search(turned.begin(), turned.end(), p);
      }
      check((up == 1) != (one_sided.count(edge) == 1), name + ": orientation at an edge");
    }
}

SMC::Unwrap_soup_result unwrap(const std::string& name, const Soup& soup, bool do_weld = false)
{
  const std::vector<Kernel::Point_3> points = points_of(soup);
  Corner_uvs uvs;
  const SMC::Unwrap_soup_result result
    = SMC::unwrap_polygon_soup(points, soup.faces, uvs, CGAL::parameters::do_weld_points(do_weld));
  check(bool(result), name + ": " + result.status.message);
  if(!result.has_result)
    return result;
  const SMC::Status<SMC::Polygon_soup> certificate
    = SMC::certify_unwrapped_polygon_soup(points, soup.faces, uvs, CGAL::parameters::do_weld_points(do_weld));
  check(bool(certificate), name + ": certificate: " + certificate.message);
  if(!do_weld)
    check_findings(name, soup, result);

  check(uvs.size() == soup.faces.size(), name + ": number of polygons");
  const std::vector<std::size_t> turned = polygons(result, Kind::REORIENTED_FACES);
  std::set<std::size_t> left_out;
  for(Kind kind : {Kind::DEGENERATE_FACES, Kind::DUPLICATE_FACES})
    for(std::size_t p : polygons(result, kind))
      left_out.insert(p);
  for(std::size_t p = 0; p < uvs.size(); ++p)
  {
    check(uvs[p].size() == soup.faces[p].size(), name + ": number of corners");
    for(const Kernel::Point_2& uv : uvs[p])
      check(std::isfinite(uv.x()) && std::isfinite(uv.y()), name + ": finite UVs");
    const double sign = std::binary_search(turned.begin(), turned.end(), p) ? -1 : 1;
    if(left_out.count(p) == 0)
      check(sign * signed_area(uvs[p]) > 0, name + ": a polygon is clockwise");
  }
  return result;
}

void test_polygons()
{
  check(unwrap("flat squares", test::whole_quads(4, 3, false, false)).cut_length == 0, "a disk needs no cut");
  check(unwrap("torus", test::whole_quads(8, 6, true, true)).genus == 1, "genus of the torus");
  check(unwrap("tube", test::whole_quads(8, 3, true, false)).borders == 2, "borders of the tube");
  for(int n : {3, 10, 40})
  {
    const SMC::Unwrap_soup_result star = unwrap("star of " + std::to_string(n), test::star_prism(n));
    check(star.genus == 0 && star.components == 1 && star.interpreted.empty(), "a star is a sphere");
  }
  for(const Soup& soup : {test::whole_quads(4, 3, false, false), test::whole_quads(5, 4, true, true), test::sphere(5, 3), test::star_prism(5)})
    unwrap("midpoints", test::with_midpoints(soup));

  // A flat concave polygon is mapped onto itself.
  Soup concave;
  concave.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0.1, 0}, {0, 4, 0}};
  concave.faces = {{0, 1, 2, 3, 4}};
  check(std::abs(unwrap("concave", concave).average_distortion - 4) < 1e-6, "a flat polygon has no distortion");

  // A pillow of two squares, one of which needs the other diagonal.
  Soup pillow = concave;
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  pillow.faces = {{0, 1, 2, 3}, {3, 2, 1, 0}};
  check(unwrap("pillow", pillow).genus == 0, "a pillow is a sphere");
}

void test_non_manifold()
{
  for(int k : {3, 4, 7, 20})
  {
    const SMC::Unwrap_soup_result result = unwrap("book", test::book(k, 3));
    check(result.components == (k + 1) / 2, "pairs of sheets stay connected");
    check(count(result, Kind::NON_MANIFOLD_EDGES) == 3, "edges of a book");
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
    check(result.components == 2 && result.borders == 0 && result.genus == 0, "two closed tetrahedra");
  }
  Soup two_sided;
  two_sided.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  two_sided.faces = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
  unwrap("two-sided square", two_sided);
}

void test_orientation()
{
  for(int n : {3, 5, 20})
  {
    const SMC::Unwrap_soup_result result = unwrap("Moebius strip", test::moebius_strip(n));
    check(count(result, Kind::NON_ORIENTABLE_EDGES) > 0, "a Moebius strip is opened");
  }
  Soup soup = test::whole_quads(8, 6, true, true);
  for(std::size_t f : {3, 17, 30})
    std::reverse(soup.faces[f].begin(), soup.faces[f].end());
  check(polygons(unwrap("three turned", soup), Kind::REORIENTED_FACES) == std::vector<std::size_t>({3, 17, 30}),
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
  check(bool(result) && result.genus == 1 && result.borders == 0, "what is left out leaves no hole");
  check(polygons(result, Kind::DUPLICATE_FACES) == std::vector<std::size_t>({48, 49}), "duplicates");
  check(polygons(result, Kind::DEGENERATE_FACES) == std::vector<std::size_t>({50, 51, 52, 53}), "degenerate");
  check(uvs[49] == uvs[5] && uvs[48][0] == uvs[5][2], "duplicates lie on the former polygon");
  check(uvs[50][0] == uvs[50][2] && uvs[51][0] == uvs[51][1], "one vertex, one UV");
  unwrap("left out", soup);

  // Nothing is left.
  soup.faces = {{0, 1, 0}};
  check(SMC::unwrap_polygon_soup(points, soup.faces, uvs).status.code == SMC::Status_code::EMPTY_MESH, "no surface");
  check(uvs.size() == 54, "without a result, the UVs stay");
  soup.faces = {{0, 1, 2}, {0, 1, 1000}};
  const SMC::Unwrap_soup_result wrong = SMC::unwrap_polygon_soup(points, soup.faces, uvs);
  check(wrong.status.code == SMC::Status_code::WRONG_PARAMETER && wrong.status.faces == std::vector<std::size_t>{1},
        "an index out of range");
}

void test_welding()
{
  const Soup torus = test::whole_quads(8, 6, true, true);
  const Soup soup = test::without_indices(torus);
  check(unwrap("no indices", soup).components == 48, "each polygon for itself");
  const SMC::Unwrap_soup_result welded = unwrap("welded", soup, true);
  check(welded.components == 1 && welded.genus == 1, "the torus");
  check(count(welded, Kind::WELDED_VERTICES) == soup.points.size() - torus.points.size(), "welded vertices");
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
      Polygon polygon;
      for(int k = random.get_int(3, 5 + i % 4); k > 0; --k)
        polygon.push_back(std::size_t(random.get_int(0, number_of_points)));
      soup.faces.push_back(polygon);
    }
    soup.faces.push_back({0, 1, 2});
    unwrap("random " + std::to_string(i), soup);
  }
}

int main()
{
  CGAL::Random random(20261122);
  std::cout << "seed " << random.get_seed() << std::endl;
  test_polygons();
  test_non_manifold();
  test_orientation();
  test_left_out();
  test_welding();
  test_random(random);
  return test::exit_status();
}
