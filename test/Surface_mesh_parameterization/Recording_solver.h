#ifndef TEST_RECORDING_SOLVER_H
#define TEST_RECORDING_SOLVER_H

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <memory>
#include <mutex>
#include <vector>

// What a solver and its copies were asked for.
struct Solver_record
{
  std::mutex mutex;
  int analyses = 0, factorizations = 0;
  std::vector<int> sizes; // of the systems, one per analysis
};

// A program's own solver with the interface of Eigen's, which takes full matrices and can be copied.
class Recording_solver
{
  using Matrix = Eigen::SparseMatrix<double>;

public:
  explicit Recording_solver(Solver_record& record) : m_record(&record) {}
  Recording_solver(const Recording_solver& other) : is_broken(other.is_broken), m_record(other.m_record)
  {
    set_shift(other.m_shift);
  }

  void set_shift(double shift)
  {
    m_shift = shift;
    m_solver.setShift(shift);
  }

  void analyzePattern(const Matrix& matrix)
  {
    const std::lock_guard<std::mutex> lock(m_record->mutex);
    ++m_record->analyses;
    m_record->sizes.push_back(int(matrix.rows()));
    m_solver.analyzePattern(matrix);
  }
  void factorize(const Matrix& matrix)
  {
    const std::lock_guard<std::mutex> lock(m_record->mutex);
    ++m_record->factorizations;
    const Matrix transposed = matrix.transpose();
    m_is_symmetric = (matrix - transposed).norm() == 0;
    m_solver.factorize(matrix);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return m_solver.solve(right); }
  Eigen::ComputationInfo info() const
  { return is_broken || !m_is_symmetric ? Eigen::NumericalIssue : m_solver.info(); }

  bool is_broken = false;

private:
  Solver_record* m_record;
  bool m_is_symmetric = true;
  double m_shift = 0;
  Eigen::SimplicialLLT<Matrix> m_solver;
};

#endif // TEST_RECORDING_SOLVER_H
