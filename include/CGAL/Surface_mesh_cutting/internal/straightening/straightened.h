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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_STRAIGHTENED_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_STRAIGHTENED_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Key_paths.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/straightening/Straight_ways.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A way of a cut, and a straighter one with the same ends.
struct Straightening
{
  std::vector<int> former, next; // edges

  void apply_to(Cut& cut) const
  {
    for(const int e : former)
      cut[e] = 0;
    for(const int e : next)
      cut[e] = 1;
  }
};

// Straighter ways between the forks and ends of a cut, and the vertices that are kept. All of them together, or any of them, raise
// its cost by at most `share`: what one way does not use of it is left to the next ones.
inline std::vector<Straightening> straightenings(const Indexed_mesh& mesh, const Edge_constraints& constraints, const Cut& cut,
                                                 const std::vector<char>& is_kept, double share)
{
  std::vector<Straightening> result;
  std::vector<char> is_open = open_vertices(mesh, cut);
  const auto mark = [&](int v, const std::vector<int>& edges, char value)
  {
    for(std::size_t i = 0; i + 1 < edges.size(); ++i)
      is_open[v = mesh.graph().opposite(edges[i], v)] = value;
  };
  Straight_ways ways(mesh, constraints);
  const Key_paths paths(mesh, cut, is_kept);
  double allowance = 0;
  for(const Key_paths::Path& path : paths.paths())
  {
    const double cost = total_cost(constraints, path.edges);
    allowance += share * cost;
    mark(path.source, path.edges, 0);
    std::vector<int> next = ways.straighter(path, is_open, cost + allowance);
    mark(path.source, path.edges, 1);
    if(next.empty())
      continue;
    allowance = (std::max)(0., allowance) - (std::max)(0., total_cost(constraints, next) - cost);
    mark(path.source, next, 1);
    result.push_back({path.edges, std::move(next)});
  }
  return result;
}

// The cut with all of them.
inline Cut straightened(const Indexed_mesh& mesh, const Edge_constraints& constraints, Cut cut, const std::vector<char>& is_kept,
                        double share)
{
  for(const Straightening& s : straightenings(mesh, constraints, cut, is_kept, share))
    s.apply_to(cut);
  return cut;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_STRAIGHTENED_H
