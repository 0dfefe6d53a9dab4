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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_LEAF_BRANCHES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_LEAF_BRANCHES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A path of a cut from a tip, where the cut ends inside the surface, to where the cut forks, comes to
// a border or passes a vertex that is to stay on it.
struct Leaf_branch
{
  std::vector<int> vertices; // from the tip
  std::vector<int> edges;    // edges[i] joins vertices[i] and vertices[i+1]
};

// All such paths, in the order of their tips' indices. A path with two tips is found from both.
// `is_end` tells, per vertex, where they end in any case; O(n).
inline std::vector<Leaf_branch> leaf_branches(const Indexed_mesh& mesh, const Cut& cut, const std::vector<char>& is_end)
{
  const std::vector<int> degree = cut_degrees(mesh, cut);
  const std::vector<char> is_on_border = open_vertices(mesh, Cut(mesh.number_of_edges(), 0));
  std::vector<Leaf_branch> branches;
  for(int tip = 0; tip < mesh.number_of_vertices(); ++tip)
  {
    if(degree[tip] != 1 || is_on_border[tip])
      continue;
    Leaf_branch branch{{tip}, {}};
    int previous = -1;
    do
    {
      const int v = branch.vertices.back();
      for(int a = mesh.graph().offsets[v]; a < mesh.graph().offsets[v + 1]; ++a)
      {
        const auto& arc = mesh.graph().arcs[a];
        if(cut[arc.edge] && arc.edge != previous)
        {
          branch.vertices.push_back(arc.target);
          branch.edges.push_back(arc.edge);
          break;
        }
      }
      previous = branch.edges.back();
    }
    while(degree[branch.vertices.back()] == 2 && !is_on_border[branch.vertices.back()] &&
          !is_end[branch.vertices.back()]);
    branches.push_back(std::move(branch));
  }
  return branches;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_LEAF_BRANCHES_H
