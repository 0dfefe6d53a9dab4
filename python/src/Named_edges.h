// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Edges of a surface that the caller names by pairs of points, in any direction.

#ifndef SURFACE_MESH_CUTTING_PYTHON_NAMED_EDGES_H
#define SURFACE_MESH_CUTTING_PYTHON_NAMED_EDGES_H

#include "array_views.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace binding {

using Edge = std::pair<std::size_t, std::size_t>; // the lower point first

class Named_edges
{
public:
  Named_edges() = default;

  // Two points for each edge, which stand for those of `representatives`. All are in range.
  Named_edges(const Indices& pairs, const std::vector<std::size_t>& representatives);

  bool is_empty() const { return m_edges.empty(); }

  // Where the caller names an edge, for the last time, or -1.
  std::ptrdiff_t position(const Edge& edge) const;

  // What is left without the edges `others`, ordered.
  std::vector<Edge> without(std::vector<Edge> others) const;

private:
  std::vector<std::pair<Edge, std::ptrdiff_t> > m_edges; // ordered, each once
};

// Property maps that the library reads.
struct Edge_marks
{
  const Named_edges* edges;

  friend bool get(const Edge_marks& map, const Edge& edge) { return map.edges->position(edge) >= 0; }
};

struct Vertex_marks
{
  const std::vector<char>* marks;

  friend bool get(const Vertex_marks& map, std::size_t v) { return !map.marks->empty() && (*map.marks)[v]; }
};

// Those of the caller; other edges have their length.
struct Edge_weights
{
  const Named_edges* edges;
  Numbers weights, coordinates;

  friend double get(const Edge_weights& map, const Edge& edge) { return map.weight(edge); }

private:
  double weight(const Edge& edge) const;
};

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_NAMED_EDGES_H
