// Time of assembling energy, gradient and Hessian, and the share of the factorization in a solve, as CSV:
//   assembly [RESULT.obj]
// The map is that of an unwrapped mesh of triangles, whose last system this is, or of a bumpy grid of about 100,000.

#include "Layout.h"

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

using namespace CGAL::Surface_mesh_parameterization::internal;

Layout bumpy_grid(int n)
{
  Layout grid;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
    {
      const double x = double(i) / n, y = double(j) / n;
      grid.uv.emplace_back(x, y);
      grid.points.emplace_back(x, y, 0.1 * std::sin(9 * x) * std::cos(7 * y));
    }
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const int a = i * (n + 1) + j, b = a + n + 1;
      grid.triangles.push_back({a, b, b + 1});
      grid.triangles.push_back({a, b + 1, a + 1});
    }
  return grid;
}

// The shortest of some repetitions, in milliseconds of CPU time; of one, if that takes seconds.
template <typename Function>
double milliseconds(const Function& function)
{
  constexpr int repetitions = 7;
  constexpr double enough = 2000;
  double best = std::numeric_limits<double>::infinity(), sum = 0;
  for(int i = 0; i < repetitions && sum < enough; ++i)
  {
    const std::clock_t start = std::clock();
    function();
    const double time = 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC;
    best = (std::min)(best, time);
    sum += time;
  }
  return best;
}

template <typename Energy>
void measure(const char* energy, const char* name, const Solvers& linear_solvers, const Layout& layout)
{
  const std::vector<Rest_shape> shapes = rest_shapes(layout.triangles, layout.points);
  const std::vector<double> weights = area_weights(shapes);
  std::vector<char> is_fixed(layout.uv.size(), 0);
  is_fixed[0] = 1;
  Newton_system system(layout.triangles, int(layout.uv.size()), is_fixed);
  const std::unique_ptr<Linear_solver> solver = linear_solvers.make();
  solver->analyze(system.hessian());
  const double assembly = milliseconds([&]
    { system.assemble<Energy>(layout.triangles, shapes, weights, layout.uv, 1e-12); });
  const double factorization = milliseconds([&] { solver->factorize(system.hessian()); });
  const double solution = milliseconds([&] { solver->solve(system.gradient()); });
  std::cout << energy << ',' << name << ',' << layout.triangles.size() << ',' << assembly << ','
            << factorization << ',' << solution << ','
            << factorization / (assembly + factorization + solution) << std::endl;
}

template <typename Energy>
void measure_all(const char* energy, const Layout& layout)
{
  measure<Energy>(energy, "supernodal", default_solvers(), layout);
  using Simplicial = Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Upper>;
  measure<Energy>(energy, "SimplicialLDLT", make_solvers(CGAL::Eigen_solver_traits<Simplicial>()), layout);
}

int main(int argc, char** argv)
{
  std::cout << "energy,solver,triangles,assembly_ms,factorization_ms,solution_ms,"
               "share_of_factorization\n";
  const Layout layout = argc > 1 ? read_layout(argv[1]) : bumpy_grid(224);
  if(argc == 1)
    measure_all<MIPS_energy>("MIPS", layout);
  measure_all<Symmetric_Dirichlet_energy>("symmetric Dirichlet", layout);
}
