#include <CGAL/Surface_mesh_cutting/Result_status.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Result_status = CGAL::Surface_mesh_cutting::Result_status<CGAL::Surface_mesh<Point>>;

int main()
{
  const auto np = CGAL::parameters::random_seed(1).effort(2);
  const int effort = CGAL::parameters::get_parameter(np, CGAL::internal_np::effort);
  return Result_status() && effort == 2 ? EXIT_SUCCESS : EXIT_FAILURE;
}
