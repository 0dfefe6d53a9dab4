// Necks through the interior of disks, against all paths between vertices of the border.

#include "checks.h"
#include "star_shapes.h"

#include <CGAL/Surface_mesh_cutting/internal/refinement/Neck_search.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_cutting::internal;

using Crossings = std::vector<std::pair<int, int> >;
using test::check;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A tree that grows at random: its complement is a disk with an interior.
Cut random_tree(const Indexed_mesh& mesh, int number_of_edges, CGAL::Random& random)
{
  Cut cut(mesh.number_of_edges(), 0);
  std::vector<char> is_reached(mesh.number_of_vertices(), 0);
  is_reached[0] = 1;
  for(int number = 0; number < number_of_edges;)
  {
    const int h = random.get_int(0, mesh.number_of_halfedges());
    if(!is_reached[mesh.source(h)] || std::exchange(is_reached[mesh.target(h)], char(1)))
      continue;
    cut[mesh.edge(h)] = 1;
    ++number;
  }
  return cut;
}

// Of a disk: its edges between numbered vertices, all of them of the disk's corner table.
struct Disk
{
  const Problem& problem;
  Corner_table chart;
  Chart_border border;
  std::vector<char> is_at_border; // vertices

  Disk(const Problem& problem, const Cut& cut)
    : problem(problem), chart(make_chart(problem.mesh, cut)),
      border(problem, chart, std::vector<Eigen::Vector2d>(chart.number_of_vertices(), Eigen::Vector2d(0, 0))),
      is_at_border(chart.number_of_vertices(), 0)
  {
    for(int h : border.halfedges)
      is_at_border[chart.source(h)] = 1;
  }

  int vertex(int number) const { return chart.source(border.halfedges[number]); }

  // Of the cheapest path to every vertex, all but its ends in the interior: edges are relaxed until nothing changes.
  std::vector<double> costs_from(int from) const
  {
    std::vector<double> costs(chart.number_of_vertices(), infinity);
    costs[from] = 0;
    for(bool is_changed = true; is_changed;)
    {
      is_changed = false;
      for(int h = 0; h < problem.mesh.number_of_halfedges(); ++h)
        if(!chart.is_border(h) && relax(h, from, costs))
          is_changed = true;
    }
    return costs;
  }

private:
  bool relax(int h, int from, std::vector<double>& costs) const
  {
    const int v = chart.source(h), w = chart.target(h);
    const double cost = costs[v] + problem.constraints.weights[problem.mesh.edge(h)];
    if((is_at_border[v] && v != from) || !(cost < costs[w]))
      return false;
    costs[w] = cost;
    return true;
  }
};

// Crossings of a halfedge from `from` up to `to` with one that is not among these.
int number_of_separated(const Chart_border& border, const Crossings& crossings, int from, int to)
{
  const auto is_at_flap = [&](int h) { return border.distance(from, border.numbers[h]) < border.distance(from, to); };
  return int(std::count_if(crossings.begin(), crossings.end(),
                           [&](const auto& c) { return is_at_flap(c.first) != is_at_flap(c.second); }));
}

// That the edges of a neck lead from one end to the other, and cost what it says.
void check_path(const Disk& disk, const Neck& neck)
{
  const Indexed_mesh& mesh = disk.problem.mesh;
  double cost = 0;
  int v = disk.vertex(neck.to);
  for(int e : neck.edges)
  {
    cost += disk.problem.constraints.weights[e];
    int next = -1;
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      if(mesh.edge(h) == e && !disk.chart.is_border(h))
        next = disk.chart.source(h) == v ? disk.chart.target(h) : disk.chart.target(h) == v ? disk.chart.source(h) : next;
    check(next >= 0, "edges of a neck are not in a row");
    if(next < 0)
      return;
    v = next;
  }
  check(v == disk.vertex(neck.from), "a neck does not begin where it says");
  check(std::abs(cost - neck.cost) <= 1e-12 * neck.cost, "the cost of a neck");
}

int check_necks(const Indexed_mesh& mesh, CGAL::Random& random)
{
  Problem problem{mesh, {}, unconstrained(mesh), {}, Initial_cut(Cut(mesh.number_of_edges(), 0)), true};
  for(double& weight : problem.constraints.weights)
    weight *= random.get_double(0.5, 1);
  const Cut cut = random_tree(mesh, 45, random); // a border of less than 100 edges: necks begin at each of its vertices
  const Disk disk(problem, cut);
  Crossings crossings;
  for(int i = 0; i < 20; ++i)
  {
    const int k = random.get_int(0, disk.border.size()), distance = random.get_int(1, disk.border.size());
    crossings.emplace_back(disk.border.halfedges[k], disk.border.halfedges[(k + distance) % disk.border.size()]);
  }

  double best = 0;
  std::vector<std::vector<double> > costs;
  for(int from = 0; from < disk.border.size(); ++from)
  {
    costs.push_back(disk.costs_from(disk.vertex(from)));
    for(int to = 0; to < disk.border.size(); ++to)
      if(to != from && costs[from][disk.vertex(to)] <= disk.border.cost() / 16)
        best = (std::max)(best, number_of_separated(disk.border, crossings, from, to) / costs[from][disk.vertex(to)]);
  }

  const std::vector<Neck> necks = Neck_search(problem, cut, disk.border, crossings)();
  for(const Neck& neck : necks)
  {
    check_path(disk, neck);
    check(std::abs(neck.cost - costs[neck.from][disk.vertex(neck.to)]) <= 1e-12 * neck.cost, "a cheaper neck exists");
    check(neck.number_of_separated == number_of_separated(disk.border, crossings, neck.from, neck.to),
          "the number of pairs that a neck separates");
  }
  check(necks.empty() ? best == 0
                      : std::abs(necks.front().number_of_separated / necks.front().cost - best) <= 1e-12 * best,
        "the first neck is not the best");
  return int(necks.size());
}

} // namespace

int main()
{
  CGAL::Random random(5);
  std::cout << "seed " << random.get_seed() << std::endl;
  int number = 0;
  for(int i = 0; i < 20; ++i)
    number += check_necks(test::random_star_shape(random.get_int(6, 9), random), random);
  std::cout << number << " necks" << std::endl;
  check(number > 500, "few necks");
  return test::exit_status();
}
