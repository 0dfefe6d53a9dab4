// Scaffolds fill the outside of a chart; maps built with them are injective, by a test of all pairs
// of border edges, and no worse than they have to be.

#include "../BGL/check.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/Scaffold_minimization.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace bijective_map_test {

using namespace smp;
using Eigen::Vector2d;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

std::vector<int> border_halfedges(const Corner_table& chart)
{
  std::vector<int> border;
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    if(chart.is_border(h))
      border.push_back(h);
  return border;
}

// All pairs of border edges; consecutive ones share their common vertex only.
bool has_crossing(const Corner_table& chart, const std::vector<Vector2d>& uv)
{
  const auto point = [&](int v) { return Exact_kernel::Point_2(uv[v].x(), uv[v].y()); };
  const std::vector<int> border = border_halfedges(chart);
  for(int g : border)
    for(int h : border)
    {
      if(g >= h)
        continue;
      const int a = chart.source(g), b = chart.target(g), c = chart.source(h), d = chart.target(h);
      if(a == d && b == c)
        return true;
      if(b == c || a == d)
      {
        const int first = b == c ? a : c, shared = b == c ? b : a, last = b == c ? d : b;
        if(CGAL::collinear(point(first), point(shared), point(last)) &&
           !CGAL::collinear_are_ordered_along_line(point(first), point(shared), point(last)))
          return true;
      }
      else if(CGAL::do_intersect(Exact_kernel::Segment_2(point(a), point(b)),
                                 Exact_kernel::Segment_2(point(c), point(d))))
        return true;
    }
  return false;
}

bool has_flip(const std::vector<Triangle>& triangles, const std::vector<Vector2d>& uv)
{
  const auto point = [&](int v) { return Exact_kernel::Point_2(uv[v].x(), uv[v].y()); };
  for(const Triangle& t : triangles)
    if(CGAL::orientation(point(t[0]), point(t[1]), point(t[2])) != CGAL::LEFT_TURN)
      return true;
  return false;
}

double energy(const Corner_table& chart, const std::vector<Rest_shape>& shapes, const std::vector<Vector2d>& uv)
{
  return area_average(shapes, face_energies<Symmetric_Dirichlet_energy>(shapes, chart.triangles(), uv));
}

// Corner_table and scaffold together are a box without gaps: all triangles are positive, all borders of the
// chart are covered, and the areas add up.
void check_scaffold(const Corner_table& chart, const std::vector<Vector2d>& uv)
{
  Scaffold scaffold;
  const bool is_built = scaffold.build(chart, uv);
  CHECK(is_built);
  const int n = chart.number_of_vertices();
  for(int v = 0; v < n; ++v)
    CHECK(scaffold.points()[v] == uv[v]);
  std::vector<Triangle> triangles = chart.triangles();
  triangles.insert(triangles.end(), scaffold.triangles().begin(), scaffold.triangles().end());
  CHECK(!has_flip(triangles, scaffold.points()));
  std::map<std::pair<int, int>, int> halfedges;
  for(const Triangle& t : triangles)
    for(int k = 0; k < 3; ++k)
    {
      const bool is_new = halfedges.insert({{t[k], t[(k + 1) % 3]}, 1}).second;
      CHECK(is_new);
    }
  int open = 0;
  for(const auto& h : halfedges)
    if(halfedges.find({h.first.second, h.first.first}) == halfedges.end())
    {
      ++open;
      for(int v : {h.first.first, h.first.second})
        CHECK(v >= n && v < n + Scaffold::number_of_corners);
    }
  CHECK(open == Scaffold::number_of_corners);
  const Vector2d extent = scaffold.points()[n + 2] - scaffold.points()[n];
  const double area = chart_area(triangles, scaffold.points());
  CHECK(std::abs(area - extent.x() * extent.y()) < 1e-9 * area);
}

// Borders that touch or cross have no scaffold.
void test_no_scaffold()
{
  const Corner_table chart = make_chart({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 6);
  std::vector<Vector2d> uv = {Vector2d(0, 0), Vector2d(4, 0), Vector2d(4, 4), Vector2d(-4, 4),
                              Vector2d(-4, -4), Vector2d(4, -4)};
  check_scaffold(chart, uv);
  const Vector2d tips[] = {Vector2d(5, 1), Vector2d(4, 0), Vector2d(2, 0)}; // crosses, meets, lies on
  for(const Vector2d& tip : tips)
  {
    uv[5] = tip;
    CHECK(has_crossing(chart, uv));
    CHECK(!Scaffold().build(chart, uv));
  }
}

// A map, and whether it is the unconstrained one.
std::pair<std::vector<Vector2d>, bool> check_map(const Test_surface& surface)
{
  const Corner_table& chart = surface.chart;
  const std::vector<Rest_shape> shapes = rest_shapes(chart.triangles(), surface.points);
  std::vector<Vector2d> plain, uv;
  Chart_parameterizer(chart, surface.points, shapes, linear_solvers).isometric_map(plain, Newton_options());
  const Newton_result result
    = bijective_map(chart, surface.points, shapes, linear_solvers, uv, Newton_options());
  CHECK(result.outcome == Newton_outcome::CONVERGED || result.outcome == Newton_outcome::STALLED);
  CHECK(!has_flip(chart.triangles(), uv) && !has_crossing(chart, uv));
  const double plain_energy = energy(chart, shapes, plain);
  CHECK(std::abs(result.energy - energy(chart, shapes, uv)) < 1e-9);
  const bool is_plain = !has_crossing(chart, plain);
  CHECK(is_plain == (uv == plain));
  CHECK(result.energy > plain_energy - 1e-3);
  std::cout << chart.number_of_vertices() << " vertices: " << plain_energy << " -> " << result.energy
            << (is_plain ? "" : ", would overlap") << std::endl;
  check_scaffold(chart, uv);
  return {uv, is_plain};
}

// From Tutte's embedding, with and without moving the scaffold: the energy falls, nothing crosses.
void check_from_tutte(const Test_surface& surface)
{
  const Corner_table& chart = surface.chart;
  const std::vector<Rest_shape> shapes = rest_shapes(chart.triangles(), surface.points);
  std::vector<Vector2d> start;
  const bool is_mapped = tutte_map(chart, surface.points, surface_area(shapes), linear_solvers, start);
  CHECK(is_mapped && !has_crossing(chart, start));
  for(bool moves_scaffold : {false, true})
  {
    Scaffold_options options;
    options.moves_scaffold = moves_scaffold;
    std::vector<Vector2d> uv = start;
    const Newton_result result
      = Scaffold_minimization(chart, shapes, linear_solvers, options)(uv);
    CHECK(result.energy < energy(chart, shapes, start));
    CHECK(!has_flip(chart.triangles(), uv) && !has_crossing(chart, uv));
  }
  // Stopped at once, it stays where it is.
  Scaffold_options options;
  options.go_further = [] { return false; };
  std::vector<Vector2d> uv = start;
  const Newton_result result = Scaffold_minimization(chart, shapes, linear_solvers, options)(uv);
  CHECK(result.outcome == Newton_outcome::STOPPED && uv == start);
}

// A map that is near what is known to be the least energy stays.
void check_improvement(const Test_surface& surface)
{
  const Corner_table& chart = surface.chart;
  const std::vector<Rest_shape> shapes = rest_shapes(chart.triangles(), surface.points);
  std::vector<Vector2d> uv;
  const bool is_mapped = tutte_map(chart, surface.points, surface_area(shapes), linear_solvers, uv);
  CHECK(is_mapped);
  Scaffold_options options;
  options.least_decrease = 0.01;
  options.least_energy = 0.995 * energy(chart, shapes, uv);
  const std::vector<Vector2d> former = uv;
  const Newton_result near = Scaffold_minimization(chart, shapes, linear_solvers, options)(uv);
  CHECK(near.outcome == Newton_outcome::CONVERGED && uv == former);
  options.least_energy = 0.985 * energy(chart, shapes, uv);
  Scaffold_minimization(chart, shapes, linear_solvers, options)(uv);
  CHECK(energy(chart, shapes, uv) < energy(chart, shapes, former));
}

// The coarsest stage is small, and grows to the whole chart in steps of the same factor.
void check_coarsest_size()
{
  for(int n : {4, 499, 500, 501, 2000, 2001, 18107})
  {
    int size = coarsest_size(n), stages = 0;
    CHECK(size <= 500 && (n <= 500 ? size == n : size > 100));
    for(; size < n; size *= growth_of_stages)
      ++stages;
    CHECK(size < n + 2 * (1 << (2 * stages)));
  }
}

// The first half of what goes is not near the border, with which the image of a stage would shrink.
void check_border_stays(const Test_surface& surface)
{
  const Corner_table& chart = surface.chart;
  Chart_hierarchy hierarchy(chart, surface.points, true);
  hierarchy.coarsen(chart.number_of_vertices() / 2);
  const std::vector<int> left = hierarchy.stage().vertices;
  CHECK(left.size() <= std::size_t(chart.number_of_vertices() / 2));
  for(int h : border_halfedges(chart))
    CHECK(std::find(left.begin(), left.end(), chart.source(h)) != left.end());
}

// Refinement alone, without any optimization: the image of a stage lies inside the former one.
void check_refinement(const Test_surface& surface)
{
  const Corner_table& chart = surface.chart;
  Chart_hierarchy hierarchy(chart, surface.points, true);
  const int size = hierarchy.coarsen(20);
  CHECK(size < chart.number_of_vertices());
  std::vector<Vector2d> uv(chart.number_of_vertices(), Vector2d(0, 0));
  double area = std::numeric_limits<double>::infinity();
  while(true)
  {
    const Chart_hierarchy::Stage stage = hierarchy.stage();
    std::vector<Vector2d> stage_uv(stage.vertices.size());
    if(std::isinf(area))
    {
      const bool is_mapped = tutte_map(stage.chart, stage.points, 1, linear_solvers, stage_uv);
      CHECK(is_mapped);
      for(std::size_t v = 0; v < stage_uv.size(); ++v)
        uv[stage.vertices[v]] = stage_uv[v];
    }
    for(std::size_t v = 0; v < stage_uv.size(); ++v)
      stage_uv[v] = uv[stage.vertices[v]];
    CHECK(!has_flip(stage.chart.triangles(), stage_uv) && !has_crossing(stage.chart, stage_uv));
    const double stage_area = chart_area(stage.chart.triangles(), stage_uv);
    CHECK(stage_area <= area);
    area = stage_area;
    if(hierarchy.is_complete())
      return;
    const bool is_refined
      = hierarchy.refine_to<Symmetric_Dirichlet_energy>(2 * hierarchy.number_of_vertices(), uv);
    CHECK(is_refined);
  }
}

// A slit along a random walk from the border that does not meet itself. Its sides come apart; what else there is stays.
void check_opening(Test_surface surface, CGAL::Random& random)
{
  Corner_table& chart = surface.chart;
  const std::vector<Rest_shape> shapes = rest_shapes(chart.triangles(), surface.points);
  std::vector<Vector2d> uv;
  const bool is_mapped = tutte_map(chart, surface.points, surface_area(shapes), linear_solvers, uv);
  CHECK(is_mapped);
  std::vector<char> is_taken(chart.number_of_vertices(), 0);
  std::vector<int> starts, slit;
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    if(chart.is_border(h))
    {
      is_taken[chart.source(h)] = 1;
      starts.push_back(h);
    }
  int h = starts[random.get_int(0, int(starts.size()))];
  for(int step = 0; step < 40 && slit.size() < 12; ++step)
  {
    for(int turn = random.get_int(0, 6); turn > 0 && chart.next_around_source(h) >= 0; --turn)
      h = chart.next_around_source(h);
    if(chart.is_border(h) || is_taken[chart.target(h)])
      continue;
    is_taken[chart.target(h)] = 1;
    slit.push_back(h);
    h = chart.opposite(h);
  }
  if(slit.empty())
    return;
  std::vector<char> is_on_slit(chart.number_of_vertices(), 0);
  for(int e : slit)
    is_on_slit[chart.source(e)] = is_on_slit[chart.target(e)] = 1;
  const std::vector<Vector2d> former = uv;
  const double former_area = chart_area(chart.triangles(), uv);
  open_injectively(slit, chart, uv);
  CHECK(chart.number_of_vertices() == int(former.size() + slit.size())); // all but the tip fall apart
  CHECK(chart.euler_characteristic() == 1);
  CHECK(!has_flip(chart.triangles(), uv) && !has_crossing(chart, uv));
  const double area = chart_area(chart.triangles(), uv);
  CHECK(area < former_area && area > former_area / 2);
  for(std::size_t v = 0; v < former.size(); ++v)
    CHECK(is_on_slit[v] || uv[v] == former[v]);
  check_scaffold(chart, uv);
}

// A ramp of some turns: laid flat without distortion, it covers its own start. With holes if asked
// for.
Test_surface make_ramp(int length, int width, double turns, CGAL::Random& random, bool has_holes)
{
  return make_grid_surface(length, width, random,
    [&](double x, double y)
    {
      const double angle = 2 * EIGEN_PI * turns * x, radius = 3 - y;
      return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), angle / 10);
    },
    [&](int i, int j) { return has_holes && i % 4 == 1 && j % 3 == 1 && j + 1 < width; });
}

// Arms around a vertex with more surface around it than the plane has room for: the height of the
// surface oscillates around the center.
Test_surface make_saddle(int arms, int length, double height, CGAL::Random& random)
{
  const int width = 6;
  return make_grid_surface(arms * width, length, random,
    [&](double x, double y)
    {
      const double angle = 2 * EIGEN_PI * x * (1 - 1e-3), r = 0.1 + y;
      return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle),
                             height * r * std::cos(arms * angle));
    },
    [&](int i, int j) { return j > 2 && i % width == width - 1; });
}

} // namespace bijective_map_test

int main()
{
  using namespace bijective_map_test;
  CGAL::Random random(7);
  std::cout << "seed " << random.get_seed() << std::endl;
  test_no_scaffold();
  check_coarsest_size();
  check_border_stays(make_hills(40, 40, random));
  for(int i = 0; i < 4; ++i)
  {
    const Test_surface hills = make_hills(8 + 6 * i, 20, random, i % 2 == 1);
    check_map(hills);
    check_refinement(hills);
    check_from_tutte(hills);
    check_improvement(hills);
    for(int j = 0; j < 10; ++j)
      check_opening(make_hills(8 + 6 * i, 20, random), random);
  }
  int overlapping = 0, cases = 0;
  const auto check = [&](const Test_surface& surface)
  {
    check_refinement(surface);
    overlapping += !check_map(surface).second;
    ++cases;
  };
  for(bool has_holes : {false, true})
    for(double turns : {1.1, 1.5})
      check(make_ramp(int(60 * turns), 6, turns, random, has_holes));
  for(int arms : {4, 7})
    for(double height : {0.3, 0.7})
      check(make_saddle(arms, 15, height, random));
  CHECK(overlapping >= cases - 1);
  check_map(make_cut_sphere(20));
  return test::exit_status();
}
