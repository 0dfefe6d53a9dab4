// The named parameter `sparse_linear_solver`: what is given solves the systems, its analysis is kept, its failure is
// reported, and it gives the same for every number of threads.

#include "../BGL/check.h"
#include "surface_meshes.h"
#include "../Surface_mesh_parameterization/Recording_solver.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/detect_feature_points.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cmath>
#include <iostream>
#include <iterator>
#include <vector>

namespace sparse_linear_solver_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Status_code;
using test::Surface_mesh;
using Matrix = Eigen::SparseMatrix<double>;
using LLT = Eigen::SimplicialLLT<Matrix>;

// A sphere that is hard to flatten: with three arms.
test::Soup star(int n)
{
  test::Soup soup = test::sphere(2 * n, n);
  for(std::array<double, 3>& p : soup.points)
  {
    const double polar = CGAL_PI * (p[2] + 1) / (n + 2), around = std::atan2(p[1], p[0]);
    const double radius = 1 + 0.6 * std::sin(polar) * std::cos(3 * around);
    p = {radius * std::sin(polar) * std::cos(around), radius * std::sin(polar) * std::sin(around), std::cos(polar)};
  }
  return soup;
}

struct Run
{
  SMC::Unwrap_result<Surface_mesh> result;
  bool is_certified = false;
  std::vector<double> values; // cut and UVs
};

template <typename NamedParameters>
Run unwrap(Surface_mesh mesh, const NamedParameters& np)
{
  const auto is_cut = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:is_cut", false).first;
  const auto uv
    = mesh.add_property_map<Surface_mesh::Halfedge_index, CGAL::Simple_cartesian<double>::Point_2>("h:uv").first;
  Run run;
  run.result = SMC::unwrap<CGAL::Parallel_if_available_tag>(mesh, is_cut, uv, np);
  run.is_certified = bool(SMC::certify_unwrap(mesh, is_cut, uv));
  for(auto e : edges(mesh))
    run.values.push_back(is_cut[e]);
  for(auto h : halfedges(mesh))
  {
    run.values.push_back(uv[h].x());
    run.values.push_back(uv[h].y());
  }
  return run;
}

template <typename Solver>
Run unwrap_with(const Surface_mesh& mesh, const Solver& solver)
{
  return unwrap(mesh, CGAL::parameters::sparse_linear_solver(solver).do_bijective(true));
}

void check_like_default(const Run& run, const Run& expected, const char* solver)
{
  CHECK(run.result && run.is_certified, solver);
  CHECK(std::abs(run.result.average_distortion - expected.result.average_distortion) < 1e-4 &&
        std::abs(run.result.cut_length - expected.result.cut_length) < 1e-9, solver);
}

void test_solvers(const Surface_mesh& mesh)
{
  const Run expected = unwrap(mesh, CGAL::parameters::do_bijective(true));
  std::cout << "E " << expected.result.average_distortion << ", length " << expected.result.cut_length << std::endl;
  CHECK(expected.result && expected.is_certified, "built-in solver");
  CHECK(unwrap_with(mesh, CGAL::Default()).values == expected.values, "named default");

  check_like_default(unwrap_with(mesh, CGAL::Eigen_solver_traits<LLT>()), expected, "LLT");
  check_like_default(unwrap_with(mesh, CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Matrix, Eigen::Upper> >()),
                     expected, "LDLT of the upper triangle");
  check_like_default(unwrap_with(mesh, CGAL::Eigen_solver_traits<Eigen::SparseLU<Matrix> >()), expected, "LU");
  check_like_default(unwrap_with(mesh, CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Matrix> >()), expected, "LDLT");

  Solver_record record;
  check_like_default(unwrap_with(mesh, Recording_solver(record)), expected, "own solver");
  std::cout << record.analyses << " analyses, " << record.factorizations << " factorizations" << std::endl;
  CHECK(record.analyses > 10 && record.factorizations > record.analyses, "analysis is kept");
}

struct Broken_solver : LLT
{
  Eigen::ComputationInfo info() const { return Eigen::NumericalIssue; }
};

// No system is solved by anything but what is given.
void test_failure(const Surface_mesh& mesh)
{
  Solver_record record;
  Recording_solver solver(record);
  solver.is_broken = true;
  CHECK(unwrap_with(mesh, solver).result.status.code == Status_code::NUMERICAL_FAILURE, "failure of a copy");
  CHECK(record.factorizations > 0, "the copy was asked");
  CHECK(unwrap_with(mesh, CGAL::Eigen_solver_traits<Broken_solver>()).result.status.code == Status_code::NUMERICAL_FAILURE,
        "failure of what traits hold");

  Surface_mesh copy = mesh;
  const auto is_cut = copy.add_property_map<Surface_mesh::Edge_index, bool>("e:is_cut", false).first;
  const auto np = CGAL::parameters::sparse_linear_solver(solver);
  CHECK(SMC::greedy_cut(copy, is_cut, np).status.code == Status_code::NUMERICAL_FAILURE, "failure in greedy_cut()");
  std::vector<Surface_mesh::Vertex_index> points;
  CHECK(SMC::detect_feature_points(copy, std::back_inserter(points), np).status.code == Status_code::NUMERICAL_FAILURE,
        "failure in detect_feature_points()");
}

template <typename Function>
void with_threads(int number, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, std::size_t(number));
  tbb::task_arena(number).execute(f);
#else
  CGAL_USE(number);
  f();
#endif
}

// Several parts, whose systems are solved at the same time.
void test_threads(const test::Soup& soup)
{
  test::Soup parts = soup;
  for(int i = 0; i < 2; ++i)
  {
    parts.scale(1.1);
    parts.add(soup);
  }
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(parts);
  std::vector<double> expected;
  for(int number : {1, 2, 4})
    with_threads(number, [&]
    {
      Solver_record record;
      const Run run = unwrap_with(mesh, CGAL::Eigen_solver_traits<LLT>());
      const Run copied = unwrap_with(mesh, Recording_solver(record));
      CHECK(run.result && copied.result, "parts");
      std::vector<double> values = run.values;
      values.insert(values.end(), copied.values.begin(), copied.values.end());
      if(number == 1)
        expected = values;
      CHECK(values == expected, "the same for all numbers of threads");
    });
}

} // namespace sparse_linear_solver_test

int main()
{
  using namespace sparse_linear_solver_test;
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(star(16));
  test_solvers(mesh);
  test_failure(mesh);
  test_threads(star(10));
  return test::exit_status();
}
