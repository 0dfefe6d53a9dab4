// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CONTRACTED_SURFACE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CONTRACTED_SURFACE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The graph of an opened surface in which each border loop is contracted to one node: moving along
// what is open already costs nothing. It lies on the closed surface of the same genus that closing
// each hole by a disk gives. Only edges that are not on the border remain; one between two vertices
// of the same loop is a self loop.
struct Contracted_surface
{
  std::vector<std::vector<int> > border_loops; // of the chart; loop i is node i
  std::vector<int> nodes;                      // per chart vertex
  std::vector<int> halfedges;                  // of the chart, one per edge of the graph
  Csr_graph graph;

  // `weight(h)` is the weight of the edge of the halfedge `h`. O(n).
  Contracted_surface(const Corner_table& chart, const std::function<double(int)>& weight)
    : border_loops(chart.border_loops()), nodes(chart.number_of_vertices(), -1)
  {
    int number_of_nodes = 0;
    for(const std::vector<int>& loop : border_loops)
    {
      for(int h : loop)
        nodes[chart.source(h)] = number_of_nodes;
      ++number_of_nodes;
    }
    for(int& node : nodes)
      if(node < 0)
        node = number_of_nodes++;

    std::vector<CGAL::internal::Graph_kernel::Edge> edges;
    edges.reserve(chart.opposites().size() / 2);
    halfedges.reserve(chart.opposites().size() / 2);
    for(int h = 0; h < int(chart.opposites().size()); ++h)
      if(h < chart.opposite(h))
      {
        halfedges.push_back(h);
        edges.push_back({nodes[chart.source(h)], nodes[chart.target(h)], weight(h)});
      }
    graph = Csr_graph(number_of_nodes, std::move(edges));
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CONTRACTED_SURFACE_H
