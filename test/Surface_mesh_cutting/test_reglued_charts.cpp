// Charts that overlap themselves, rearranged: unfolded surfaces, whose triangles keep their shapes, and how often borders wind
// around points, against sums of angles.

#include "checks.h"
#include "star_shapes.h"

#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_regluing.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_seams.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_regluer.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_cutting::internal;

using CGAL::Surface_mesh_parameterization::internal::default_solvers;
using CGAL::Surface_mesh_parameterization::internal::is_bijective;
using CGAL::Surface_mesh_parameterization::internal::rest_shapes;
using Eigen::Vector2d;
using Segments = std::vector<Winding_rows::Segment>;
using test::check;

int winding_by_angles(const Segments& segments, const Vector2d& p)
{
  double sum = 0;
  for(const Winding_rows::Segment& s : segments)
  {
    const Vector2d u = s.source - p, v = s.target - p;
    sum += std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
  }
  return int(std::lround(sum / (2 * CGAL_PI)));
}

void test_winding(CGAL::Random& random)
{
  Segments segments;
  for(int polygon = 0; polygon < 3; ++polygon)
  {
    std::vector<Vector2d> points;
    for(int i = 0; i < 20; ++i)
      points.emplace_back(random.get_double(-1, 1), random.get_double(-1, 1));
    for(int i = 0; i < 20; ++i)
      segments.push_back({points[i], points[(i + 1) % 20]});
  }
  const Winding_rows winding(segments);
  for(int i = 0; i < 200; ++i)
  {
    const Vector2d p(random.get_double(-1.2, 1.2), random.get_double(-1.2, 1.2));
    check(winding(p) == winding_by_angles(segments, p), "how often polygons wind around a point");
  }
  check(Winding_rows({})(Vector2d(0, 0)) == 0, "nothing winds around");
}

// Cuts all edges but those of a random tree that connects the faces; it takes what must not be cut as soon as it can.
Cut random_unfolding(const Indexed_mesh& mesh, const Edge_constraints& constraints, CGAL::Random& random)
{
  Cut cut(mesh.number_of_edges(), 1);
  std::vector<char> is_reached(mesh.number_of_faces(), 0);
  int number = 0;
  const auto reach = [&](int face)
  {
    is_reached[face] = 1;
    ++number;
    for(int h = 3 * face; h < 3 * face + 3; ++h)
      if(constraints.is_forbidden(mesh.edge(h)) && !std::exchange(is_reached[mesh.opposite(h) / 3], char(1)))
      {
        cut[mesh.edge(h)] = 0;
        ++number;
      }
  };
  reach(0);
  while(number < mesh.number_of_faces())
  {
    const int h = random.get_int(0, mesh.number_of_halfedges()), e = mesh.edge(h);
    if(!is_reached[h / 3] || is_reached[mesh.opposite(h) / 3] || constraints.mandatory[e])
      continue;
    cut[e] = 0;
    reach(mesh.opposite(h) / 3);
  }
  return cut;
}

// Of the source of each halfedge, as every triangle is laid down at the one before. Only of cuts as above.
std::vector<Vector2d> unfolded(const Indexed_mesh& mesh, const Cut& cut)
{
  const auto apex = [&](int h, const Vector2d& p, const Vector2d& q) // of the triangle at the left of `h`, from p to q
  {
    const Point a = mesh.point(mesh.source(h)), b = mesh.point(mesh.target(h));
    const Point c = mesh.point(mesh.source(previous_halfedge(h)));
    const double along = (c - a).dot(b - a) / (b - a).norm();
    const double height = std::sqrt((c - a).squaredNorm() - along * along);
    const Vector2d u = (q - p).normalized();
    return Vector2d(p + along * u + height * Vector2d(-u.y(), u.x()));
  };
  std::vector<Vector2d> corners(mesh.number_of_halfedges());
  const auto put = [&](int h, const Vector2d& p, const Vector2d& q)
  {
    corners[h] = p;
    corners[next_halfedge(h)] = q;
    corners[previous_halfedge(h)] = apex(h, p, q);
  };
  std::vector<char> is_put(mesh.number_of_faces(), 0);
  put(0, Vector2d(0, 0), Vector2d(mesh.length(mesh.edge(0)), 0));
  is_put[0] = 1;
  for(std::vector<int> stack(1, 0); !stack.empty();)
  {
    const int f = stack.back();
    stack.pop_back();
    for(int h = 3 * f; h < 3 * f + 3; ++h)
    {
      const int o = mesh.opposite(h);
      if(cut[mesh.edge(h)] || is_put[o / 3])
        continue;
      put(o, corners[next_halfedge(h)], corners[h]);
      is_put[o / 3] = 1;
      stack.push_back(o / 3);
    }
  }
  return corners;
}

// What the cut costs, and the border where it lies in several layers.
double objective(const Problem& problem, const Cut& cut, const std::vector<Vector2d>& corners)
{
  const Corner_table chart = make_chart(problem.mesh, cut);
  std::vector<Vector2d> uv(chart.number_of_vertices());
  for(int h = 0; h < problem.mesh.number_of_halfedges(); ++h)
    uv[chart.source(h)] = corners[h];
  Segments segments;
  std::vector<double> costs;
  for(int h = 0; h < problem.mesh.number_of_halfedges(); ++h)
    if(chart.is_border(h))
    {
      segments.push_back({uv[chart.source(h)], uv[chart.target(h)]});
      costs.push_back(problem.constraints.weights[problem.mesh.edge(h)]);
    }
  double result = cut_cost(problem.constraints, cut);
  for(std::size_t i = 0; i < segments.size(); ++i)
  {
    const Vector2d along = segments[i].target - segments[i].source;
    const Vector2d p = 0.5 * (segments[i].source + segments[i].target) + 0.01 * Vector2d(-along.y(), along.x());
    result += costs[i] * (std::max)(0, winding_by_angles(segments, p) - 1);
  }
  return result;
}

bool is_disk(const Indexed_mesh& mesh, const Cut& cut)
{
  const Corner_table chart = make_chart(mesh, cut);
  int edges = 0;
  for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    edges += chart.is_border(h) || h < chart.opposite(h);
  return Connected_parts(chart.opposites()).number == 1 && chart.border_loops().size() == 1 &&
         chart.number_of_vertices() - edges + mesh.number_of_faces() == 1;
}

// Some terminals, an edge that has to be cut, and one that must not be.
void constrain(const Indexed_mesh& mesh, Problem& problem, CGAL::Random& random)
{
  for(int i = 0; i < 4; ++i)
    problem.terminals.push_back(random.get_int(0, mesh.number_of_vertices()));
  const int f = random.get_int(0, mesh.number_of_faces());
  problem.constraints.mandatory[mesh.edge(3 * f)] = 1;
  problem.constraints.weights[mesh.edge(3 * f + 1)] = std::numeric_limits<double>::infinity();
}

void check_constraints(const Problem& problem, const Cut& cut)
{
  const Indexed_mesh& mesh = problem.mesh;
  const std::vector<char> is_on_cut = open_vertices(mesh, cut);
  for(int v : problem.terminals)
    check(is_on_cut[v], "a terminal left the cut");
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    check((cut[e] || !problem.constraints.mandatory[e]) && !(cut[e] && problem.constraints.is_forbidden(e)),
          "constraints of edges");
}

Open_chart unfolded_chart(const Problem& problem, const std::vector<Vector2d>& corners, Cut cut)
{
  Open_chart chart;
  chart.cut = std::move(cut);
  chart.chart = make_chart(problem.mesh, chart.cut);
  chart.uv.resize(chart.chart.number_of_vertices());
  for(int h = 0; h < problem.mesh.number_of_halfedges(); ++h)
    chart.uv[chart.chart.source(h)] = corners[h];
  chart.energy = Symmetric_Dirichlet_energy::ideal;
  return chart;
}

// What the rearranged disk still costs of what it did, with its overlaps.
double check_regluing(const Indexed_mesh& mesh, bool is_constrained, CGAL::Random& random)
{
  Problem problem{mesh, {}, unconstrained(mesh), {}, Initial_cut(Cut(mesh.number_of_edges(), 0)), true};
  if(is_constrained)
    constrain(mesh, problem, random);
  Cut unfolding = random_unfolding(mesh, problem.constraints, random);
  const std::vector<Vector2d> corners = unfolded(mesh, unfolding);
  const Open_chart chart = unfolded_chart(problem, corners, std::move(unfolding));
  check(is_disk(mesh, chart.cut), "an unfolded surface is a disk");

  const auto [cut, moved_corners] = Chart_regluing(problem, chart).rearranged(1, always_go_further);
  check(is_disk(mesh, cut), "a rearranged disk is a disk");
  check_constraints(problem, cut);
  const double former = objective(problem, chart.cut, corners), now = objective(problem, cut, moved_corners);
  check(cut == chart.cut ? moved_corners == corners : now < former, "more overlap or cost");
  return now / former;
}

// Of a chart that is rearranged and, at a bound, shortened, which closes most of an unfolding. Returns whether it was.
bool check_injective_regluing(const Indexed_mesh& mesh, bool has_weights, bool is_stopped, CGAL::Random& random)
{
  Problem problem{mesh, rest_shapes(mesh.triangles(), mesh.points()), unconstrained(mesh), {},
                  Initial_cut(Cut(mesh.number_of_edges(), 0)), true};
  if(has_weights)
    for(double& weight : problem.constraints.weights)
      weight *= random.get_bool() ? 0 : 2;
  constrain(mesh, problem, random);
  Cut unfolding = random_unfolding(mesh, problem.constraints, random);
  const std::vector<Vector2d> corners = unfolded(mesh, unfolding);
  const Open_chart chart = unfolded_chart(problem, corners, std::move(unfolding));

  Cutting_parameters parameters;
  parameters.do_bijective = true;
  parameters.maximum_average_distortion = 4.2;
  parameters.linear_solvers = std::make_shared<Solvers>(default_solvers());
  Run_control control([&] { return !is_stopped; }, {});
  Phase_clock clock;
  const Context context{parameters, control, clock};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Injective_cut cut{chart.cut, chart.chart, {chart.uv, infinity}, {}};
  std::vector<CGAL::Surface_mesh_cutting::Trade_off> seen;
  const auto overlapping = Injective_regluer(problem, context, infinity)
                             .reglue(chart, parameters.maximum_average_distortion, true, cut, seen);
  check(overlapping.has_value() == (cut.cut != chart.cut), "another map for another cut only");
  check(!is_stopped || (!overlapping && seen.empty()), "a run that was stopped goes on");
  if(!overlapping)
    return false;
  check(overlapping->cut == cut.cut && !seen.empty(), "a map of the cut that was taken");
  check(is_disk(mesh, cut.cut), "a disk");
  check_constraints(problem, cut.cut);
  for(int v : problem.terminals)
    check(std::count(cut.ends.begin(), cut.ends.end(), v) == 1, "trees through the ends miss a terminal");
  check(is_bijective(cut.chart, cut.map.uv), "overlaps");
  return true;
}

// The faces by the nearest of a few of them.
std::vector<int> random_parts(const Indexed_mesh& mesh, int number, CGAL::Random& random)
{
  std::vector<int> part(mesh.number_of_faces(), -1), queue;
  while(int(queue.size()) < number)
    if(const int f = random.get_int(0, mesh.number_of_faces()); part[f] < 0)
    {
      part[f] = int(queue.size());
      queue.push_back(f);
    }
  for(std::size_t i = 0; i < queue.size(); ++i)
    for(int h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h)
      if(const int f = mesh.opposite(h) / 3; part[f] < 0)
      {
        part[f] = part[queue[i]];
        queue.push_back(f);
      }
  return part;
}

// Whatever pieces the paths come in, each edge between two parts lies on one seam, and no two seams close the same edges.
void test_seams(CGAL::Random& random)
{
  const Indexed_mesh mesh = test::random_star_shape(5, random);
  const Problem problem{mesh, {}, unconstrained(mesh), {}, Initial_cut(Cut(mesh.number_of_edges(), 0)), true};
  const std::vector<int> part = random_parts(mesh, random.get_int(3, 12), random);
  Cut cut(mesh.number_of_edges(), 0);
  std::vector<std::vector<int> > paths;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(part[mesh.halfedge(e) / 3] != part[mesh.opposite(mesh.halfedge(e)) / 3])
    {
      cut[e] = 1;
      paths.insert(paths.begin() + random.get_int(0, int(paths.size()) + 1), {e});
    }
  const Connected_parts parts(make_chart(mesh, cut).opposites());
  const std::vector<Chart_seam> seams = seams_along(paths, problem, cut, parts);
  Cut covered(mesh.number_of_edges(), 0);
  std::vector<Cut> closed;
  for(const Chart_seam& seam : seams)
  {
    closed.push_back(cut);
    for(const int e : seam.edges)
    {
      check(!covered[e], "an edge on two seams");
      covered[e] = 1;
      closed.back()[e] = 0;
    }
    check(std::abs(total_length(mesh, seam.edges) - seam.cost) < 1e-9 * seam.cost, "cost of a seam");
    close_dead_ends(paths, mesh, closed.back());
  }
  check(covered == cut, "an edge on no seam");
  for(std::size_t i = 0; i < seams.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      check(closed[i] != closed[j], "two seams close the same edges");
  check(seams.size() < paths.size(), "seams of single edges");
}

} // namespace

int main()
{
  CGAL::Random random(11);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 10; ++i)
    test_winding(random);
  for(int i = 0; i < 50; ++i)
    test_seams(random);
  constexpr int number_of_surfaces = 40;
  double sum = 0;
  for(int i = 0; i < number_of_surfaces; ++i)
    sum += check_regluing(test::random_star_shape(random.get_int(3, 7), random), i % 2 == 1, random);
  std::cout << "overlap and cost: " << sum / number_of_surfaces << " of before" << std::endl;
  check(sum < 0.9 * number_of_surfaces, "little is rearranged");

  int number = 0;
  for(int i = 0; i < 12; ++i)
    number += check_injective_regluing(test::random_star_shape(random.get_int(3, 6), random), i % 2 == 1, i % 6 == 5, random);
  std::cout << number << " rearranged without overlaps" << std::endl;
  check(number >= 3, "few are rearranged without overlaps");
  return test::exit_status();
}
