// Any solver that a program gives: the same maps as with the built-in one, for all systems, with its settings,
// with its analysis kept, and shared between systems in any order.

#undef NDEBUG
#include "Recording_solver.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/Bijective_symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/Spectral_conformal_map.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cassert>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <thread>
#include <vector>

namespace SMP = CGAL::Surface_mesh_parameterization;
using namespace smp;
using Map = std::vector<Eigen::Vector2d>;
using Lower_LLT = Eigen::SimplicialLLT<Sparse_matrix>;
using Upper_LLT = Eigen::SimplicialLLT<Sparse_matrix, Eigen::Upper, Eigen::NaturalOrdering<int> >;
using LDLT = Eigen::SimplicialLDLT<Sparse_matrix>;
using LU = Eigen::SparseLU<Sparse_matrix>;
using Row_major_LLT = Eigen::SimplicialLLT<Eigen::SparseMatrix<double, Eigen::RowMajor> >;

// A model of CGAL's concept that holds no solver of Eigen.
class Own_traits
{
  using Held = CGAL::Eigen_solver_traits<LDLT>;

public:
  using NT = double;
  using Matrix = Held::Matrix;
  using Vector = Held::Vector;

  bool factor(const Matrix& matrix, NT& determinant) { return m_held.factor(matrix, determinant); }
  bool linear_solver(const Vector& right, Vector& left) { return m_held.linear_solver(right, left); }

private:
  Held m_held;
};

struct Problem
{
  const Test_surface surface;
  const std::vector<Rest_shape> shapes = rest_shapes(surface.chart.triangles(), surface.points);
  const std::vector<double> weights = area_weights(shapes);

  Map tutte(const Linear_solver_source& solvers) const
  {
    Map uv;
    const bool is_mapped = tutte_map(surface.chart, surface.points, surface_area(shapes), solvers, uv);
    assert(is_mapped);
    return uv;
  }
  Newton_solver newton(const Linear_solver_source& solvers) const
  {
    return Newton_solver(surface.chart.triangles(), surface.chart.number_of_vertices(), solvers);
  }
  Newton_result minimize(Newton_solver& solver, Map& uv, const Newton_options& options) const
  {
    return solver.minimize<Symmetric_Dirichlet_energy>(shapes, weights, uv, options);
  }
  Map isometric(const Linear_solver_source& solvers) const
  {
    Map uv = tutte(solvers);
    Newton_options options;
    options.decrement = 1e-12;
    Newton_solver solver = newton(solvers);
    assert(minimize(solver, uv, options).is_converged());
    return uv;
  }
  Map spectral(const Linear_solver_source& solvers) const
  {
    Map uv;
    const bool is_mapped = spectral_conformal_map(surface.chart, shapes, solvers, uv);
    assert(is_mapped);
    return uv;
  }
};

void check_close(const Map& a, const Map& b)
{
  for(std::size_t v = 0; v < a.size(); ++v)
    assert((a[v] - b[v]).norm() < 1e-6);
}

template <typename Solver>
void test_solver(const Problem& problem, const Solver& solver)
{
  const auto solvers = make_linear_solver_source(solver);
  check_close(problem.tutte(*solvers), problem.tutte(linear_solvers));
  check_close(problem.isometric(*solvers), problem.isometric(linear_solvers));
  check_close(problem.spectral(*solvers), problem.spectral(linear_solvers));

  // A matrix that is not positive definite is reported, by a failure or by what the solution is.
  Sparse_matrix matrix(2, 2);
  matrix.insert(0, 0) = 1;
  matrix.insert(0, 1) = 2;
  matrix.insert(1, 1) = 1;
  matrix.makeCompressed();
  const std::unique_ptr<Linear_solver> single = solvers->make_solver();
  single->analyze(matrix);
  const Eigen::Vector2d right(1, -1);
  assert(!single->factorize(matrix) || !(right.dot(single->solve(right)) > 0));
}

// By reference, and as traits whose copies share the solver.
template <typename Solver>
void test_eigen_solver(const Problem& problem)
{
  Solver solver;
  test_solver(problem, std::ref(solver));
  test_solver(problem, CGAL::Eigen_solver_traits<Solver>());
}

// The solver object itself is at work: what was set before shows in the solution.
void test_settings()
{
  Sparse_matrix identity(3, 3);
  identity.setIdentity();
  const auto check_shift = [&](const auto& given)
  {
    const std::unique_ptr<Linear_solver> solver = make_linear_solver_source(given)->make_solver();
    solver->analyze(identity);
    assert(solver->factorize(identity));
    assert(solver->solve(Eigen::VectorXd::Constant(3, 8)).isApproxToConstant(2));
  };
  LDLT solver;
  solver.setShift(3);
  check_shift(std::ref(solver));
  CGAL::Eigen_solver_traits<Lower_LLT> traits;
  traits.solver().setShift(3);
  check_shift(traits);
}

// The solver is asked for each system and each factorization that there is; it analyzes each pattern once.
template <typename Given>
void test_record(const Problem& problem, Solver_record& record, const Given& given)
{
  const auto solvers = make_linear_solver_source(given);
  Map uv = problem.tutte(*solvers);
  assert(record.analyses == 1 && record.factorizations == 1);
  problem.spectral(*solvers);
  assert(record.analyses == 2 && record.factorizations == 2);
  assert(record.sizes.back() == 2 * problem.surface.chart.number_of_vertices());

  Newton_solver solver = problem.newton(*solvers);
  Newton_options options;
  options.maximum_iterations = 2;
  int iterations = problem.minimize(solver, uv, options).iterations;
  iterations += problem.minimize(solver, uv, options).iterations;
  assert(iterations > 2 && record.analyses == 3 && record.factorizations == 2 + iterations);

  const Scaffold_options scaffold_options;
  const int former = record.factorizations;
  const Newton_result scaffold
    = Scaffold_minimization(problem.surface.chart, problem.shapes, *solvers, scaffold_options)(uv);
  assert(scaffold.iterations > 0 && record.factorizations == former + scaffold.iterations);
}

// Systems that share a solver: in turn, one within the other, and in threads of their own.
void test_lending(const Problem& problem)
{
  Lower_LLT llt;
  const auto lent = make_linear_solver_source(std::ref(llt));
  const auto alone = [&]
  {
    Lower_LLT solver;
    return problem.isometric(*make_linear_solver_source(std::ref(solver)));
  }();

  Newton_solver first = problem.newton(*lent), second = problem.newton(*lent);
  Map uv = problem.tutte(*lent), other = uv;
  Newton_options options;
  options.decrement = 1e-12;
  options.maximum_iterations = 1;
  bool is_converged = false;
  while(!is_converged)
  {
    is_converged = problem.minimize(first, uv, options).is_converged();
    problem.minimize(second, other, options);
    assert(uv == other);
  }

  uv = problem.tutte(*lent);
  options = Newton_options();
  options.decrement = 1e-12;
  options.stop = [&](const Newton_state&) { assert(problem.isometric(*lent) == alone); return false; };
  problem.minimize(first, uv, options);
  assert(uv == alone);

  std::vector<Map> maps(4);
  std::vector<std::thread> threads;
  for(Map& map : maps)
    threads.emplace_back([&] { map = problem.isometric(*lent); });
  for(std::thread& thread : threads)
    thread.join();
  for(const Map& map : maps)
    assert(map == alone);
}

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <typename Parameterizer>
SMP::Error_code parameterize(const Parameterizer& parameterizer)
{
  Mesh mesh;
  const bool is_read = CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/nefertiti.off"), mesh);
  assert(is_read);
  auto uv_map = mesh.add_property_map<Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Point_2>("v:uv").first;
  return SMP::parameterize(mesh, parameterizer, CGAL::Polygon_mesh_processing::longest_border(mesh).first, uv_map);
}

// A parameterizer takes the solver, its copies keep it.
template <template <typename, typename> class Parameterizer>
void test_parameterizer()
{
  Solver_record record;
  Recording_solver solver(record);
  assert(parameterize(Parameterizer<Mesh, Recording_solver>(solver)) == SMP::OK);
  const std::set<int> sizes(record.sizes.begin(), record.sizes.end());
  assert(record.analyses > 2 && record.analyses == int(sizes.size())); // every size once
  assert(record.factorizations > record.analyses);

  solver.is_broken = true;
  assert(parameterize(Parameterizer<Mesh, Recording_solver>(solver)) != SMP::OK);
  using Reference = std::reference_wrapper<Recording_solver>;
  const Parameterizer<Mesh, Reference> by_reference{std::ref(solver)};
  assert(parameterize(by_reference) != SMP::OK);
  solver.is_broken = false;
  const int former = record.factorizations;
  assert(parameterize(by_reference) == SMP::OK && record.factorizations > former);

  CGAL::Eigen_solver_traits<LDLT> traits;
  traits.solver().setShift(0, -1); // makes every matrix negative definite
  assert(parameterize(Parameterizer<Mesh, CGAL::Eigen_solver_traits<LDLT> >(traits)) != SMP::OK);
}

int main()
{
  CGAL::Random random(7);
  std::cout << "seed " << random.get_seed() << std::endl;
  const Problem problem{make_hills(12, 12, random, true)};
  test_solver(problem, CGAL::Default());
  test_eigen_solver<Lower_LLT>(problem);
  test_eigen_solver<Upper_LLT>(problem);
  test_eigen_solver<LDLT>(problem);
  test_eigen_solver<LU>(problem);
  Row_major_LLT row_major;
  test_solver(problem, std::ref(row_major));
  test_solver(problem, Own_traits());
#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
  test_eigen_solver<Eigen::CholmodSupernodalLLT<Sparse_matrix> >(problem);
#endif
  Solver_record copies, lent;
  test_solver(problem, Recording_solver(copies));
  test_settings();

  copies.analyses = copies.factorizations = 0;
  test_record(problem, copies, Recording_solver(copies));
  Recording_solver solver(lent);
  test_record(problem, lent, std::ref(solver));
  test_lending(problem);

  test_parameterizer<SMP::MIPS_parameterizer_3>();
  test_parameterizer<SMP::Symmetric_Dirichlet_parameterizer_3>();
  test_parameterizer<SMP::Bijective_symmetric_Dirichlet_parameterizer_3>();
}
