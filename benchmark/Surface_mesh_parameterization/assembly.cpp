// Time of assembling energy, gradient and Hessian, and the share of the factorization in a solve,
// on a bumpy grid of about 100,000 triangles.

#include <CGAL/Surface_mesh_parameterization/internal/chart/areas.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/MIPS_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Symmetric_Dirichlet_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/linear_solver_source.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>

#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

using namespace CGAL::Surface_mesh_parameterization::internal;

struct Grid
{
  std::vector<Triangle> triangles;
  std::vector<Eigen::Vector2d> uv;
  std::vector<Rest_shape> shapes;

  explicit Grid(int n)
  {
    std::vector<Eigen::Vector3d> points;
    for(int i = 0; i <= n; ++i)
      for(int j = 0; j <= n; ++j)
      {
        const double x = double(i) / n, y = double(j) / n;
        uv.emplace_back(x, y);
        points.emplace_back(x, y, 0.1 * std::sin(9 * x) * std::cos(7 * y));
      }
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
      {
        const int a = i * (n + 1) + j, b = a + n + 1;
        triangles.push_back({a, b, b + 1});
        triangles.push_back({a, b + 1, a + 1});
      }
    shapes = rest_shapes(triangles, points);
  }
};

// The shortest of some repetitions, in milliseconds of CPU time.
template <typename Function>
double milliseconds(const Function& function)
{
  double best = std::numeric_limits<double>::infinity();
  for(int i = 0; i < 7; ++i)
  {
    const std::clock_t start = std::clock();
    function();
    best = (std::min)(best, 1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

template <typename Energy>
void measure(const char* energy, const char* name, const Linear_solver_source& linear_solvers)
{
  const Grid grid(224);
  const std::vector<double> weights = area_weights(grid.shapes);
  std::vector<char> is_fixed(grid.uv.size(), 0);
  is_fixed[0] = 1;
  Newton_system system(grid.triangles, int(grid.uv.size()), is_fixed);
  const std::unique_ptr<Linear_solver> solver = linear_solvers.make_solver();
  solver->analyze(system.hessian());
  const double assembly = milliseconds([&]
    { system.assemble<Energy>(grid.triangles, grid.shapes, weights, grid.uv, 1e-12); });
  const double factorization = milliseconds([&] { solver->factorize(system.hessian()); });
  const double solution = milliseconds([&] { solver->solve(system.gradient()); });
  std::cout << energy << ',' << name << ',' << grid.triangles.size() << ',' << assembly << ','
            << factorization << ',' << solution << ','
            << factorization / (assembly + factorization + solution) << std::endl;
}

template <typename Solver>
void measure_both(const char* name, const Solver& solver)
{
  const std::shared_ptr<const Linear_solver_source> linear_solvers = make_linear_solver_source(solver);
  measure<MIPS_energy>("MIPS", name, *linear_solvers);
  measure<Symmetric_Dirichlet_energy>("symmetric Dirichlet", name, *linear_solvers);
}

int main()
{
  std::cout << "energy,solver,triangles,assembly_ms,factorization_ms,solution_ms,"
               "share_of_factorization\n";
  measure_both("SimplicialLDLT", CGAL::Default());
#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
  Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Upper> cholmod;
  measure_both("CHOLMOD", std::ref(cholmod));
#endif
}
