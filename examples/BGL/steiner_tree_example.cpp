#include <CGAL/boost/graph/steiner_tree.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                              boost::property<boost::edge_weight_t, double>> Graph;
typedef boost::graph_traits<Graph>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Graph>::edge_descriptor   edge_descriptor;

int main()
{
  // a ring road with four towns, and a junction in its middle
  Graph graph(5);
  const vertex_descriptor junction = 4;
  for(vertex_descriptor town = 0; town < 4; ++town) {
    add_edge(town, (town + 1) % 4, 10., graph);
    add_edge(town, junction, 7., graph);
  }
  const std::vector<vertex_descriptor> towns = {0, 1, 2, 3};

  std::vector<edge_descriptor> ring, tree;
  const CGAL::Steiner_tree::Result simple = CGAL::steiner_tree(graph, towns, std::back_inserter(ring),
    CGAL::parameters::algorithm(CGAL::Steiner_tree::Metric_closure_tag()));
  const CGAL::Steiner_tree::Result best = CGAL::steiner_tree(graph, towns, std::back_inserter(tree));
  if(!simple || !best)
    return EXIT_FAILURE;

  std::cout << "between towns only: " << simple.length << "\n"
            << "shortest: " << best.length << (best.is_optimal ? " (proven)" : "") << ", with "
            << best.number_of_auxiliary_points << " junction\n";
  for(edge_descriptor e : tree)
    std::cout << source(e, graph) << " - " << target(e, graph) << "\n";
  return EXIT_SUCCESS;
}
