// Any solver that a program gives: the same maps as with the built-in one, for all systems, with its settings,
// and with its analysis kept.

#include "../BGL/check.h"
#include "Recording_solver.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/Bijective_symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/Spectral_conformal_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/Scaffold_minimization.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <atomic>
#include <complex>
#include <iostream>
#include <limits>
#include <memory>
#include <set>
#include <type_traits>
#include <vector>

namespace linear_solvers_test {

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

  Map tutte(const Solvers& solvers) const
  {
    Map uv;
    const bool is_mapped = tutte_map(surface.chart, surface.points, surface_area(shapes), solvers, uv);
    CHECK(is_mapped);
    return uv;
  }
  Newton_solver newton(const Solvers& solvers) const
  {
    return Newton_solver(surface.chart.triangles(), surface.chart.number_of_vertices(), solvers);
  }
  Newton_result minimize(Newton_solver& solver, Map& uv, const Newton_options& options) const
  {
    return solver.minimize<Symmetric_Dirichlet_energy>(shapes, weights, uv, options);
  }
  Map isometric(const Solvers& solvers) const
  {
    Map uv = tutte(solvers);
    Newton_options options;
    options.decrement = 1e-12;
    Newton_solver solver = newton(solvers);
    CHECK(minimize(solver, uv, options).is_converged());
    return uv;
  }
  Map spectral(const Solvers& solvers) const
  {
    Map uv;
    const bool is_mapped = spectral_conformal_map(surface.chart, shapes, solvers, uv);
    CHECK(is_mapped);
    return uv;
  }
};

void check_close(const Map& a, const Map& b)
{
  for(std::size_t v = 0; v < a.size(); ++v)
    CHECK((a[v] - b[v]).norm() < 1e-6);
}

template <typename Solver>
void test_solver(const Problem& problem, const Solver& solver)
{
  const Solvers solvers = make_solvers(solver);
  check_close(problem.tutte(solvers), problem.tutte(linear_solvers));
  check_close(problem.isometric(solvers), problem.isometric(linear_solvers));
  check_close(problem.spectral(solvers), problem.spectral(linear_solvers));

  // A matrix that is not positive definite is reported, by a failure or by what the solution is.
  Sparse_matrix matrix(2, 2);
  matrix.insert(0, 0) = 1;
  matrix.insert(0, 1) = 2;
  matrix.insert(1, 1) = 1;
  matrix.makeCompressed();
  const std::unique_ptr<Linear_solver> single = solvers.make();
  single->analyze(matrix);
  const Eigen::Vector2d right(1, -1);
  CHECK(!single->factorize(matrix) || !(right.dot(single->solve(right)) > 0));
}

template <typename Solver>
void test_eigen_solver(const Problem& problem)
{
  test_solver(problem, CGAL::Eigen_solver_traits<Solver>());
}

// Solvers of Eigen with settings: each object has them.
struct Shifted_LDLT : LDLT
{
  Shifted_LDLT() { setShift(3); }
};
struct Negating_LDLT : LDLT // makes every matrix negative definite
{
  Negating_LDLT() { setShift(0, -1); }
};

// What a solver was set up to shows in the solution.
void test_settings()
{
  Sparse_matrix identity(3, 3);
  identity.setIdentity();
  const auto check_shift = [&](const auto& given)
  {
    const std::unique_ptr<Linear_solver> solver = make_solvers(given).make();
    solver->analyze(identity);
    CHECK(solver->factorize(identity));
    CHECK(solver->solve(Eigen::VectorXd::Constant(3, 8)).isApproxToConstant(2));
  };
  check_shift(CGAL::Eigen_solver_traits<Shifted_LDLT>());
  Solver_record record;
  Recording_solver copied(record);
  copied.set_shift(3);
  check_shift(copied);
}

// The solver is asked for each system and each factorization that there is; it analyzes each pattern once. All
// unknowns are counted.
void test_record(const Problem& problem)
{
  Solver_record record;
  std::atomic<long long> unknowns{0};
  Solvers solvers = make_solvers(Recording_solver(record));
  solvers.factorized_unknowns = &unknowns;
  Map uv = problem.tutte(solvers);
  CHECK(record.analyses == 1 && record.factorizations == 1 && unknowns == record.sizes.back());
  problem.spectral(solvers);
  CHECK(record.analyses == 2 && record.factorizations == 2);
  CHECK(record.sizes.back() == 2 * problem.surface.chart.number_of_vertices());

  Newton_solver solver = problem.newton(solvers);
  Newton_options options;
  options.maximum_iterations = 2;
  int iterations = problem.minimize(solver, uv, options).iterations;
  iterations += problem.minimize(solver, uv, options).iterations;
  CHECK(iterations > 2 && record.analyses == 3 && record.factorizations == 2 + iterations);

  CHECK(unknowns == record.sizes[0] + record.sizes[1] + (record.factorizations - 2) * record.sizes[2]);

  const Scaffold_options scaffold_options;
  const int former = record.factorizations;
  const Newton_result scaffold
    = Scaffold_minimization(problem.surface.chart, problem.shapes, solvers, scaffold_options)(uv);
  CHECK(scaffold.iterations > 0 && record.factorizations == former + scaffold.iterations);
}

// Random Hermitian systems against Eigen, small ones and such with supernodes, and whether definite ones are told apart.
template <typename Solver>
void test_unordered_systems(CGAL::Random& random, const Solvers& solvers)
{
  using Scalar = std::conditional_t<std::is_same_v<Solver, Symmetric_solver>, double, std::complex<double> >;
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  for(int i = 0; i < 100; ++i)
  {
    const int size = i % 20 == 0 ? random.get_int(1000, 1500) : random.get_int(1, 60), entries = random.get_int(0, 2 * size);
    const Vector values = Vector::Random(entries), right = Vector::Random(size);
    std::vector<Eigen::Triplet<Scalar> > lower_entries;
    for(int k = 0; k < size; ++k)
      lower_entries.emplace_back(k, k, Scalar(2. * entries + 1)); // dominates
    for(int k = 0; k < entries; ++k)
    {
      const int row = random.get_int(0, size), column = random.get_int(0, size);
      if(row > column)
        lower_entries.emplace_back(row, column, values[k]);
    }
    Matrix lower(size, size);
    lower.setFromTriplets(lower_entries.begin(), lower_entries.end());
    const Eigen::SimplicialLDLT<Matrix> eigen(lower);

    Solver solver(solvers);
    for(double factor : {1., 2.}) // one object serves several systems
    {
      CHECK(solver.factorize(Scalar(factor) * lower));
      const Vector solution = solver.solve(right);
      const Vector product = lower.template selfadjointView<Eigen::Lower>() * solution;
      CHECK((factor * product - right).norm() < 1e-9);
      CHECK((factor * solution - eigen.solve(right)).norm() < 1e-12);
    }
    for(double wrong : {-1., std::numeric_limits<double>::quiet_NaN()})
    {
      Matrix indefinite = lower;
      indefinite.coeffRef(size / 2, size / 2) = wrong;
      CHECK(!solver.factorize(indefinite));
    }
  }
}

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <typename Parameterizer>
SMP::Error_code parameterize(const Parameterizer& parameterizer)
{
  Mesh mesh;
  const bool is_read = CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/nefertiti.off"), mesh);
  CHECK(is_read);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(2)); // several stages
  auto uv_map = mesh.add_property_map<Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Point_2>("v:uv").first;
  return SMP::parameterize(mesh, parameterizer, CGAL::Polygon_mesh_processing::longest_border(mesh).first, uv_map);
}

// A parameterizer takes the solver, its copies keep it.
template <template <typename, typename> class Parameterizer>
void test_parameterizer()
{
  Solver_record record;
  Recording_solver solver(record);
  CHECK(parameterize(Parameterizer<Mesh, Recording_solver>(solver)) == SMP::OK);
  const std::set<int> sizes(record.sizes.begin(), record.sizes.end());
  CHECK(record.analyses > 2 && record.analyses == int(sizes.size())); // every size once
  CHECK(record.factorizations > record.analyses);

  solver.is_broken = true;
  CHECK(parameterize(Parameterizer<Mesh, Recording_solver>(solver)) != SMP::OK);
  CHECK((parameterize(Parameterizer<Mesh, CGAL::Eigen_solver_traits<LDLT> >()) == SMP::OK));
  CHECK((parameterize(Parameterizer<Mesh, CGAL::Eigen_solver_traits<Negating_LDLT> >()) != SMP::OK));
}

} // namespace linear_solvers_test

int main()
{
  using namespace linear_solvers_test;
  CGAL::Random random(7);
  std::cout << "seed " << random.get_seed() << std::endl;
  const Problem problem{make_hills(12, 12, random, true)};
  test_solver(problem, CGAL::Default());
  test_eigen_solver<Lower_LLT>(problem);
  test_eigen_solver<Upper_LLT>(problem);
  test_eigen_solver<LDLT>(problem);
  test_eigen_solver<LU>(problem);
  test_eigen_solver<Row_major_LLT>(problem);
  test_solver(problem, Own_traits());
#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
  test_eigen_solver<Eigen::CholmodSupernodalLLT<Sparse_matrix> >(problem);
#endif
  Solver_record record;
  test_solver(problem, Recording_solver(record));
  test_settings();
  test_record(problem);
  test_unordered_systems<Symmetric_solver>(random, default_solvers());
  test_unordered_systems<Hermitian_solver>(random, default_solvers());
  test_unordered_systems<Hermitian_solver>(random, make_solvers(CGAL::Eigen_solver_traits<LDLT>()));

  test_parameterizer<SMP::MIPS_parameterizer_3>();
  test_parameterizer<SMP::Symmetric_Dirichlet_parameterizer_3>();
  test_parameterizer<SMP::Bijective_symmetric_Dirichlet_parameterizer_3>();
  return test::exit_status();
}
