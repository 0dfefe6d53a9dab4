#ifndef EDGE_GRAPH_H
#define EDGE_GRAPH_H

#include <CGAL/Bbox_3.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

struct Edge_graph
{
  CGAL::internal::Graph_kernel::Csr_graph graph;
  double diagonal; // of the bounding box
};

// the edges of a surface, with their lengths
inline Edge_graph read_edge_graph(const std::string& file)
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  if(!CGAL::IO::read_polygon_soup(file, points, faces))
    throw std::runtime_error("cannot read " + file);
  std::vector<std::pair<int, int>> ends;
  for(const std::vector<std::size_t>& face : faces)
    for(std::size_t i = 0; i < face.size(); ++i)
      ends.push_back(std::minmax(int(face[i]), int(face[(i + 1) % face.size()])));
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<CGAL::internal::Graph_kernel::Edge> edges;
  for(const std::pair<int, int>& e : ends)
    edges.push_back({e.first, e.second, std::sqrt(CGAL::squared_distance(points[e.first], points[e.second]))});
  CGAL::Bbox_3 box;
  for(const Point& p : points)
    box += p.bbox();
  return Edge_graph{CGAL::internal::Graph_kernel::Csr_graph(int(points.size()), edges),
                    std::sqrt(std::pow(box.x_span(), 2) + std::pow(box.y_span(), 2) + std::pow(box.z_span(), 2))};
}

// k different vertices that have edges, or all of them if there are not as many
inline std::vector<int> random_terminals(const CGAL::internal::Graph_kernel::Csr_graph& graph, int k,
                                         CGAL::Random& random)
{
  int number = 0;
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    number += graph.degree(v) > 0;
  k = (std::min)(k, number);
  std::vector<char> is_taken(graph.number_of_vertices(), 0);
  std::vector<int> terminals;
  while(int(terminals.size()) < k) {
    const int v = random.get_int(0, graph.number_of_vertices());
    if(!is_taken[v] && graph.degree(v) > 0) {
      is_taken[v] = 1;
      terminals.push_back(v);
    }
  }
  return terminals;
}

// processor time of the program so far
inline double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

#endif // EDGE_GRAPH_H
