// Surfaces that can hardly be mapped: a run ends after a bounded number of steps, whether it finds a map or not.

#include "../BGL/check.h"
#include "surface_meshes.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace budgets_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Status_code;
using Mesh = test::Surface_mesh;

// Counts steps, and ends what takes too many.
struct Counting_visitor : public SMC::Default_visitor
{
  const long most;
  long calls = 0;

  explicit Counting_visitor(long limit) : most(limit) {}
  bool go_further() { return ++calls <= most; }
};

// With coordinates on a grid of so many cells along the diagonal: most faces become needles, caps, or points, and
// many lie on each other.
Mesh rounded_mesh(const std::string& name, int number_of_cells)
{
  Mesh mesh;
  CHECK(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh), name + " is there");
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double cell = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin())
                    / number_of_cells;
  const auto rounded = [cell](double x) { return cell * std::round(x / cell); };
  for(auto v : vertices(mesh))
    mesh.point(v) = {rounded(mesh.point(v).x()), rounded(mesh.point(v).y()), rounded(mesh.point(v).z())};
  return mesh;
}

void test_rounded(const std::string& name, int number_of_cells, long most_calls)
{
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  Mesh mesh = rounded_mesh(name, number_of_cells);
  auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut").first;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  Counting_visitor visitor(most_calls);
  const auto result = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::visitor(std::ref(visitor)));
  std::cout << name << " on " << number_of_cells << " cells: " << visitor.calls << " steps, status "
            << int(result.status.code) << std::endl;
  CHECK(result.status.code == Status_code::OK, name + ": " + result.status.message);
  CHECK(SMC::certify_unwrap(mesh, is_cut, uv), name + ": certificate");
}

} // namespace budgets_test

int main()
{
  using namespace budgets_test;
  // A search that finds a cut through 240 points and refines it takes 165,000 steps.
  test_rounded("blobby.off", 30, 250000);
  // Starts through needles, half of which lead nowhere, take 25,000.
  test_rounded("camel.off", 100, 30000);
  return test::exit_status();
}
