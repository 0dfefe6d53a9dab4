// What the cut costs is what the whole method minimizes: on surfaces with an expensive side, at full resolution
// and with a coarser version. Costs are summed up from the cut itself.

#include "../BGL/check.h"
#include "surface_meshes.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <cmath>
#include <limits>
#include <string>

namespace weighted_cuts_test {

namespace SMC = CGAL::Surface_mesh_cutting;
namespace PMP = CGAL::Polygon_mesh_processing;
using Mesh = test::Surface_mesh;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A surface whose edges cost a multiple of their length.
struct Surface
{
  Mesh mesh = test::make_mesh<Mesh>(test::bumpy_sphere(24));
  Mesh::Property_map<Mesh::Edge_index, double> weight = mesh.add_property_map<Mesh::Edge_index, double>("e:weight").first;
  Mesh::Property_map<Mesh::Edge_index, bool> is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut").first;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;

  // `factor(midpoint)` times the length
  template <typename Factor>
  explicit Surface(Factor factor)
  {
    for(const auto e : mesh.edges())
      weight[e] = PMP::edge_length(mesh.halfedge(e), mesh) *
                  factor(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  }

  double cost() const
  {
    double sum = 0;
    for(const auto e : mesh.edges())
      if(is_cut[e])
        sum += weight[e];
    return sum;
  }

  bool has_same_cut(const Surface& other) const
  {
    return std::equal(mesh.edges().begin(), mesh.edges().end(), other.mesh.edges().begin(),
                      [&](auto e, auto f) { return is_cut[e] == other.is_cut[f]; });
  }

  template <typename NamedParameters>
  auto unwrap(const NamedParameters& np, const std::string& what)
  {
    const auto result = SMC::unwrap(mesh, is_cut, uv, np);
    CHECK(result && SMC::certify_unwrap(mesh, is_cut, uv), what);
    return result;
  }

  auto unwrap_by_cost(int coarse_number_of_faces)
  {
    const std::string what = "weighted, " + std::to_string(coarse_number_of_faces) + " coarse faces";
    const auto result = unwrap(CGAL::parameters::edge_weight_map(weight).coarse_number_of_faces(coarse_number_of_faces), what);
    CHECK(std::abs(result.cut_cost - cost()) <= 1e-9 * cost(), "cost of the cut: " + what);
    for(const SMC::Trade_off& t : result.trade_offs)
      CHECK(t.cut_cost >= result.cut_cost * (1 - 1e-9) || t.average_distortion >= result.average_distortion - 0.05,
            "no trade-off is far better than the result: " + what);
    return result;
  }
};

constexpr int no_coarser_version = 0, coarser_version = 1200;

double expensive_in_front(const Mesh::Point& p) { return p.y() > 0 ? 10 : 1; }

void test_expensive_side(int coarse_number_of_faces)
{
  Surface plain(expensive_in_front), weighted(expensive_in_front);
  const auto by_length
    = plain.unwrap(CGAL::parameters::coarse_number_of_faces(coarse_number_of_faces), "by length");
  CHECK(by_length.cut_cost == by_length.cut_length, "without weights, cost is length");
  const auto by_cost = weighted.unwrap_by_cost(coarse_number_of_faces);
  CHECK(by_cost.cut_cost < 0.65 * plain.cost(), "the cut avoids what is expensive");
  CHECK(by_cost.average_distortion < by_length.average_distortion + 0.1,
        "about the same distortion: " + std::to_string(by_cost.average_distortion) + " and " +
        std::to_string(by_length.average_distortion));
}

// Only the ratios of weights matter.
void test_unit_of_weights()
{
  Surface plain(expensive_in_front), uniform([](const Mesh::Point&) { return 3; });
  const auto by_length = plain.unwrap(CGAL::parameters::all_default(), "by length");
  const auto by_uniform_cost = uniform.unwrap(CGAL::parameters::edge_weight_map(uniform.weight), "uniform weights");
  CHECK(plain.has_same_cut(uniform), "uniform weights change nothing");
  CHECK(std::abs(by_uniform_cost.cut_cost - 3 * by_length.cut_length) <= 1e-9 * by_uniform_cost.cut_cost, "their cost");

  Surface small(expensive_in_front), large([](const Mesh::Point& p) { return 1024 * expensive_in_front(p); });
  small.unwrap_by_cost(no_coarser_version);
  large.unwrap_by_cost(no_coarser_version);
  CHECK(small.has_same_cut(large), "the unit of the weights does not matter");
}

// The end of the bumpy sphere where a cut would end.
bool is_in_cap(const Mesh::Point& p) { return p.z() > 1; }

void test_forbidden_cap(int coarse_number_of_faces)
{
  const auto has_edge_in_cap = [](const Surface& surface)
  {
    bool result = false;
    for(const auto e : surface.mesh.edges())
      result = result || (surface.is_cut[e] && is_in_cap(CGAL::midpoint(surface.mesh.point(surface.mesh.vertex(e, 0)),
                                                                         surface.mesh.point(surface.mesh.vertex(e, 1)))));
    return result;
  };
  Surface free([](const Mesh::Point&) { return 1; });
  Surface forbidden([](const Mesh::Point& p) { return is_in_cap(p) ? infinity : 1; });
  free.unwrap_by_cost(coarse_number_of_faces);
  CHECK(has_edge_in_cap(free), "the cap would be cut");
  forbidden.unwrap_by_cost(coarse_number_of_faces);
  CHECK(!has_edge_in_cap(forbidden), "the cap stays whole");
}

void test_threads()
{
  Surface one(expensive_in_front), several(expensive_in_front);
  one.unwrap_by_cost(coarser_version);
  const auto np = CGAL::parameters::edge_weight_map(several.weight).coarse_number_of_faces(coarser_version);
  CHECK(SMC::unwrap<CGAL::Parallel_if_available_tag>(several.mesh, several.is_cut, several.uv, np), "several threads");
  CHECK(one.has_same_cut(several), "the same cut for any number of threads");
}

} // namespace weighted_cuts_test

int main()
{
  using namespace weighted_cuts_test;
  for(const int coarse_number_of_faces : {no_coarser_version, coarser_version})
  {
    test_expensive_side(coarse_number_of_faces);
    test_forbidden_cap(coarse_number_of_faces);
  }
  test_unit_of_weights();
  test_threads();
  return test::exit_status();
}
