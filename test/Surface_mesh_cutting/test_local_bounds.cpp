// Bounds on the distortion of faces and charts: kept by what is written, the same for all functions, and refused if they are none.

#include "../BGL/check.h"
#include "surface_meshes.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>
#include <CGAL/Surface_mesh_parameterization/distortion_measures.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace local_bounds_test {

namespace SMC = CGAL::Surface_mesh_cutting;
namespace SMP = CGAL::Surface_mesh_parameterization;
namespace parameters = CGAL::parameters;
using SMC::Status_code;
using Mesh = test::Surface_mesh;

double largest_energy(const Mesh& mesh, Mesh::Property_map<Mesh::Halfedge_index, test::Point_2> uv)
{
  std::vector<double> energies(mesh.number_of_faces());
  SMP::compute_symmetric_Dirichlet_energy(
    mesh, uv, boost::make_iterator_property_map(energies.begin(), get(boost::face_index, mesh)));
  return *std::max_element(energies.begin(), energies.end());
}

template <typename NamedParameters>
void test_bound(Mesh& mesh, const std::string& name, double bound, const NamedParameters& np)
{
  const auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("", false).first;
  const auto is_cut_alone = mesh.add_property_map<Mesh::Edge_index, bool>("", false).first;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, test::Point_2>("").first;
  const auto result = SMC::unwrap(mesh, is_cut, uv, np);
  CHECK(result && SMC::certify_unwrap(mesh, is_cut, uv), name + ": " + result.status.message);
  CHECK(largest_energy(mesh, uv) <= bound * (1 + 1e-12), name + ": what was written keeps the bound");
  CHECK(result.distortion_quantiles.back()[1] == result.largest_face_distortion, name + ": the last quantile is the largest");
  CHECK(std::is_sorted(result.distortion_quantiles.begin(), result.distortion_quantiles.end()), name + ": quantiles grow");
  const auto alone = SMC::greedy_cut(mesh, is_cut_alone, np);
  CHECK(alone && alone.cut_length == result.cut_length, name + ": the cut alone is the same");
  for(const Mesh::Edge_index e : mesh.edges())
    CHECK(is_cut[e] == is_cut_alone[e], name + ": edges of the cut alone");
}

void test_bounds()
{
  Mesh mesh = test::make_mesh<Mesh>(test::sphere(24, 12));
  for(const bool do_bijective : {false, true})
  {
    const std::string kind = do_bijective ? " without overlaps" : " with overlaps";
    test_bound(mesh, "faces" + kind, 5, parameters::maximum_face_distortion(5.).do_bijective(do_bijective));
    test_bound(mesh, "faces and mean" + kind, 6,
               parameters::maximum_face_distortion(6.).maximum_average_distortion(4.1).do_bijective(do_bijective));
  }
}

void test_values()
{
  Mesh mesh = test::make_mesh<Mesh>(test::sphere(8, 6));
  const auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("", false).first;
  const auto code = [&](const auto& np) { return SMC::greedy_cut(mesh, is_cut, np).status.code; };
  for(const double bound : {4., 0., -1., std::numeric_limits<double>::quiet_NaN()})
  {
    CHECK(code(parameters::maximum_face_distortion(bound)) == Status_code::WRONG_PARAMETER, "no bound on faces");
    CHECK(code(parameters::maximum_chart_distortion(bound)) == Status_code::WRONG_PARAMETER, "no bound on charts");
  }
  for(const double share : {0., -1., 1.01, std::numeric_limits<double>::quiet_NaN()})
    CHECK(code(parameters::face_distortion_quantile(share)) == Status_code::WRONG_PARAMETER, "no share");
}

} // namespace local_bounds_test

int main()
{
  local_bounds_test::test_bounds();
  local_bounds_test::test_values();
  return test::exit_status();
}
