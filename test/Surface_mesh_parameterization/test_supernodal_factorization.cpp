// Supernodal factors of random matrices and of grids against Eigen's; the supernodes against a dense elimination;
// the same bits with one thread and with several; the order of elimination of a large graph.

#include "../BGL/check.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>

#include <CGAL/Random.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <iostream>
#include <limits>
#include <vector>

namespace supernodal_factorization_test {

using namespace smp;

using Eigen_solver = Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Upper, Eigen::NaturalOrdering<int> >;

// Both triangles. Diagonally dominant, hence positive definite.
Sparse_matrix random_matrix(int size, int number_of_entries, CGAL::Random& random)
{
  std::vector<Eigen::Triplet<double> > entries;
  for(int i = 0; i < size; ++i)
    entries.emplace_back(i, i, 2. * number_of_entries + 1);
  for(int k = 0; k < number_of_entries; ++k)
  {
    const int i = random.get_int(0, size), j = random.get_int(0, size);
    const double value = random.get_double(-1, 1);
    entries.emplace_back(i, j, value);
    entries.emplace_back(j, i, value);
  }
  Sparse_matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Eigen::VectorXd random_vector(int size, CGAL::Random& random)
{
  Eigen::VectorXd result(size);
  for(double& value : result)
    value = random.get_double(-1, 1);
  return result;
}

// Every entry of the factor has a place in the supernode of its column, and the parent is that of the first row below.
void check_supernodes(const Sparse_matrix& upper)
{
  const Supernodes supernodes(upper);
  const int n = int(upper.cols());
  CHECK(supernodes.number_of_columns() == n);
  Eigen::MatrixXi factor = Eigen::MatrixXi::Zero(n, n); // its pattern, in the order of the supernodes
  for(int j = 0; j < n; ++j)
    for(Sparse_matrix::InnerIterator it(upper, j); it; ++it)
    {
      const int a = supernodes.place(int(it.row())), b = supernodes.place(j);
      factor((std::max)(a, b), (std::min)(a, b)) = 1;
    }
  for(int k = 0; k < n; ++k)
    for(int j = k + 1; j < n; ++j)
      for(int i = j; factor(j, k) && i < n; ++i)
        factor(i, j) |= factor(i, k);
  std::vector<std::vector<int> > rows(supernodes.size()); // from the root down
  int number_of_entries = 0;
  for(int s = supernodes.size() - 1; s >= 0; --s)
  {
    for(int column = supernodes.first_column(s); column < supernodes.first_column(s + 1); ++column)
      rows[s].push_back(column);
    const int parent = supernodes.parent(s);
    CHECK(parent < 0 ? supernodes.number_of_rows_below(s) == 0 : parent > s);
    for(int i = 0; i < supernodes.number_of_rows_below(s); ++i)
      rows[s].push_back(rows[parent][supernodes.rows_in_parent(s)[i]]);
    CHECK(std::is_sorted(rows[s].begin(), rows[s].end()));
    if(parent >= 0)
      CHECK(supernodes.rows_in_parent(s)[0] < supernodes.width(parent));
    const int first = supernodes.first_column(s);
    for(int column = first; column < first + supernodes.width(s); ++column)
      for(int i = column; i < n; ++i)
        CHECK(!factor(i, column) || std::binary_search(rows[s].begin(), rows[s].end(), i));
    supernodes.for_each_entry(s, [&](int row, int column, int entry)
    {
      CHECK(entry >= 0 && entry < upper.nonZeros() && row >= column);
      CHECK(factor(rows[s][row], first + column));
      ++number_of_entries;
    });
  }
  CHECK(number_of_entries == upper.nonZeros());
}

// Each entry becomes a block of two rows and columns.
Sparse_matrix with_pairs(const Sparse_matrix& matrix)
{
  std::vector<Eigen::Triplet<double> > entries;
  for(int j = 0; j < matrix.cols(); ++j)
    for(Sparse_matrix::InnerIterator it(matrix, j); it; ++it)
      for(int k = 0; k < 4; ++k)
      {
        const bool is_off = k == 1 || k == 2; // smaller, so that the diagonal still dominates
        entries.emplace_back(2 * int(it.row()) + k / 2, 2 * j + k % 2, is_off ? 0.25 * it.value() : it.value());
      }
  Sparse_matrix result(2 * matrix.rows(), 2 * matrix.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

void test_random_matrices(CGAL::Random& random)
{
  for(int i = 0; i < 300; ++i)
  {
    const int number_of_nodes = random.get_int(1, 80);
    Sparse_matrix matrix = random_matrix(number_of_nodes, random.get_int(0, 3 * number_of_nodes), random);
    if(random.get_bool())
      matrix = Sparse_matrix(with_pairs(matrix).triangularView<Eigen::Upper>());
    check_supernodes(matrix.triangularView<Eigen::Upper>());
    const Eigen::VectorXd right = random_vector(int(matrix.cols()), random);
    Supernodal_factorization factorization;
    factorization.analyze(matrix);
    for(double factor : {1., 2.}) // the analysis serves more than one matrix
    {
      const bool is_factorized = factorization.factorize(factor * matrix, always_go_further);
      CHECK(is_factorized);
      const Eigen::VectorXd solution = factorization.solve(right);
      const Eigen::VectorXd product = matrix.selfadjointView<Eigen::Upper>() * solution;
      CHECK((factor * product - right).norm() < 1e-9);
      CHECK((factor * solution - Eigen_solver(matrix).solve(right)).norm() < 1e-12);
    }
  }
}

// Systems of Newton steps, large enough for several tasks and tiles.
void test_grid(int size, CGAL::Random& random)
{
  const Test_surface surface = make_hills(size, size, random);
  const std::vector<Rest_shape> shapes = rest_shapes(surface.chart.triangles(), surface.points);
  const std::vector<double> weights(shapes.size(), 1. / double(shapes.size()));
  std::vector<Eigen::Vector2d> uv;
  for(const Eigen::Vector3d& p : surface.points)
    uv.push_back(p.head<2>());
  const auto make_system = [&](Execution execution)
  {
    std::vector<char> is_fixed(uv.size(), 0);
    is_fixed[0] = 1;
    Newton_system system(surface.chart.triangles(), int(uv.size()), is_fixed, execution);
    system.assemble<Symmetric_Dirichlet_energy>(surface.chart.triangles(), shapes, weights, uv, 0);
    return system;
  };
  const Newton_system system = make_system(Execution::SEQUENTIAL);
  const Sparse_matrix& matrix = system.hessian();
  Direct_solver solver(always_go_further, Execution::SEQUENTIAL);
  solver.analyze(matrix);
  CHECK(Direct_solver::is_large(matrix));
  const bool is_factorized = solver.factorize(matrix);
  CHECK(is_factorized);
  const Eigen::VectorXd solution = solver.solve(system.gradient());
  const Eigen::VectorXd expected = Eigen_solver(matrix).solve(system.gradient());
  std::cout << matrix.cols() << " unknowns, relative difference "
            << (solution - expected).norm() / expected.norm() << std::endl;
  CHECK((solution - expected).norm() <= 1e-6 * expected.norm());
  const Eigen::VectorXd product = matrix.selfadjointView<Eigen::Upper>() * solution;
  CHECK((product - system.gradient()).norm() <= 1e-12 * (matrix.norm() * solution.norm() + system.gradient().norm()));
#ifdef CGAL_LINKED_WITH_TBB
  const Newton_system parallel_system = make_system(Execution::PARALLEL);
  CHECK(parallel_system.gradient() == system.gradient());
  CHECK(Eigen::Map<const Eigen::VectorXd>(parallel_system.hessian().valuePtr(), matrix.nonZeros())
        == Eigen::Map<const Eigen::VectorXd>(matrix.valuePtr(), matrix.nonZeros()));
  Direct_solver parallel_solver(always_go_further, Execution::PARALLEL);
  parallel_solver.analyze(matrix);
  for(int repetition = 0; repetition < 3; ++repetition)
  {
    const bool is_factorized_again = parallel_solver.factorize(matrix);
    CHECK(is_factorized_again);
    CHECK(parallel_solver.solve(system.gradient()) == solution);
  }
#endif
}

void test_indefinite(CGAL::Random& random)
{
  for(double wrong : {-1., 0., std::numeric_limits<double>::quiet_NaN()})
  {
    const int size = 60;
    const Sparse_matrix matrix = random_matrix(size, 2 * size, random);
    Sparse_matrix spoiled = matrix;
    const int i = random.get_int(0, size);
    spoiled.coeffRef(i, i) = wrong;
    Supernodal_factorization factorization;
    factorization.analyze(matrix);
    CHECK(!factorization.factorize(spoiled, always_go_further));
    CHECK(factorization.factorize(matrix, always_go_further)); // nothing is left over
    const Eigen::VectorXd right = random_vector(size, random);
    CHECK((matrix * factorization.solve(right) - right).norm() < 1e-9);
  }
}

// Dense, so that it takes many operations.
void test_interruption()
{
  const int size = 1200;
  const Eigen::MatrixXd dense = Eigen::MatrixXd::Ones(size, size) + size * Eigen::MatrixXd::Identity(size, size);
  const Sparse_matrix matrix = dense.sparseView();
  int questions = 0, most = 1000;
  Direct_solver solver([&] { return ++questions <= most; }, Execution::SEQUENTIAL);
  solver.analyze(matrix);
  const bool is_factorized = solver.factorize(matrix);
  CHECK(is_factorized);
  std::cout << questions << " questions" << std::endl;
  CHECK(questions >= 5);
  most = questions / 2;
  questions = 0;
  CHECK(!solver.factorize(matrix));
  CHECK(questions == most + 1);
}

// The pattern of a grid of vertices, diagonals included.
Sparse_matrix grid_graph(int side)
{
  std::vector<Eigen::Triplet<double> > entries;
  const auto add = [&](int i, int j)
  {
    entries.emplace_back(i, j, 1.);
    if(i != j)
      entries.emplace_back(j, i, 1.);
  };
  for(int v = 0; v < side * side; ++v)
  {
    add(v, v);
    if(v % side > 0)
      add(v, v - 1);
    if(v >= side)
      add(v, v - side);
  }
  Sparse_matrix result(side * side, side * side);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

double number_of_entries_of_factor(const Sparse_matrix& graph, const std::vector<int>& order)
{
  std::vector<int> places(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    places[order[i]] = int(i);
  std::vector<Eigen::Triplet<double> > entries;
  for(int j = 0; j < graph.cols(); ++j)
    for(Sparse_matrix::InnerIterator it(graph, j); it; ++it)
      if(places[it.row()] <= places[j])
        entries.emplace_back(places[it.row()], places[j], 1.);
  Sparse_matrix upper(graph.rows(), graph.cols());
  upper.setFromTriplets(entries.begin(), entries.end());
  const Supernodes supernodes(upper);
  double sum = 0;
  for(int s = 0; s < supernodes.size(); ++s)
    sum += supernodes.width(s) * (double(supernodes.height(s)) - 0.5 * (supernodes.width(s) - 1));
  return sum;
}

// METIS dissects large graphs.
void test_order_of_large_graph()
{
#ifdef CGAL_METIS_ENABLED
  const Sparse_matrix graph = grid_graph(450); // more than 200,000 vertices
  const std::vector<int> order = fill_reducing_order(graph), minimum_degree = minimum_degree_order(graph);
  std::vector<char> is_placed(graph.cols(), 0);
  for(int v : order)
  {
    CHECK(v >= 0 && v < graph.cols() && !is_placed[v]);
    is_placed[v] = 1;
  }
  CHECK(int(order.size()) == graph.cols());
  const double entries = number_of_entries_of_factor(graph, order);
  const double entries_by_degree = number_of_entries_of_factor(graph, minimum_degree);
  std::cout << "entries of the factor: " << entries << ", by minimum degree " << entries_by_degree << std::endl;
  CHECK(entries < entries_by_degree);
  CHECK(fill_reducing_order(graph) == order);
  const Sparse_matrix small = grid_graph(100);
  CHECK(fill_reducing_order(small) == minimum_degree_order(small));
#endif
}

} // namespace supernodal_factorization_test

int main()
{
  using namespace supernodal_factorization_test;
  CGAL::Random random;
  std::cout << "seed " << random.get_seed() << std::endl;
  test_random_matrices(random);
  for(int size : {40, 150})
    test_grid(size, random);
  test_indefinite(random);
  test_interruption();
  test_order_of_large_graph();
  return test::exit_status();
}
