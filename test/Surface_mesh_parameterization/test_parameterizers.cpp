// The parameterizers through CGAL's function parameterize(), on seam meshes and plain meshes, with
// one border and several, at extreme scales; and what they say to bad input.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_parameterization/Bijective_symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/distortion_measures.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace parameterizers_test {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

template <typename Mesh>
using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
template <typename Mesh>
using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;

using LDLT = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >;
using LLT = Eigen::SimplicialLLT<Eigen::SparseMatrix<double> >;

// Area of the map and of the surface.
template <typename Mesh, typename UVMap>
std::pair<double, double> areas(const Mesh& mesh, UVMap uv_map)
{
  const auto vpm = get(CGAL::vertex_point, mesh);
  double plane = 0, surface = 0;
  for(auto f : faces(mesh))
  {
    const Halfedge<Mesh> h = halfedge(f, mesh);
    const auto u = target(h, mesh), v = target(next(h, mesh), mesh), w = source(h, mesh);
    const double area = CGAL::area(get(uv_map, u), get(uv_map, v), get(uv_map, w));
    CHECK(CGAL::orientation(get(uv_map, u), get(uv_map, v), get(uv_map, w)) == CGAL::LEFT_TURN);
    plane += area;
    surface += std::sqrt(CGAL::squared_area(get(vpm, u), get(vpm, v), get(vpm, w)));
  }
  return {plane, surface};
}

template <typename Mesh, typename UVMap>
void check_map(Mesh& mesh, UVMap uv_map, bool is_isometric)
{
  const std::pair<double, double> a = areas(mesh, uv_map);
  const auto halfedge_uv_map = boost::make_function_property_map<Halfedge<Mesh> >(
    [&](Halfedge<Mesh> h) { return get(uv_map, target(h, mesh)); });
  if(is_isometric)
    CHECK(std::abs(SMP::best_isometric_scale(mesh, halfedge_uv_map) - 1) < 1e-3);
  else
    CHECK(std::abs(a.first - a.second) <= 1e-9 * a.second);
  const double energy = SMP::compute_symmetric_Dirichlet_energy(mesh, halfedge_uv_map,
                                                                boost::dummy_property_map());
  CHECK(energy >= 4 && energy < 20);
}

// Whether no border edge meets another one but at their common vertex.
template <typename Mesh, typename UVMap>
bool is_injective(const Mesh& mesh, UVMap uv_map)
{
  std::vector<Kernel::Segment_2> border;
  for(Halfedge<Mesh> h : halfedges(mesh))
    if(is_border(h, mesh))
      border.emplace_back(get(uv_map, source(h, mesh)), get(uv_map, target(h, mesh)));
  for(std::size_t i = 0; i < border.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(border[i].source() != border[j].target() && border[j].source() != border[i].target()
         && CGAL::do_intersect(border[i], border[j]))
        return false;
  return true;
}

template <template <typename, typename> class Parameterizer, typename Solver, typename Mesh,
          typename UVMap>
void check(Mesh& mesh, Halfedge<Mesh> border, UVMap uv_map, bool is_isometric)
{
  const SMP::Error_code error
    = SMP::parameterize(mesh, Parameterizer<Mesh, Solver>(), border, uv_map);
  CHECK(error == SMP::OK);
  check_map(mesh, uv_map, is_isometric);
}

template <typename Mesh, typename UVMap>
void check_all(Mesh& mesh, UVMap uv_map)
{
  using Default = CGAL::Default;
  using LDLT_traits = CGAL::Eigen_solver_traits<LDLT>;
  using LLT_traits = CGAL::Eigen_solver_traits<LLT>;
  const Halfedge<Mesh> border = PMP::longest_border(mesh).first;
  check<SMP::MIPS_parameterizer_3, Default>(mesh, border, uv_map, false);
  check<SMP::MIPS_parameterizer_3, LDLT_traits>(mesh, border, uv_map, false);
  check<SMP::Symmetric_Dirichlet_parameterizer_3, Default>(mesh, border, uv_map, true);
  check<SMP::Symmetric_Dirichlet_parameterizer_3, LLT_traits>(mesh, border, uv_map, true);
  check<SMP::Bijective_symmetric_Dirichlet_parameterizer_3, Default>(mesh, border, uv_map, true);
  CHECK(is_injective(mesh, uv_map));
  check<SMP::Bijective_symmetric_Dirichlet_parameterizer_3, LLT_traits>(mesh, border, uv_map, true);
  CHECK(is_injective(mesh, uv_map));
}

template <typename Mesh>
Mesh read(const std::string& name)
{
  Mesh mesh;
  const bool is_read = CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh);
  CHECK(is_read);
  return mesh;
}

template <typename Mesh>
void test_plain_mesh(const std::string& name)
{
  Mesh mesh = read<Mesh>(name);
  std::unordered_map<Vertex<Mesh>, Point_2> uvs;
  check_all(mesh, boost::make_assoc_property_map(uvs));
}

// A seam along a walk that goes straight ahead.
template <typename Mesh>
void test_seam_mesh(const std::string& name, int length)
{
  Mesh surface = read<Mesh>(name);
  using Edge = typename boost::graph_traits<Mesh>::edge_descriptor;
  using Edge_map = typename boost::property_map<Mesh, CGAL::dynamic_edge_property_t<bool> >::type;
  using Vertex_map
    = typename boost::property_map<Mesh, CGAL::dynamic_vertex_property_t<bool> >::type;
  using Seam = CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map>;
  Edge_map edge_map = get(CGAL::dynamic_edge_property_t<bool>(), surface);
  Vertex_map vertex_map = get(CGAL::dynamic_vertex_property_t<bool>(), surface);
  for(Edge e : edges(surface))
    put(edge_map, e, false);
  for(Vertex<Mesh> v : vertices(surface))
    put(vertex_map, v, false);
  Seam mesh(surface, edge_map, vertex_map);
  Halfedge<Mesh> h = *halfedges(surface).begin();
  for(int i = 0; i < length; ++i)
  {
    mesh.add_seam(source(h, surface), target(h, surface));
    const std::size_t turns = degree(target(h, surface), surface) / 2;
    h = next(h, surface);
    for(std::size_t turn = 1; turn < turns; ++turn)
      h = next(opposite(h, surface), surface);
  }
  std::unordered_map<Halfedge<Mesh>, Point_2> uvs;
  check_all(mesh, boost::make_assoc_property_map(uvs));
}

// Opened along shortest paths to many vertices, a real surface overlaps itself; and does not if that
// is asked for.
void test_overlapping_seam_mesh()
{
  using Edge = boost::graph_traits<Surface_mesh>::edge_descriptor;
  Surface_mesh surface = read<Surface_mesh>("cow.off");
  auto distance = surface.add_property_map<Vertex<Surface_mesh>, double>("v:distance").first;
  auto former = surface.add_property_map<Vertex<Surface_mesh>, Vertex<Surface_mesh> >("v:former").first;
  const Vertex<Surface_mesh> root = *vertices(surface).begin();
  boost::dijkstra_shortest_paths(surface, root, boost::distance_map(distance).predecessor_map(former));

  auto edge_map = surface.add_property_map<Edge, bool>("e", false).first;
  auto vertex_map = surface.add_property_map<Vertex<Surface_mesh>, bool>("v", false).first;
  using Seam = CGAL::Seam_mesh<Surface_mesh, decltype(edge_map), decltype(vertex_map)>;
  Seam mesh(surface, edge_map, vertex_map);
  for(std::size_t i = 100; i < num_vertices(surface); i += 200)
    for(Vertex<Surface_mesh> v(i); v != root && mesh.add_seam(v, get(former, v)); v = get(former, v))
      continue;

  std::unordered_map<Halfedge<Surface_mesh>, Point_2> uvs;
  const auto uv_map = boost::make_assoc_property_map(uvs);
  const Halfedge<Seam> border = PMP::longest_border(mesh).first;
  check<SMP::Symmetric_Dirichlet_parameterizer_3, CGAL::Default>(mesh, border, uv_map, true);
  CHECK(!is_injective(mesh, uv_map));
  check<SMP::Bijective_symmetric_Dirichlet_parameterizer_3, CGAL::Default>(mesh, border, uv_map, true);
  CHECK(is_injective(mesh, uv_map));
}

template <typename Parameterizer>
SMP::Error_code run(Surface_mesh& mesh, Halfedge<Surface_mesh> bhd)
{
  auto uv_map = mesh.add_property_map<Vertex<Surface_mesh>, Point_2>("v:uv").first;
  auto index_map = get(boost::vertex_index, mesh);
  auto is_parameterized = mesh.add_property_map<Vertex<Surface_mesh>, bool>("v:done").first;
  return Parameterizer().parameterize(mesh, bhd, uv_map, index_map, is_parameterized);
}

SMP::Error_code run(Surface_mesh& mesh, Halfedge<Surface_mesh> bhd)
{
  const SMP::Error_code conformal = run<SMP::MIPS_parameterizer_3<Surface_mesh> >(mesh, bhd);
  const SMP::Error_code isometric
    = run<SMP::Symmetric_Dirichlet_parameterizer_3<Surface_mesh> >(mesh, bhd);
  const SMP::Error_code bijective
    = run<SMP::Bijective_symmetric_Dirichlet_parameterizer_3<Surface_mesh> >(mesh, bhd);
  CHECK(conformal == isometric && conformal == bijective);
  return conformal;
}

SMP::Error_code run(Surface_mesh& mesh)
{
  // The first one: lengths may overflow.
  for(Halfedge<Surface_mesh> h : halfedges(mesh))
    if(is_border(h, mesh))
      return run(mesh, h);
  return SMP::ERROR_EMPTY_MESH;
}

void test_scales()
{
  for(double scale : {1e150, 1e-150, 1e300, 1e-290})
  {
    Surface_mesh mesh = read<Surface_mesh>("nefertiti.off");
    for(Vertex<Surface_mesh> v : vertices(mesh))
      mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    CHECK(run(mesh) == SMP::OK);
    auto uv_map = mesh.add_property_map<Vertex<Surface_mesh>, Point_2>("v:uv").first; // which run() has added
    double extent = 0;
    for(Vertex<Surface_mesh> v : vertices(mesh))
      extent = (std::max)(extent, std::abs(get(uv_map, v).x()));
    CHECK(extent > 0.1 * scale && extent < 10 * scale);
  }
}

// Only the component of the halfedge is touched.
void test_components()
{
  Surface_mesh mesh = read<Surface_mesh>("nefertiti.off");
  const std::size_t n = num_vertices(mesh);
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, 0);
  CGAL::make_tetrahedron(a, b, c, Point_3(0, 0, 1), mesh);
  CGAL::make_quad(a, b, d, c, mesh);
  CHECK(run(mesh) == SMP::OK);
  auto is_parameterized = mesh.add_property_map<Vertex<Surface_mesh>, bool>("v:done").first; // which run() has added
  for(Vertex<Surface_mesh> v : vertices(mesh))
    CHECK(get(is_parameterized, v) == (std::size_t(v) < n));
}

void test_errors()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Point_3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, 0);
  {
    Surface_mesh mesh;
    CHECK(run(mesh, Surface_mesh::null_halfedge()) == SMP::ERROR_EMPTY_MESH);
    CHECK(run(mesh, mesh.add_edge()) == SMP::ERROR_EMPTY_MESH);
  }
  {
    Surface_mesh mesh;
    CGAL::make_quad(a, b, d, c, mesh);
    CHECK(run(mesh) == SMP::ERROR_NON_TRIANGULAR_MESH);
  }
  {
    Surface_mesh mesh;
    CGAL::make_tetrahedron(a, b, c, Point_3(0, 0, 1), mesh);
    CHECK(run(mesh, *halfedges(mesh).begin()) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  }
  {
    Surface_mesh mesh = read<Surface_mesh>("eight.off"); // has handles
    CGAL::Euler::remove_face(*halfedges(mesh).begin(), mesh);
    CHECK(run(mesh) == SMP::ERROR_NO_TOPOLOGICAL_DISC);
  }
  {
    Surface_mesh mesh;
    CGAL::make_triangle(a, b, c, mesh);
    CHECK(run(mesh) == SMP::OK);
    mesh.point(*vertices(mesh).begin()) = Point_3(0, nan, 0);
    CHECK(run(mesh) == SMP::ERROR_WRONG_PARAMETER);
  }
  {
    Surface_mesh mesh; // a point
    CGAL::make_triangle(b, b, b, mesh);
    CHECK(run(mesh) == SMP::ERROR_NO_1_TO_1_MAPPING);
  }
  {
    Surface_mesh mesh; // a needle gets a height
    CGAL::make_triangle(a, b, Point_3(0.5, 0, 0), mesh);
    CHECK(run(mesh) == SMP::OK);
  }
}

// A border of two edges is too short.
void test_short_border()
{
  Surface_mesh surface = read<Surface_mesh>("tetrahedron.off");
  using Edge = boost::graph_traits<Surface_mesh>::edge_descriptor;
  auto edge_map = surface.add_property_map<Edge, bool>("e", false).first;
  auto vertex_map = surface.add_property_map<Vertex<Surface_mesh>, bool>("v", false).first;
  using Seam = CGAL::Seam_mesh<Surface_mesh, decltype(edge_map), decltype(vertex_map)>;
  Seam mesh(surface, edge_map, vertex_map);
  const Halfedge<Surface_mesh> h = *halfedges(surface).begin();
  mesh.add_seam(source(h, surface), target(h, surface));
  std::map<Halfedge<Surface_mesh>, Point_2> uvs;
  const auto uv_map = boost::make_assoc_property_map(uvs);
  const auto index_map = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  const auto is_parameterized = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
  const SMP::Error_code error = SMP::MIPS_parameterizer_3<Seam>().parameterize(
    mesh, Halfedge<Seam>(h, true), uv_map, index_map, is_parameterized);
  CHECK(error == SMP::ERROR_BORDER_TOO_SHORT);
}

// UVs in single precision.
void test_float()
{
  using Float_point = CGAL::Simple_cartesian<float>::Point_2;
  Surface_mesh mesh = read<Surface_mesh>("nefertiti.off");
  auto uv_map = mesh.add_property_map<Vertex<Surface_mesh>, Float_point>("v:uv").first;
  const Halfedge<Surface_mesh> border = PMP::longest_border(mesh).first;
  CHECK(SMP::parameterize(mesh, SMP::MIPS_parameterizer_3<Surface_mesh>(), border, uv_map)
        == SMP::OK);
}

} // namespace parameterizers_test

int main()
{
  using namespace parameterizers_test;
  for(const char* name : {"nefertiti.off", "patch-01.off", "triangular_hole.off"})
  {
    test_plain_mesh<Surface_mesh>(name);
    test_plain_mesh<Polyhedron>(name);
  }
  test_seam_mesh<Surface_mesh>("icosahedron.off", 2);
  test_seam_mesh<Surface_mesh>("sphere.off", 8);
  test_seam_mesh<Polyhedron>("nefertiti.off", 4);
  test_overlapping_seam_mesh();
  test_scales();
  test_components();
  test_errors();
  test_short_border();
  test_float();
  return test::exit_status();
}
