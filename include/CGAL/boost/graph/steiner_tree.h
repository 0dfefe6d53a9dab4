// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_BOOST_GRAPH_STEINER_TREE_H
#define CGAL_BOOST_GRAPH_STEINER_TREE_H

#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure_of_graph.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#ifndef CGAL_SURFACE_MESH_CUTTING_NAMED_PARAMETERS
#  error "the include directory of Surface_mesh_cutting must precede that of CGAL"
#endif

namespace CGAL {

/// methods, status codes, and the default visitor of `CGAL::steiner_tree()`
namespace Steiner_tree {

/// \addtogroup PkgSurfaceMeshCuttingSteinerTreesRef
/// @{

/// the minimum spanning tree of the metric closure of the terminals (Kou, Markowsky and Berman): at most twice
/// as long as the shortest tree. \f$ O((m + n) \log n) \f$ time and \f$ O(m + n) \f$ memory
struct Metric_closure_tag
{
/// \cond SKIP_IN_MANUAL
  static constexpr internal::Steiner_tree::Method method = internal::Steiner_tree::Method::metric_closure;
  static constexpr bool needs_proof = false;
/// \endcond
};

/// grows a tree from the nearest pair of terminals, always by a shortest path to the nearest terminal outside
/// (Takahashi and Matsuyama): at most twice as long as the shortest tree. \f$ O(k (m + n) \log n) \f$ time and
/// \f$ O(m + n) \f$ memory
struct Shortest_path_heuristic_tag
{
/// \cond SKIP_IN_MANUAL
  static constexpr internal::Steiner_tree::Method method = internal::Steiner_tree::Method::shortest_path_heuristic;
  static constexpr bool needs_proof = false;
/// \endcond
};

/// adds auxiliary points one by one, each time the one that shortens the minimum spanning tree of the metric
/// closure most, until none shortens it by more than `minimum_length_decrease`. Then connects all points.
/// \f$ O((k + a) (m + n) \log n + a (k + a) n) \f$ time for \f$ a \f$ auxiliary points and
/// \f$ O(m + (k + a) n) \f$ memory
/// \tparam ConnectionTag how to connect the points in the end: `Metric_closure_tag` or `Shortest_path_heuristic_tag`
template <typename ConnectionTag = Metric_closure_tag>
struct Greedy_auxiliary_points_tag
{
/// \cond SKIP_IN_MANUAL
  static constexpr internal::Steiner_tree::Method method =
    ConnectionTag::method == internal::Steiner_tree::Method::metric_closure
      ? internal::Steiner_tree::Method::greedy_auxiliary_points
      : internal::Steiner_tree::Method::greedy_auxiliary_points_and_shortest_paths;
  static constexpr bool needs_proof = false;
/// \endcond
};

/// inserts auxiliary points greedily, however little they shorten the tree. Then, as a local search, removes points
/// and inserts others as long as that shortens the tree. Much closer to a shortest tree than the other heuristics,
/// at a few times the cost of `Greedy_auxiliary_points_tag` and with as much memory
struct Local_search_tag
{
/// \cond SKIP_IN_MANUAL
  static constexpr internal::Steiner_tree::Method method = internal::Steiner_tree::Method::local_search;
  static constexpr bool needs_proof = false;
/// \endcond
};

/// a shortest tree, by a dynamic program that leaves out what lower bounds and separators exclude. Exceeding
/// `maximum_number_of_states` is an error, but the best tree found is still reported
struct Exact_tag
{
/// \cond SKIP_IN_MANUAL
  static constexpr internal::Steiner_tree::Method method = internal::Steiner_tree::Method::exact;
  static constexpr bool needs_proof = true;
/// \endcond
};

/// a shortest tree if `maximum_number_of_states` suffices to find and to prove it, otherwise the best tree found, with a
/// lower bound: by local search over auxiliary points or, in large graphs, by searching corridors around good trees.
/// Beyond 256 terminals, which the dynamic program does not serve, by local search over auxiliary points near the
/// terminals, in \f$ O(m \log n) \f$ time for each round. The default
struct Best_tag
{
/// \cond SKIP_IN_MANUAL
  static constexpr internal::Steiner_tree::Method method = internal::Steiner_tree::Method::exact;
  static constexpr bool needs_proof = false;
/// \endcond
};

/// tells whether the requested tree was found, and if not, why
enum class Result_status
{
  OK,                      ///< a tree as requested
  TERMINALS_NOT_CONNECTED, ///< terminals lie in several components of the graph: no tree
  INVALID_WEIGHT,          ///< an edge weight is negative, infinite, or not a number: no tree
  BUDGET_EXCEEDED,         ///< the exact method ran out of states; the tree is not proven shortest
  CANCELLED                ///< the visitor asked to stop; the tree is the best found by then
};

/// the visitor that never stops
/// \cgalModels{SteinerTreeVisitor}
struct Default_visitor
{
  /// returns `false` to cancel; called often, but by one thread at a time
  bool go_further() const { return true; }
};

/// what `CGAL::steiner_tree()` found
struct Result
{
  /// whether there is a tree as requested
  Result_status status = Result_status::OK;
  /// the sum of the weights of the edges of the tree
  double length = 0.;
  /// a lower bound on the length of any tree, up to rounding. Zero for methods without a bound
  double lower_bound = 0.;
  /// whether the tree is proven shortest
  bool is_optimal = false;
  /// the number of vertices of the tree of degree three or more that are not terminals
  std::size_t number_of_auxiliary_points = 0;

  /// `true` if the status is `Result_status::OK`
  explicit operator bool() const { return status == Result_status::OK; }
};

/// @}

} // namespace Steiner_tree

/*!
\ingroup PkgSurfaceMeshCuttingSteinerTreesRef

computes a short or shortest tree in a graph that connects some of its vertices, the *terminals*.

The graph counts as undirected: the tree may use edges in both directions. The graph may have several components,
parallel edges, self loops, and edges of weight zero. Terminals may be repeated. For one terminal or none, the tree is
empty. The tree has no cycle, and all its leaves are terminals. It depends on the order of the vertices and edges of
the graph, but not on the number of threads.

A tree counts as optimal if none is shorter by more than \f$ 10^{-10} \f$ times its length or, if all weights are
integers, if none is shorter.

With \f$ n \f$ vertices, \f$ m \f$ edges, and \f$ k \f$ terminals, the documentation of each tag states the time and
memory of its method. The exact method needs time exponential in \f$ k \f$ in the worst case, yet tens of terminals are
usually feasible on graphs of surfaces. `maximum_number_of_states` bounds its memory (about 50 bytes per state).

\tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default), `Parallel_tag`, or
        `Parallel_if_available_tag`. The result does not depend on it.
\tparam Graph a model of `VertexListGraph` and `EdgeListGraph`
\tparam TerminalRange a range of vertex descriptors of `Graph`, a model of `ConstRange`
\tparam EdgeOutputIterator a model of `OutputIterator` that accepts edge descriptors of `Graph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param graph the graph
\param terminals the vertices to connect
\param tree_edges receives the edges of the tree, in the order of the graph's edges
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{algorithm}
    \cgalParamDescription{the method}
    \cgalParamType{one of the tags in the namespace `CGAL::Steiner_tree`}
    \cgalParamDefault{`CGAL::Steiner_tree::Best_tag`}
  \cgalParamNEnd

  \cgalParamNBegin{edge_weight_map}
    \cgalParamDescription{a property map that associates to each edge its weight, which must be finite and not negative}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<Graph>::%edge_descriptor` as key
                   type and a number type as value type}
    \cgalParamDefault{`get(boost::edge_weight, graph)`}
  \cgalParamNEnd

  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map that associates to each vertex a unique index that is not negative. Memory is
                          proportional to the largest one.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<Graph>::%vertex_descriptor` as key
                   type and an integral type as value type}
    \cgalParamDefault{`get(boost::vertex_index, graph)`}
  \cgalParamNEnd

  \cgalParamNBegin{minimum_length_decrease}
    \cgalParamDescription{the decrease of the length of the tree, as an absolute value, that makes an auxiliary point
                          worth adding. Only `CGAL::Steiner_tree::Greedy_auxiliary_points_tag` uses it.}
    \cgalParamType{`double`}
    \cgalParamDefault{`0`}
  \cgalParamNEnd

  \cgalParamNBegin{maximum_number_of_states}
    \cgalParamDescription{the number of states after which the dynamic program gives up. It counts states, not
                          seconds, so that results are reproducible.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{`20000000`}
  \cgalParamNEnd

  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that can cancel the computation}
    \cgalParamType{a class model of `SteinerTreeVisitor`; pass it by `std::ref` unless a copy will do}
    \cgalParamDefault{`CGAL::Steiner_tree::Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the length of the tree, what is known about it, and a status, which converts to `true` if all is well.
        No edge is output if there is no tree, see `CGAL::Steiner_tree::Result_status`.
*/
template <typename ConcurrencyTag = Sequential_tag,
          typename Graph,
          typename TerminalRange,
          typename EdgeOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
Steiner_tree::Result steiner_tree(const Graph& graph, const TerminalRange& terminals, EdgeOutputIterator tree_edges,
                                  const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  namespace Core = internal::Steiner_tree;
  typedef typename boost::graph_traits<Graph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Graph>::edge_descriptor edge_descriptor;
  typedef typename internal_np::Lookup_named_param_def<internal_np::algorithm_t, NamedParameters,
                                                       Steiner_tree::Best_tag>::type Method_tag;
  Steiner_tree::Default_visitor default_visitor;
  typedef typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters,
                                                       Steiner_tree::Default_visitor>::reference Visitor_reference;
  Visitor_reference visitor = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  const auto index = choose_parameter(get_parameter(np, internal_np::vertex_index), get(boost::vertex_index, graph));
  const auto weight = choose_parameter(get_parameter(np, internal_np::edge_weight), get(boost::edge_weight, graph));

  Core::Options options;
  options.method = Method_tag::method;
  options.minimum_length_decrease =
    choose_parameter(get_parameter(np, internal_np::minimum_length_decrease), options.minimum_length_decrease);
  options.maximum_number_of_states =
    choose_parameter(get_parameter(np, internal_np::maximum_number_of_states), options.maximum_number_of_states);

  // the vertices by consecutive numbers, whatever their indices
  std::vector<int> number;
  int number_of_vertices = 0;
  for(vertex_descriptor v : CGAL::make_range(vertices(graph))) {
    const std::size_t i = std::size_t(get(index, v));
    if(i >= number.size())
      number.resize((std::max)(i + 1, number.size() + number.size() / 2), -1);
    number[i] = number_of_vertices++;
  }
  const auto number_of = [&](vertex_descriptor v) { return number[std::size_t(get(index, v))]; };

  Steiner_tree::Result result;
  std::vector<edge_descriptor> edge_of;
  std::vector<Core::Edge> indexed_edges;
  for(edge_descriptor e : CGAL::make_range(edges(graph))) {
    const double w = CGAL::to_double(get(weight, e));
    if(!(w >= 0. && std::isfinite(w))) {
      result.status = Steiner_tree::Result_status::INVALID_WEIGHT;
      return result;
    }
    edge_of.push_back(e);
    indexed_edges.push_back(Core::Edge{number_of(source(e, graph)), number_of(target(e, graph)), w});
  }
  const Core::Csr_graph indexed_graph(number_of_vertices, std::move(indexed_edges));

  std::vector<vertex_descriptor> different_terminals;
  std::vector<int> indexed_terminals;
  std::vector<char> is_terminal(number_of_vertices, 0);
  for(vertex_descriptor v : terminals)
    if(!is_terminal[number_of(v)]) {
      is_terminal[number_of(v)] = 1;
      different_terminals.push_back(v);
      indexed_terminals.push_back(number_of(v));
    }

  const auto go_further = [&] { return bool(visitor.go_further()); };
  Core::Solution solution;
  if constexpr(Method_tag::method == Core::Method::metric_closure && Core::is_searched_by_boost<Graph>()) {
    const auto weight_of = [&](edge_descriptor e) { return CGAL::to_double(get(weight, e)); };
    solution = Core::solve_on_graph(graph, different_terminals, boost::make_function_property_map<edge_descriptor>(weight_of),
                                    boost::make_function_property_map<vertex_descriptor>(number_of), indexed_graph,
                                    indexed_terminals, go_further);
  }
  else
    solution = Core::solve(indexed_graph, indexed_terminals, options,
                           internal::Graph_kernel::execution_of<ConcurrencyTag>(), go_further);
  switch(solution.outcome) {
  case Core::Outcome::done:
    break;
  case Core::Outcome::terminals_not_connected:
    result.status = Steiner_tree::Result_status::TERMINALS_NOT_CONNECTED;
    return result;
  case Core::Outcome::budget_exceeded:
    if(Method_tag::needs_proof)
      result.status = Steiner_tree::Result_status::BUDGET_EXCEEDED;
    break;
  case Core::Outcome::cancelled:
    result.status = Steiner_tree::Result_status::CANCELLED;
    break;
  }
  result.length = solution.tree.length;
  result.lower_bound = solution.lower_bound;
  result.is_optimal = solution.is_optimal;
  result.number_of_auxiliary_points = Core::branch_vertices(indexed_graph, indexed_terminals, solution.tree).size();
  for(int e : solution.tree.edges)
    *tree_edges++ = edge_of[e];
  return result;
}

} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_STEINER_TREE_H
