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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_FIND_SYMMETRIES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_FIND_SYMMETRIES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Symmetry.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Indexed_symmetry.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Mesh_involution.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Reflection_search.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Vertices that are each other's closest ones after a reflection.
inline std::vector<int> mutual(const std::vector<int>& nearest)
{
  std::vector<int> images(nearest.size(), -1);
  for(std::size_t v = 0; v < nearest.size(); ++v)
    if(nearest[v] >= 0 && nearest[nearest[v]] == int(v))
      images[v] = nearest[v];
  return images;
}

// The diagonals, and edges that have no edge as their image.
inline Cut unmirrored_edges(const Indexed_mesh& mesh, const Cut& diagonals, const std::vector<int>& images)
{
  const Csr_graph& graph = mesh.graph();
  const auto has_edge = [&](int v, int w)
  {
    for(int a = graph.offsets[v]; a < graph.offsets[v + 1]; ++a)
      if(graph.arcs[a].target == w && (diagonals.empty() || !diagonals[graph.arcs[a].edge]))
        return true;
    return false;
  };
  Cut result(mesh.number_of_edges(), 0);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    const int v = images[mesh.source(mesh.halfedge(e))], w = images[mesh.target(mesh.halfedge(e))];
    result[e] = (!diagonals.empty() && diagonals[e]) || (!mesh.is_border_edge(e) && (v < 0 || w < 0 || !has_edge(v, w)));
  }
  return result;
}

// Fills in the images if the reflection maps the mesh to itself; edges that are `left_out` have none.
inline bool find_images(const Indexed_mesh& mesh, const Cut& left_out, const std::vector<int>& nearest, double tolerance,
                        Indexed_symmetry& symmetry)
{
  const Mesh_involution involution(mesh, left_out, nearest, symmetry.reflection, tolerance);
  if(!involution.is_complete())
    return false;
  symmetry.is_exact = true;
  symmetry.reflection = involution.best_reflection();
  symmetry.images = involution.vertex_images();
  symmetry.edge_images.assign(mesh.number_of_edges(), -1);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(left_out.empty() || !left_out[e])
      symmetry.edge_images[e] = involution.edge_image(e);
  return true;
}

// The symmetry at a plane; its place gets exact where it maps the mesh to itself. Meshes that were mirrored as quadrangles and
// divided later have only vertices and some edges mirrored: the other edges then count as diagonals.
inline Indexed_symmetry symmetry_at(const Indexed_mesh& mesh, const Cut& diagonals, const Reflection_search& search,
                                    const Reflection& reflection)
{
  Indexed_symmetry symmetry;
  symmetry.reflection = reflection;
  const Reflection_search::Matches matches = search.matches(reflection);
  symmetry.matched = matches.share;
  if(!symmetry.is_symmetry() || find_images(mesh, diagonals, matches.nearest, search.tolerance(), symmetry))
    return symmetry;
  symmetry.images = mutual(matches.nearest);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(symmetry.images[v] < 0 && !mesh.is_isolated(v))
      return symmetry;
  const std::vector<int> images = symmetry.images;
  find_images(mesh, unmirrored_edges(mesh, diagonals, images), images, search.tolerance(), symmetry);
  return symmetry;
}

// How far the surface extends from the plane on average, by its vertices.
inline double mean_height(const Indexed_mesh& mesh, const Reflection& reflection)
{
  double sum = 0;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(!mesh.is_isolated(v))
      sum += std::abs(reflection.signed_distance(mesh.point(v)));
  return sum / mesh.number_of_vertices();
}

// From good to bad, at planes that differ: exact ones, then those that match more; among equals, the one to which the surface
// is closest, which for most things is that between left and right. The first one may be no symmetry; no other one is.
inline std::vector<Indexed_symmetry> find_symmetries(const Indexed_mesh& mesh, const Cut& diagonals, Symmetry choice,
                                                     Execution execution)
{
  const Reflection_search search(mesh, execution);
  std::vector<std::pair<std::tuple<bool, double, double>, Indexed_symmetry> > order;
  const std::vector<Reflection> planes
    = choice == Symmetry::AUTOMATIC ? search.planes()
                                    : search.planes(Eigen::Vector3d::Unit(int(choice) - int(Symmetry::X)));
  for(const Reflection& plane : planes)
  {
    Indexed_symmetry found = symmetry_at(mesh, diagonals, search, plane);
    const double unmatched = 1 - found.matched;
    order.emplace_back(std::make_tuple(!found.is_exact, unmatched, mean_height(mesh, found.reflection)), std::move(found));
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Indexed_symmetry> result;
  for(auto& [rank, found] : order)
    if(result.empty() || found.is_symmetry())
      result.push_back(std::move(found));
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_FIND_SYMMETRIES_H
