// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// A surface as the caller describes it: points, polygons, and the edges and vertices that are named.

#ifndef SURFACE_MESH_CUTTING_PYTHON_NAMED_SURFACE_H
#define SURFACE_MESH_CUTTING_PYTHON_NAMED_SURFACE_H

#include "Named_edges.h"
#include "array_views.h"

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Interpretation.h>
#include <CGAL/Surface_mesh_cutting/Polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Soup_adapter.h>

#include <vector>

namespace binding {

namespace SMC = CGAL::Surface_mesh_cutting;
using Finding = SMC::Finding<SMC::Polygon_soup>;
using Result_status = SMC::Result_status<SMC::Polygon_soup>;
using SMC::Status_code;
using SMC::internal::Go_further;
using SMC::internal::Soup_adapter;

// Results do not depend on it.
using Concurrency_tag = CGAL::Parallel_if_available_tag;

struct Surface_arguments
{
  Polygon_soup_view soup;
  SMC::internal::Welding welding;
  bool is_strict = false; // whether to refuse what would have to be interpreted
  // Two points for each edge.
  Indices mandatory_edges, forbidden_edges, initial_cut, weighted_edges;
  Numbers edge_weights; // of `weighted_edges`
  bool has_weights = false;
  Indices terminals;
};

// Why a surface, or what is named in it, is refused.
struct Refusal
{
  Finding finding;
};

class Named_surface
{
public:
  explicit Named_surface(const Surface_arguments& arguments) : m_arguments(arguments) {}

  // Reads the surface and finds in it what the caller names; throws a `Refusal`. The status of the result may be an
  // error, too. To be called once.
  Soup_adapter read(const Go_further& go_further = SMC::internal::always_go_further);

  const Surface_arguments& arguments() const { return m_arguments; }
  const std::vector<SMC::Interpretation>& interpreted() const { return m_interpreted; }

  Edge_marks mandatory_edges() const { return {&m_mandatory}; }
  Edge_marks forbidden_edges() const { return {&m_forbidden}; }
  Edge_marks initial_cut() const { return {&m_initial_cut}; }
  Edge_weights edge_weights() const { return {&m_weighted, m_arguments.edge_weights, m_arguments.soup.coordinates}; }
  Vertex_marks terminals() const { return {&m_is_terminal}; }

private:
  void check_size() const;
  void check_strictly() const;
  std::vector<std::size_t> representatives(const Soup_adapter& adapter) const;
  Named_edges find(const char* name, const Indices& pairs, const Soup_adapter& adapter) const;
  void find_terminals(const Soup_adapter& adapter);

  const Surface_arguments& m_arguments;
  std::vector<SMC::Interpretation> m_interpreted;
  std::vector<std::size_t> m_representatives; // of the points: the same unless they are welded
  Named_edges m_mandatory, m_forbidden, m_initial_cut, m_weighted;
  std::vector<char> m_is_terminal; // per point; empty if there is none
};

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_NAMED_SURFACE_H
