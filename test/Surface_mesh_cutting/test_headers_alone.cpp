// All that the compiled library holds, by the headers alone: each public function of another kind once.

#include "../BGL/check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cutting/certify_packing.h>
#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/certify_unwrapped_polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/connect_points.h>
#include <CGAL/Surface_mesh_cutting/distortion_report.h>
#include <CGAL/Surface_mesh_cutting/pack_charts.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>
#include <CGAL/Surface_mesh_cutting/unwrap_polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/visibility_weights.h>
#include <CGAL/Surface_mesh_parameterization/Bijective_symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/steiner_tree.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace headers_alone_test {

namespace SMC = CGAL::Surface_mesh_cutting;
namespace SMP = CGAL::Surface_mesh_parameterization;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

bool is_near(double a, double b) { return std::abs(a - b) < 1e-9 * std::abs(a); }

Mesh icosahedron()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Kernel::Point_3(0, 0, 0), 1.);
  return mesh;
}

double edge_length(const Mesh& mesh, Mesh::Edge_index e)
{
  const Mesh::Halfedge_index h = mesh.halfedge(e);
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

void test_unwrapping()
{
  Mesh mesh = icosahedron();
  const auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto result = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::do_bijective(true));
  CHECK(result, "unwrap() succeeds");
  CHECK(SMC::certify_unwrap(mesh, is_cut, uv, CGAL::parameters::do_bijective(true)), "its map is valid");
  const double edge = edge_length(mesh, *mesh.edges().begin()), area = 20 * std::sqrt(3.) / 4 * edge * edge;
  CHECK(is_near(SMC::distortion_report(mesh, is_cut, uv).cut_length * std::sqrt(area), result.cut_length),
        "its report tells the same length at an area of 1");
  CHECK(SMC::pack_charts(mesh, is_cut, uv), "pack_charts() succeeds");
  CHECK(SMC::certify_packing(mesh, is_cut, uv), "charts lie in the unit square");
}

void test_polygon_soup()
{
  const std::vector<Kernel::Point_3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::vector<std::size_t> > polygons = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::vector<std::vector<Kernel::Point_2> > uvs;
  CHECK(SMC::unwrap_polygon_soup(points, polygons, uvs), "unwrap_polygon_soup() succeeds");
  CHECK(SMC::certify_unwrapped_polygon_soup(points, polygons, uvs), "its map is valid");
}

void test_trees()
{
  Mesh mesh = icosahedron();
  const auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  const std::vector<Mesh::Vertex_index> all(mesh.vertices().begin(), mesh.vertices().end());
  const double shortest = double(all.size() - 1) * edge_length(mesh, *mesh.edges().begin()); // all edges are as long
  CHECK(is_near(SMC::connect_points(mesh, all, is_cut).length, shortest), "a cut through all points");

  std::vector<Mesh::Edge_index> edges;
  const auto result = CGAL::steiner_tree(mesh, all, std::back_inserter(edges));
  CHECK(result && result.is_optimal && edges.size() == all.size() - 1, "a tree through all vertices");
}

void test_weights()
{
  Mesh mesh = icosahedron();
  const auto weight = mesh.add_property_map<Mesh::Edge_index, double>("e:weight", 0.).first;
  CHECK(SMC::visibility_weights(mesh, weight, CGAL::parameters::number_of_rays(16).smallest_factor(0.1)), "visibility_weights() succeeds");
  for(Mesh::Edge_index e : mesh.edges())
    CHECK(is_near(weight[e], edge_length(mesh, e)), "nothing blocks the view from a convex surface");
}

template <typename Parameterizer>
void test_parameterizer()
{
  Mesh mesh = icosahedron();
  CGAL::Euler::remove_face(*mesh.halfedges().begin(), mesh);
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const Mesh::Halfedge_index border = *mesh.halfedges().begin();
  CHECK(SMP::parameterize(mesh, Parameterizer(), border, uv) == SMP::OK, "parameterize() succeeds");
}

} // namespace headers_alone_test

int main()
{
  using namespace headers_alone_test;
  test_unwrapping();
  test_polygon_soup();
  test_trees();
  test_weights();
  test_parameterizer<SMP::MIPS_parameterizer_3<Mesh> >();
  test_parameterizer<SMP::Bijective_symmetric_Dirichlet_parameterizer_3<Mesh> >();
  return test::exit_status();
}
