// Collapses keep a chart's topology and are undone bit for bit; maps of the coarsest stage become
// flip-free maps of the whole chart.

#include "../BGL/check.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/hierarchical_map.h>

#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace chart_hierarchy_test {

using namespace smp;

struct State
{
  std::vector<Triangle> triangles;
  std::vector<int> opposites;
  std::vector<char> is_dormant;
  std::vector<std::vector<int> > fans; // empty for vertices not in use

  explicit State(const Collapsible_chart& chart, const std::set<int>& vertices, int n)
    : triangles(chart.triangles()), opposites(chart.opposites()), fans(n)
  {
    for(int t = 0; t < int(triangles.size()); ++t)
      is_dormant.push_back(chart.is_dormant(t));
    for(int v : vertices)
      chart.fan(v, fans[v]);
  }
  bool operator==(const State& other) const
  {
    return triangles == other.triangles && opposites == other.opposites
        && is_dormant == other.is_dormant && fans == other.fans;
  }
};

// Opposites match, every vertex has one fan, and the Euler characteristic is what it was.
void check_topology(const Collapsible_chart& chart, const std::set<int>& vertices,
                    int characteristic)
{
  std::vector<Triangle> triangles;
  std::vector<int> numbers(chart.triangles().size(), -1), opposites;
  std::map<int, int> corners;
  for(int t = 0; t < int(numbers.size()); ++t)
    if(!chart.is_dormant(t))
    {
      numbers[t] = int(triangles.size());
      triangles.push_back(chart.triangles()[t]);
      for(int v : triangles.back())
        ++corners[v];
    }
  for(int h = 0; h < 3 * int(numbers.size()); ++h)
  {
    if(numbers[h / 3] < 0)
      continue;
    const int o = chart.opposites()[h];
    opposites.push_back(o < 0 ? -1 : 3 * numbers[o / 3] + o % 3);
    if(o < 0)
      continue;
    CHECK(numbers[o / 3] >= 0 && chart.opposites()[o] == h);
    CHECK(chart.source(o) == chart.target(h) && chart.target(o) == chart.source(h));
  }
  CHECK(corners.size() == vertices.size());
  std::vector<int> fan;
  for(int v : vertices)
  {
    chart.fan(v, fan);
    CHECK(int(fan.size()) == corners.at(v)); // one fan
    for(int h : fan)
      CHECK(chart.source(h) == v && !chart.is_dormant(h / 3));
    CHECK(chart.is_on_border(v) == (chart.opposites()[fan.front()] < 0));
  }
  const Corner_table compact(triangles, opposites, *vertices.rbegin() + 1);
  CHECK(compact.euler_characteristic() == characteristic);
}

void test_collapses(const Corner_table& chart, CGAL::Random& random)
{
  Collapsible_chart collapsible(chart);
  Collapse_log log;
  std::set<int> vertices;
  for(const Triangle& t : chart.triangles())
    vertices.insert(t.begin(), t.end());
  const int characteristic = chart.euler_characteristic(), n = chart.number_of_vertices();
  check_topology(collapsible, vertices, characteristic);

  std::vector<State> states;
  std::vector<int> collapsed, fan, ring;
  for(int attempt = 0, failures = 0; failures < 200 && vertices.size() > 3; ++attempt)
  {
    const int v = *std::next(vertices.begin(), random.get_int(0, int(vertices.size())));
    collapsible.fan(v, fan);
    collapsible.ring(v, fan, ring);
    const int j = random.get_int(0, int(ring.size()));
    if(!collapsible.can_collapse(v, fan, ring, j))
    {
      ++failures;
      continue;
    }
    failures = 0;
    states.emplace_back(collapsible, vertices, n);
    collapsible.collapse(v, fan, ring, j, log);
    collapsed.push_back(v);
    vertices.erase(v);
    check_topology(collapsible, vertices, characteristic);
  }
  CHECK(log.size() == int(collapsed.size()));
  CHECK(2 * collapsed.size() > vertices.size());
  while(!collapsed.empty())
  {
    CHECK(collapsible.undo(log) == collapsed.back());
    vertices.insert(collapsed.back());
    CHECK(State(collapsible, vertices, n) == states.back());
    collapsed.pop_back();
    states.pop_back();
  }
  CHECK(collapsible.triangles() == chart.triangles());
  CHECK(collapsible.opposites() == chart.opposites());
}

template <typename Energy>
void test_hierarchy(const Test_surface& surface)
{
  std::vector<Eigen::Vector2d> uv;
  const bool is_mapped
    = hierarchical_map<Energy>(surface.chart, surface.points, linear_solvers, uv) == Stages_outcome::MAPPED;
  CHECK(is_mapped && count_flips(surface.chart.triangles(), uv) == 0);

  Chart_hierarchy hierarchy(surface.chart, surface.points);
  const int size = hierarchy.coarsen(30);
  const Chart_hierarchy::Stage stage = hierarchy.stage();
  CHECK(int(stage.vertices.size()) == size && size == hierarchy.number_of_vertices());
  CHECK(stage.chart.euler_characteristic() == surface.chart.euler_characteristic());
  CHECK(stage.shapes.size() == stage.chart.triangles().size());
  for(int v = 0; v < size; ++v)
    CHECK(stage.points[v] == surface.points[stage.vertices[v]]);
  std::vector<Eigen::Vector2d> stage_uv;
  if(!tutte_map(stage.chart, stage.points, surface_area(stage.shapes), linear_solvers, stage_uv))
    return; // a bad triangulation of a coarse stage
  uv.assign(surface.points.size(), Eigen::Vector2d::Zero());
  for(int v = 0; v < size; ++v)
    uv[stage.vertices[v]] = stage_uv[v];
  if(hierarchy.refine_to<Energy>(int(surface.points.size()), uv))
    CHECK(count_flips(surface.chart.triangles(), uv) == 0 && hierarchy.is_complete());
}

// The finest stages of a large chart are made in regions: the same ones with one thread and with several.
void test_regions(const Test_surface& surface, bool keeps_region)
{
  const int n = int(surface.points.size());
  std::vector<Eigen::Vector2d> maps[2];
  for(const Execution execution : {Execution::SEQUENTIAL, Execution::PARALLEL})
  {
    Chart_hierarchy hierarchy(surface.chart, surface.points, keeps_region, execution);
    const int size = hierarchy.coarsen(250, 0);
    CHECK(size <= 300 && size == hierarchy.number_of_vertices());
    std::vector<Eigen::Vector2d>& uv = maps[execution == Execution::PARALLEL];
    uv.assign(n, Eigen::Vector2d::Zero());
    for(int number = size; number < n; number = hierarchy.number_of_vertices())
    {
      const Chart_hierarchy::Stage stage = hierarchy.stage();
      CHECK(int(stage.vertices.size()) == hierarchy.number_of_vertices() && int(stage.vertices.size()) >= number);
      CHECK(stage.chart.euler_characteristic() == surface.chart.euler_characteristic());
      std::vector<Eigen::Vector2d> stage_uv = restricted(uv, stage.vertices);
      if(number == size)
        CHECK(tutte_map(stage.chart, stage.points, surface_area(stage.shapes), linear_solvers, stage_uv));
      CHECK(count_flips(stage.chart.triangles(), stage_uv) == 0);
      extend(stage_uv, stage.vertices, uv);
      const bool is_extended = hierarchy.refine_to<Symmetric_Dirichlet_energy>(4 * number, uv);
      CHECK(is_extended);
    }
    CHECK(hierarchy.is_complete() && hierarchy.number_of_vertices() == n);
    CHECK(count_flips(surface.chart.triangles(), uv) == 0);
  }
  CHECK(maps[0] == maps[1]);
}

} // namespace chart_hierarchy_test

int main()
{
  using namespace chart_hierarchy_test;
  CGAL::Random random(5);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 10; ++i)
  {
    const Test_surface hills = make_hills(random.get_int(2, 8), random.get_int(2, 8), random, true);
    test_collapses(hills.chart, random);
    test_collapses(make_cut_sphere(3 + i % 4).chart, random);
  }
  for(int i = 0; i < 6; ++i)
  {
    const Test_surface hills
      = make_hills(random.get_int(20, 40), random.get_int(20, 40), random, i % 2 == 1);
    const Test_surface sphere = make_cut_sphere(12 + 4 * i);
    test_hierarchy<MIPS_energy>(hills);
    test_hierarchy<MIPS_energy>(sphere);
    test_hierarchy<Symmetric_Dirichlet_energy>(hills);
    test_hierarchy<Symmetric_Dirichlet_energy>(sphere);
  }
  const Test_surface large = make_hills(160, 140, random);
  test_regions(large, false);
  test_regions(large, true);
  return test::exit_status();
}
