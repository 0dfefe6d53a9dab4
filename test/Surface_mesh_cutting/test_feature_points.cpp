// The steps of feature point detection against brute force, the early decisions of the filtering against
// full convergence, and the filtering with several threads against that with one.

#include "../BGL/check.h"
#include "star_shapes.h"

#include <CGAL/Surface_mesh_cutting/internal/detection/Greedy_filter.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/Random.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

namespace feature_points_test {

namespace SMC = CGAL::Surface_mesh_cutting::internal;
namespace SMP = CGAL::Surface_mesh_parameterization::internal;

void test_maximizers(CGAL::Random& random)
{
  const SMC::Indexed_mesh mesh = test::random_star_shape(6, random);
  std::vector<double> values;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    values.push_back(random.get_int(0, 6)); // many plateaus
  const std::vector<int> maximizers = SMC::local_maximizers(mesh, values);

  // Each vertex climbs, along its plateau too, to exactly those plateaus that hold a maximizer.
  for(int v : maximizers)
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      CHECK(mesh.source(h) != v || values[mesh.target(h)] <= values[v], "a maximizer has no higher neighbor");
  CHECK(std::count_if(maximizers.begin(), maximizers.end(), [&](int v)
                      { return values[v] == *std::max_element(values.begin(), values.end()); }) >= 1, "the maximum");
  for(int a : maximizers)
    for(int b : maximizers)
      for(int h = 0; h < mesh.number_of_halfedges(); ++h)
        CHECK(!(mesh.source(h) == a && mesh.target(h) == b), "one representative for a plateau");

  for(const SMC::Candidate& c : SMC::scopes_of_influence(mesh, values, maximizers))
  {
    const std::vector<double> distances = test::distances_by_relaxation(mesh, c.vertex);
    double scope = std::numeric_limits<double>::infinity();
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(values[v] > values[c.vertex])
        scope = (std::min)(scope, distances[v]);
    CHECK(scope == c.influence_radius || std::abs(scope - c.influence_radius) < 1e-12, "scope of influence");
  }
}

void test_disks(CGAL::Random& random)
{
  const SMC::Indexed_mesh mesh = test::random_star_shape(8, random);
  const double radius = 3 * SMC::average_edge_length(mesh);
  std::vector<int> centers;
  for(int v = 0; v < mesh.number_of_vertices(); v += random.get_int(5, 30))
    centers.push_back(v);
  SMC::Candidate_disks disks(mesh);
  disks.set(centers, radius);

  std::vector<std::vector<double> > distances;
  for(int c : centers)
    distances.push_back(test::distances_by_relaxation(mesh, c));
  std::vector<int> counts(mesh.number_of_faces(), 0);
  for(std::size_t i = 0; i < centers.size(); ++i)
  {
    double own = radius;
    for(std::size_t j = 0; j < centers.size(); ++j)
      if(j != i)
        own = (std::min)(own, distances[i][centers[j]] / 2);
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      const SMP::Triangle& t = mesh.triangles()[f];
      counts[f] += distances[i][t[0]] < own && distances[i][t[1]] < own && distances[i][t[2]] < own;
    }
  }
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    CHECK(disks.is_covered(f) == (counts[f] > 0), "forbidden region");
  for(int c : centers)
    disks.release(c);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    CHECK(!disks.is_covered(f), "all disks released");
}

// The energy that full convergence reaches from the state after the slit.
double converged_energy(const SMC::Indexed_mesh& mesh, const std::vector<SMP::Rest_shape>& shapes,
                        const SMC::Incremental_parameterization& map, const std::vector<int>& slit)
{
  SMC::Corner_table chart = map.chart();
  std::vector<Eigen::Vector2d> uv = map.uv();
  std::vector<int> halfedges;
  for(int e : slit)
    halfedges.push_back(mesh.halfedge(e));
  const SMC::Corner_table::Opening opening = chart.open(halfedges);
  uv.resize(chart.number_of_vertices());
  for(const auto& [corner, former] : opening.corners)
    uv[chart.source(corner)] = uv[former];
  SMP::Newton_options options;
  options.decrement = 1e-10;
  options.maximum_iterations = 500;
  const SMP::Solvers linear_solvers = SMP::default_solvers();
  SMP::Newton_solver solver(chart.triangles(), chart.number_of_vertices(), linear_solvers);
  return solver.minimize<SMP::Symmetric_Dirichlet_energy>(shapes, SMP::area_weights(shapes), uv, options).energy;
}

bool are_equal(const SMC::Open_chart& a, const SMC::Open_chart& b)
{
  return a.cut == b.cut && a.chart.triangles() == b.chart.triangles() && a.chart.opposites() == b.chart.opposites() &&
         a.chart.origins() == b.chart.origins() && a.uv == b.uv && a.energy == b.energy;
}

// From the same state, the early decision is that of full convergence, unless the gain is within `tolerance` of the
// threshold, relative to it.
void test_replay(const SMC::Mapping_policy& policy, double tolerance, CGAL::Random& random, int& decisions)
{
  const SMC::Indexed_mesh mesh = test::random_star_shape(14, random);
  const std::vector<SMP::Rest_shape> shapes = SMP::rest_shapes(mesh.triangles(), mesh.points());
  SMC::Run_control control;
  SMC::Incremental_parameterization map(mesh, shapes, policy, control);
  CHECK(map.initialize(SMC::make_cut(mesh, SMC::path_to_farthest_vertex(mesh, 0, 2))), "initial map");
  SMC::Shortest_paths paths(mesh.graph());
  const double threshold = 0.01;
  for(int i = 0; i < 12; ++i)
  {
    paths.clear();
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      if(map.cut()[e])
      {
        paths.add_source(mesh.source(mesh.halfedge(e)));
        paths.add_source(mesh.target(mesh.halfedge(e)));
      }
    paths.run();
    std::vector<int> slit;
    paths.path(random.get_int(0, mesh.number_of_vertices()), std::back_inserter(slit));
    if(slit.empty())
      continue;
    const double gain = map.energy() - converged_energy(mesh, shapes, map, slit);
    const double before = map.energy();
    const SMC::Open_chart former = map.state();
    const bool is_accepted = map.open_if_useful(slit, threshold);
    ++decisions;
    CHECK(std::abs(gain - threshold) <= tolerance * threshold || is_accepted == (gain > threshold), "early decision");
    if(is_accepted)
      CHECK(before - map.energy() > (1 - tolerance) * threshold, "the gain of an accepted slit");
    else
      CHECK(are_equal(map.state(), former), "a rejected slit leaves no trace");
  }
}

// Without estimates, nothing but the precision of the solves can make a difference.
void test_replays(CGAL::Random& random)
{
  const SMP::Solvers linear_solvers = SMP::default_solvers();
  SMC::Cutting_parameters faithful;
  faithful.use_published_method = true;
  faithful.linear_solvers = std::make_shared<SMP::Solvers>(SMP::default_solvers());
  int decisions = 0;
  for(int i = 0; i < 12; ++i)
  {
    test_replay(SMC::Mapping_policy(linear_solvers), 0.1, random, decisions);
    test_replay(SMC::mapping_policy(faithful), 0.01, random, decisions);
  }
  std::cout << decisions << " decisions replayed" << std::endl;
}

// What is filtered: a closed surface if `cut` is empty.
struct Filtering
{
  const SMC::Indexed_mesh& mesh;
  const std::vector<SMP::Rest_shape> shapes;
  std::vector<SMC::Candidate> candidates;
  std::vector<int> terminals;
  SMC::Cut cut;
};

template <typename Judge>
void filter(const Filtering& f, SMC::Execution execution, Judge judge)
{
  const SMC::Problem problem{f.mesh, f.shapes, SMC::unconstrained(f.mesh), f.terminals, SMC::Initial_cut(),
                             f.cut.empty()};
  SMC::Cutting_parameters parameters;
  parameters.linear_solvers = std::make_shared<SMP::Solvers>(SMP::default_solvers());
  SMC::Run_control control;
  SMC::Phase_clock clock;
  SMC::Greedy_filter filter(problem, SMC::Context{parameters, control, clock, execution});
  CHECK(f.cut.empty() ? filter.run(f.candidates) : filter.run_on_disk(f.cut, f.candidates), "filtering");
  judge(filter);
}

template <typename Function>
void with_four_threads(const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena(4).execute(f);
#else
  f();
#endif
}

// Candidates at random, so that some are on the cut, blocked, accepted, or rejected.
void test_speculation(bool is_closed, CGAL::Random& random, int& decisions)
{
  const SMC::Indexed_mesh mesh = test::random_star_shape(random.get_int(10, 20), random);
  Filtering f{mesh, SMP::rest_shapes(mesh.triangles(), mesh.points()), {}, {}, {}};
  if(!is_closed)
    f.cut = SMC::make_cut(mesh, SMC::path_to_farthest_vertex(mesh, 0, 2));
  for(int v = random.get_int(0, 20); v < mesh.number_of_vertices(); v += random.get_int(5, 25))
    f.candidates.push_back({v, random.get_double(0, 25) * SMC::average_edge_length(mesh)});
  f.terminals.push_back(f.candidates[f.candidates.size() / 2].vertex);
  filter(f, SMC::Execution::SEQUENTIAL, [&](const auto& expected)
  {
    decisions += int(f.candidates.size());
    with_four_threads([&]
    {
      filter(f, SMP::execution_of<CGAL::Parallel_if_available_tag>(), [&](const auto& found)
      {
        CHECK(found.features() == expected.features(), "the same features with several threads");
        CHECK(std::equal(found.trade_offs().begin(), found.trade_offs().end(), expected.trade_offs().begin(),
                         expected.trade_offs().end(), [](const auto& a, const auto& b)
                         { return a.cut_length == b.cut_length && a.average_distortion == b.average_distortion; }), "the same cuts accepted");
        CHECK(are_equal(found.map().state(), expected.map().state()), "the same map with several threads");
      });
    });
  });
}

} // namespace feature_points_test

int main(int argc, char** argv)
{
  using namespace feature_points_test;
  const unsigned int seed = argc > 1 ? unsigned(std::atoi(argv[1])) : 20;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  for(int i = 0; i < 20; ++i)
    test_maximizers(random);
  for(int i = 0; i < 10; ++i)
    test_disks(random);
  test_replays(random);
  int decisions = 0;
  for(int i = 0; i < 12; ++i)
    test_speculation(i % 2 == 0, random, decisions);
  std::cout << decisions << " decisions with several threads" << std::endl;
  return test::exit_status();
}
