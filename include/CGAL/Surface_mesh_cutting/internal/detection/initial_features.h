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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_INITIAL_FEATURES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_INITIAL_FEATURES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/detection/Candidate_disks.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The edges of some faces, but the forbidden ones, with their weights.
struct Region_graph
{
  Csr_graph graph;
  std::vector<int> edges; // of the mesh

  Region_graph(const Indexed_mesh& mesh, const Edge_constraints& constraints,
               const std::vector<char>& is_in_region)
  {
    const std::vector<char> is_in_graph = edges_of_faces(mesh, is_in_region);
    std::vector<CGAL::internal::Graph_kernel::Edge> weighted;
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      if(is_in_graph[e] && !constraints.is_forbidden(e))
      {
        weighted.push_back({mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e)),
                            constraints.weights[e]});
        edges.push_back(e);
      }
    graph = Csr_graph(mesh.number_of_vertices(), std::move(weighted));
  }

  // The largest set of the given vertices that the graph connects.
  std::vector<int> largest_connected_set(const std::vector<int>& vertices) const
  {
    CGAL::internal::Graph_kernel::Disjoint_sets sets(graph.number_of_vertices());
    for(const auto& edge : graph.edges)
      sets.unite(edge.source, edge.target);
    std::vector<int> sizes(graph.number_of_vertices(), 0);
    int largest = -1;
    for(int v : vertices)
    {
      const int set = sets.find(v);
      ++sizes[set];
      if(largest < 0 || sizes[set] > sizes[largest])
        largest = set;
    }
    std::vector<int> members;
    for(int v : vertices)
      if(sets.find(v) == largest)
        members.push_back(v);
    return members;
  }

  // The cut that connects the terminals by a minimum spanning tree of shortest paths (paper,
  // Section 3.2, [KMB81]).
  std::vector<int> metric_closure_cut(const std::vector<int>& terminals) const
  {
    std::vector<int> cut;
    for(int e : CGAL::internal::Steiner_tree::metric_closure_tree(graph, terminals).edges)
      cut.push_back(edges[e]);
    return cut;
  }
};

// From large to small, ties by index.
inline void sort_by_scope(std::vector<Candidate>& candidates)
{
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b)
            { return a.influence_radius != b.influence_radius ? a.influence_radius > b.influence_radius : a.vertex < b.vertex; });
}

// The start of the filtering: which candidates are features from the outset, which are to be judged,
// and the cut through the former.
struct Initial_features
{
  std::vector<int> features;  // connected by the cut
  std::vector<int> queue;     // to be judged, in this order
  std::vector<int> cut;       // edges
};

// The connected part of the faces outside all disks that touches most of `vertices`; returns those.
inline std::vector<int> richest_part(const Indexed_mesh& mesh, const Candidate_disks& disks,
                                     const std::vector<int>& vertices, std::vector<char>& is_in_part)
{
  const Surface_mesh_parameterization::internal::Connected_parts parts(
    mesh.opposites(), [&disks](int f) { return disks.is_covered(f); });

  // A vertex between several parts counts for each.
  std::vector<std::vector<int> > members(parts.number);
  for(int v : vertices)
    for(int a = mesh.graph().offsets[v]; a < mesh.graph().offsets[v + 1]; ++a)
    {
      const int h = mesh.halfedge(mesh.graph().arcs[a].edge);
      for(int side : {h, mesh.opposite(h)})
      {
        const int p = side < 0 ? -1 : parts.part[side / 3];
        if(p >= 0 && (members[p].empty() || members[p].back() != v))
          members[p].push_back(v);
      }
    }
  const auto richest = std::max_element(members.begin(), members.end(), [](const auto& a, const auto& b)
                                        { return a.size() < b.size(); });
  is_in_part.assign(mesh.number_of_faces(), 0);
  if(richest == members.end())
    return {};
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    is_in_part[f] = parts.part[f] == richest - members.begin();
  return *richest;
}

// Modified cut initialization (paper, Section 3.1.2): candidates with a large scope of influence are
// features; disks keep the cut through them away from the others. `disks` is left set. Needs at
// least two candidates, which edges that are not forbidden connect; the cut is empty otherwise.
inline Initial_features initialize_features(const Indexed_mesh& mesh, const Edge_constraints& constraints,
                                            std::vector<Candidate> candidates,
                                            const Cutting_parameters& parameters, Candidate_disks& disks)
{
  sort_by_scope(candidates);
  const double average = average_edge_length(mesh);
  double threshold = parameters.influence_threshold * average;
  while(true)
  {
    std::vector<int> large, small;
    for(const Candidate& c : candidates)
      (c.influence_radius > threshold ? large : small).push_back(c.vertex);
    disks.set(small, parameters.candidate_radius * average);
    std::vector<char> is_in_part;
    Initial_features initial;
    const std::vector<int> richest = richest_part(mesh, disks, large, is_in_part);
    const Region_graph region(mesh, constraints, is_in_part);
    initial.features = region.largest_connected_set(richest);
    if(initial.features.size() >= 2)
    {
      initial.cut = region.metric_closure_cut(initial.features);
      extend_single_edge(mesh, initial.cut, allowed_edges(mesh, constraints));
      // Features outside the part come first, then the others from large to small scope.
      for(int v : large)
        if(std::find(initial.features.begin(), initial.features.end(), v) == initial.features.end())
          initial.queue.push_back(v);
      initial.queue.insert(initial.queue.end(), small.begin(), small.end());
      return initial;
    }
    if(threshold < 0)
      return initial; // a surface without extent, on which all candidates are one
    threshold = small.empty() ? 0 : 0.5 * threshold;
    if(threshold <= 1e-6 * average) // few edges, and no scopes, are as short
      threshold = -1; // all are features, no disk is left
  }
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_INITIAL_FEATURES_H
