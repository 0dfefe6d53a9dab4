#ifndef MESH_GRAPHS_H
#define MESH_GRAPHS_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>

#include <CGAL/Random.h>

#include <cmath>
#include <vector>

// the edge graph of a triangulated grid whose points are moved at random by up to `noise` times half the spacing
inline CGAL::internal::Graph_kernel::Csr_graph grid_graph(int width, int height, double noise, CGAL::Random& random)
{
  std::vector<double> x, y;
  for(int j = 0; j < height; ++j)
    for(int i = 0; i < width; ++i) {
      x.push_back(i + noise * random.get_double(-0.5, 0.5));
      y.push_back(j + noise * random.get_double(-0.5, 0.5));
    }
  std::vector<CGAL::internal::Graph_kernel::Edge> edges;
  const auto add = [&](int v, int w) {
    edges.push_back(CGAL::internal::Graph_kernel::Edge{v, w, std::hypot(x[v] - x[w], y[v] - y[w])});
  };
  for(int j = 0; j < height; ++j)
    for(int i = 0; i < width; ++i) {
      const int v = j * width + i;
      if(i + 1 < width)
        add(v, v + 1);
      if(j + 1 < height)
        add(v, v + width);
      if(i + 1 < width && j + 1 < height)
        add(v, v + width + 1);
    }
  return CGAL::internal::Graph_kernel::Csr_graph(width * height, edges);
}

inline std::vector<int> random_terminals(int number_of_vertices, int k, CGAL::Random& random)
{
  std::vector<char> is_taken(number_of_vertices, 0);
  std::vector<int> terminals;
  while(int(terminals.size()) < k) {
    const int v = random.get_int(0, number_of_vertices);
    if(!is_taken[v]) {
      is_taken[v] = 1;
      terminals.push_back(v);
    }
  }
  return terminals;
}

#endif // MESH_GRAPHS_H
