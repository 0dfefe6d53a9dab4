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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_SEAMS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_SEAMS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/internal/Graph_kernel/spanning_forest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A run of edges between the same two parts of a divided chart.
struct Chart_seam
{
  double cost = 0;
  std::pair<int, int> parts;
  std::vector<int> edges;
};

// Takes off a cut what is left of `paths` where it ends inside of a part: once parts that met there are one, it separates
// nothing.
inline void close_dead_ends(const std::vector<std::vector<int> >& paths, const Indexed_mesh& mesh, Cut& cut)
{
  std::vector<int> edges;
  for(const std::vector<int>& path : paths)
    for(int e : path)
      if(std::exchange(cut[e], char(0)))
        edges.push_back(e);
  std::sort(edges.begin(), edges.end());
  CGAL::internal::Graph_kernel::prune_leaves(mesh.graph(), open_vertices(mesh, cut), edges);
  for(int e : edges)
    cut[e] = 1;
}

// Takes together what follows each other between the same two parts: where nothing else ends between two pieces, one cannot be
// closed without the other.
inline std::vector<Chart_seam> whole_seams(std::vector<Chart_seam> pieces, const Indexed_mesh& mesh, const Cut& cut)
{
  std::vector<std::pair<int, int> > touched; // vertices, and pieces with an edge there
  for(std::size_t i = 0; i < pieces.size(); ++i)
    for(int e : pieces[i].edges)
      for(int v : {mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e))})
        touched.emplace_back(v, int(i));
  std::sort(touched.begin(), touched.end());
  const std::vector<int> degrees = cut_degrees(mesh, cut);
  const std::vector<char> is_on_border = open_vertices(mesh, Cut(mesh.number_of_edges(), 0));
  CGAL::internal::Graph_kernel::Disjoint_sets seams{int(pieces.size())};
  for(std::size_t k = 1; k < touched.size(); ++k)
  {
    const auto [u, i] = touched[k - 1];
    const auto [v, j] = touched[k];
    if(u == v && i != j && pieces[i].parts == pieces[j].parts && degrees[v] == 2 && !is_on_border[v])
      seams.unite(i, j);
  }
  std::vector<Chart_seam> result;
  std::vector<int> places(pieces.size());
  for(std::size_t i = 0; i < pieces.size(); ++i)
    if(const int first = seams.find(int(i)); first == int(i))
    {
      places[i] = int(result.size());
      result.push_back(std::move(pieces[i]));
    }
    else
    {
      Chart_seam& seam = result[places[first]];
      seam.cost += pieces[i].cost;
      seam.edges.insert(seam.edges.end(), pieces[i].edges.begin(), pieces[i].edges.end());
    }
  return result;
}

// Those along `paths` between two parts, in order. `cut`: what the parts are divided by.
inline std::vector<Chart_seam> seams_along(const std::vector<std::vector<int> >& paths, const Problem& problem, const Cut& cut,
                                           const Surface_mesh_parameterization::internal::Connected_parts& parts)
{
  std::vector<Chart_seam> pieces;
  for(const std::vector<int>& path : paths)
  {
    bool goes_on = false;
    for(int e : path)
    {
      const int h = problem.mesh.halfedge(e);
      const std::pair<int, int> sides = std::minmax(parts.part[h / 3], parts.part[problem.mesh.opposite(h) / 3]);
      if(sides.first == sides.second)
      {
        goes_on = false;
        continue;
      }
      if(!goes_on || pieces.back().parts != sides)
        pieces.push_back({0, sides, {}});
      goes_on = true;
      pieces.back().cost += problem.constraints.weights[e];
      pieces.back().edges.push_back(e);
    }
  }
  return whole_seams(std::move(pieces), problem.mesh, cut);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_SEAMS_H
