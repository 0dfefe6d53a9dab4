// Factors of random Hermitian matrices against Eigen's, and that a factorization asks whether to go on.

#undef NDEBUG
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Simplicial_solver.h>

#include <CGAL/Random.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <cassert>
#include <complex>
#include <iostream>
#include <type_traits>
#include <vector>

namespace smp = CGAL::Surface_mesh_parameterization::internal;

template <typename Scalar>
Scalar random_scalar(CGAL::Random& random)
{
  const double real = random.get_double(-1, 1);
  if constexpr(std::is_same<Scalar, double>::value)
    return real;
  else
    return Scalar(real, random.get_double(-1, 1));
}

// Both triangles. Diagonally dominant, hence positive definite.
template <typename Scalar>
Eigen::SparseMatrix<Scalar> random_matrix(int size, int number_of_entries, CGAL::Random& random)
{
  std::vector<Eigen::Triplet<Scalar> > entries;
  for(int i = 0; i < size; ++i)
    entries.emplace_back(i, i, Scalar(2. * number_of_entries + 1));
  for(int k = 0; k < number_of_entries; ++k)
  {
    const int i = random.get_int(0, size), j = random.get_int(0, size);
    if(i == j)
      continue;
    const Scalar value = random_scalar<Scalar>(random);
    entries.emplace_back(i, j, value);
    entries.emplace_back(j, i, Eigen::numext::conj(value));
  }
  Eigen::SparseMatrix<Scalar> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template <typename Scalar>
void test_against_eigen(CGAL::Random& random)
{
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  for(int i = 0; i < 200; ++i)
  {
    const int size = random.get_int(1, 60);
    const Matrix matrix = random_matrix<Scalar>(size, random.get_int(0, 4 * size), random);
    Vector right(size);
    for(int k = 0; k < size; ++k)
      right[k] = random_scalar<Scalar>(random);

    smp::Simplicial_factorization<Scalar> factorization;
    factorization.analyze(matrix);
    Vector solution;
    for(int repetition = 0; repetition < 2; ++repetition) // the analysis serves more than one matrix
    {
      const bool is_factorized = factorization.factorize(Matrix(Scalar(repetition + 1.) * matrix), smp::always_go_further);
      assert(is_factorized);
      solution = right;
      factorization.solve(solution);
      assert((Scalar(repetition + 1.) * (matrix * solution) - right).norm() < 1e-9);
    }

    const Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int> > eigen(matrix);
    assert((Scalar(2.) * solution - eigen.solve(right)).norm() < 1e-12);

    smp::Simplicial_unordered_solver<Scalar> unordered(smp::always_go_further);
    const Matrix lower = matrix.template triangularView<Eigen::Lower>();
    const bool is_factorized = unordered.factorize(lower);
    assert(is_factorized);
    assert((matrix * unordered.solve(right) - right).norm() < 1e-9);
  }
}

void test_indefinite()
{
  Eigen::MatrixXd dense(2, 2);
  dense << 1, 2, 2, 1;
  smp::Simplicial_factorization<double> factorization;
  factorization.analyze(dense.sparseView());
  assert(!factorization.factorize(dense.sparseView(), smp::always_go_further));
}

// Dense, so that it takes many operations.
void test_interruption()
{
  const int size = 1000;
  const Eigen::MatrixXd dense = Eigen::MatrixXd::Ones(size, size) + size * Eigen::MatrixXd::Identity(size, size);
  const smp::Sparse_matrix matrix = dense.sparseView();
  int questions = 0, most = 1000;
  smp::Simplicial_solver solver([&] { return ++questions <= most; });
  solver.analyze(matrix);
  assert(solver.factorize(matrix));
  std::cout << questions << " questions" << std::endl;
  assert(questions >= 5);
  const int needed = questions;
  questions = 0;
  most = needed / 2;
  assert(!solver.factorize(matrix));
  assert(questions == most + 1);
}

int main()
{
  CGAL::Random random;
  std::cout << "seed " << random.get_seed() << std::endl;
  test_against_eigen<double>(random);
  test_against_eigen<std::complex<double> >(random);
  test_indefinite();
  test_interruption();
}
