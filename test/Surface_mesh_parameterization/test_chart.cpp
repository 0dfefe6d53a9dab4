// Random openings of closed surfaces: the chart against a count from scratch, and closing bit for bit.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace chart_test {

using namespace CGAL::Surface_mesh_parameterization::internal;

Corner_table make_closed_chart(const std::vector<Triangle>& triangles, int number_of_vertices)
{
  std::map<std::pair<int, int>, int> halfedges;
  for(int t = 0; t < int(triangles.size()); ++t)
    for(int k = 0; k < 3; ++k)
      halfedges[{triangles[t][k], triangles[t][(k + 1) % 3]}] = 3 * t + k;
  std::vector<int> opposites(3 * triangles.size());
  for(const auto& h : halfedges)
    opposites[h.second] = halfedges.at({h.first.second, h.first.first});
  return Corner_table(triangles, opposites, number_of_vertices);
}

Corner_table torus(int m, int n)
{
  std::vector<Triangle> triangles;
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j)
    {
      const int a = i * n + j, b = (i + 1) % m * n + j, c = (i + 1) % m * n + (j + 1) % n, d = i * n + (j + 1) % n;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  return make_closed_chart(triangles, m * n);
}

// Rings of n vertices between two poles of valence n.
Corner_table sphere(int m, int n)
{
  std::vector<Triangle> triangles;
  const int south = m * n, north = south + 1;
  for(int j = 0; j < n; ++j)
  {
    const int k = (j + 1) % n;
    triangles.push_back({south, k, j});
    for(int i = 0; i + 1 < m; ++i)
    {
      triangles.push_back({i * n + j, i * n + k, (i + 1) * n + k});
      triangles.push_back({i * n + j, (i + 1) * n + k, (i + 1) * n + j});
    }
    triangles.push_back({(m - 1) * n + j, (m - 1) * n + k, north});
  }
  return make_closed_chart(triangles, m * n + 2);
}

// The number of chart vertices of the surface `closed` without the links between `open` edges.
std::vector<int> corner_classes(const Corner_table& closed, const std::set<int>& open)
{
  std::vector<int> parent(closed.opposites().size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int c)
  {
    while(parent[c] != c)
      c = parent[c];
    return c;
  };
  for(int h = 0; h < int(parent.size()); ++h)
  {
    const int o = closed.opposite(h);
    if(open.count(h) || open.count(o))
      continue;
    parent[root(h)] = root(next_halfedge(o));
    parent[root(next_halfedge(h))] = root(o);
  }
  std::vector<int> classes;
  for(int h = 0; h < int(parent.size()); ++h)
    classes.push_back(root(h));
  return classes;
}

void check(const Corner_table& chart, const Corner_table& closed, const std::set<int>& open)
{
  // Exactly the open edges are border, and the others are linked as before.
  int border = 0;
  for(int h = 0; h < int(chart.opposites().size()); ++h)
  {
    const bool is_open = open.count(h) || open.count(closed.opposite(h));
    CHECK(chart.opposite(h) == (is_open ? -1 : closed.opposite(h)));
    CHECK(chart.is_border(h) == is_open);
    border += is_open;
    CHECK(chart.origins()[chart.source(h)] == closed.source(h));
  }
  // Corner_table vertices are the classes of corners.
  const std::vector<int> classes = corner_classes(closed, open);
  std::map<int, int> vertex_of_class;
  std::set<int> vertices;
  for(int h = 0; h < int(classes.size()); ++h)
  {
    const int v = vertex_of_class.emplace(classes[h], chart.source(h)).first->second;
    CHECK(v == chart.source(h));
    vertices.insert(v);
  }
  CHECK(vertices.size() == vertex_of_class.size());
  CHECK(int(vertices.size()) == chart.number_of_vertices());
  // The corners of each vertex form one fan, with at most one border halfedge in and out.
  std::map<int, int> leaving;
  for(int h = 0; h < int(classes.size()); ++h)
    if(chart.is_border(h))
      CHECK(++leaving[chart.source(h)] == 1);
  // Euler characteristic and borders.
  const int edges = (int(chart.opposites().size()) + border) / 2;
  CHECK(chart.euler_characteristic() == int(vertices.size()) - edges + chart.number_of_triangles());
  int length = 0;
  for(const std::vector<int>& loop : chart.border_loops())
  {
    length += int(loop.size());
    for(std::size_t i = 0; i < loop.size(); ++i)
    {
      CHECK(chart.is_border(loop[i]));
      CHECK(chart.target(loop[i]) == chart.source(loop[(i + 1) % loop.size()]));
    }
  }
  CHECK(length == border);
}

// Each part alone is the same as among the others.
void check_parts(const Corner_table& chart)
{
  const Connected_parts parts(chart.opposites());
  int number_of_vertices = 0;
  for(int part = 0; part < parts.number; ++part)
  {
    std::vector<int> triangles;
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      if(parts.part[t] == part)
        triangles.push_back(t);
    const Corner_table alone = chart.part(triangles);
    const auto halfedge = [&](int h) { return 3 * triangles[h / 3] + h % 3; };
    CHECK(alone.number_of_triangles() == int(triangles.size()));
    for(int h = 0; h < int(alone.opposites().size()); ++h)
    {
      CHECK(alone.origins()[alone.source(h)] == chart.origins()[chart.source(halfedge(h))]);
      CHECK((alone.is_border(h) ? -1 : halfedge(alone.opposite(h))) == chart.opposite(halfedge(h)));
    }
    number_of_vertices += alone.number_of_vertices();
  }
  CHECK(number_of_vertices == chart.number_of_vertices());
}

// A walk along edges of the surface, which may cross itself and repeat edges.
std::vector<int> random_path(const Corner_table& chart, int length, CGAL::Random& random)
{
  std::vector<int> path(1, random.get_int(0, int(chart.opposites().size())));
  while(int(path.size()) < length)
  {
    int h = next_halfedge(path.back()); // leaves the target
    for(int turns = random.get_int(0, 6); turns > 0; --turns)
      if(chart.next_around_source(h) >= 0)
        h = chart.next_around_source(h);
    path.push_back(h);
  }
  return path;
}

void test_cuts(const Corner_table& closed, CGAL::Random& random)
{
  CHECK(closed.border_loops().empty());
  Corner_table chart = closed;
  std::set<int> open;
  std::vector<Corner_table> states;
  std::vector<Corner_table::Opening> openings;
  for(int i = 0; i < 4; ++i)
  {
    const std::vector<int> path = random_path(chart, random.get_int(1, 12), random);
    states.push_back(chart);
    openings.push_back(chart.open(path));
    open.insert(path.begin(), path.end());
    check(chart, closed, open);
  }
  // All at once gives the same surface.
  Corner_table at_once = closed;
  at_once.open(std::vector<int>(open.begin(), open.end()));
  check(at_once, closed, open);
  std::vector<int> many(closed.opposites().size() / 2);
  for(int& h : many)
    h = random.get_int(0, int(closed.opposites().size()));
  at_once.open(many);
  check_parts(at_once);

  while(!openings.empty())
  {
    chart.close(openings.back());
    CHECK(chart.triangles() == states.back().triangles());
    CHECK(chart.opposites() == states.back().opposites());
    CHECK(chart.origins() == states.back().origins());
    openings.pop_back();
    states.pop_back();
  }
}

} // namespace chart_test

int main()
{
  using namespace chart_test;
  CGAL::Random random(3);
  for(int i = 0; i < 150; ++i)
  {
    test_cuts(torus(random.get_int(3, 9), random.get_int(3, 9)), random);
    test_cuts(sphere(random.get_int(1, 6), random.get_int(3, 12)), random);
  }
  CHECK(torus(4, 5).euler_characteristic() == 0);
  CHECK(sphere(4, 5).euler_characteristic() == 2);

  // Everything open: one disk per triangle.
  Corner_table chart = sphere(3, 4);
  std::vector<int> all(chart.opposites().size());
  std::iota(all.begin(), all.end(), 0);
  chart.open(all);
  CHECK(chart.number_of_vertices() == 3 * chart.number_of_triangles());
  CHECK(chart.euler_characteristic() == chart.number_of_triangles());
  return test::exit_status();
}
