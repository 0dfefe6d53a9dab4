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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_ARE_CONNECTED_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_ARE_CONNECTED_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Disjoint_sets.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// whether the vertices are connected by edges for which `uses(edge)` is true
template <typename Uses>
bool are_connected(const Csr_graph& graph, const std::vector<int>& vertices, const Uses& uses)
{
  Disjoint_sets components(graph.number_of_vertices());
  for(int e = 0; e < graph.number_of_edges(); ++e)
    if(uses(e))
      components.unite(graph.edges[e].source, graph.edges[e].target);
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](int v) { return components.find(v) == components.find(vertices.front()); });
}

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_ARE_CONNECTED_H
