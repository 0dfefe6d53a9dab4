// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "Named_surface.h"

#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace binding {

namespace {

[[noreturn]] void refuse(Status_code code, std::string message, Finding elements = {})
{
  elements.code = code;
  elements.message = std::move(message);
  throw Refusal{std::move(elements)};
}

const char* description(SMC::Interpretation_kind kind)
{
  switch(kind)
  {
  case SMC::Interpretation_kind::NON_MANIFOLD_EDGES:    return "edges with more than two polygons";
  case SMC::Interpretation_kind::NON_MANIFOLD_VERTICES: return "vertices whose polygons form several fans";
  case SMC::Interpretation_kind::REORIENTED_FACES:      return "polygons that are oriented unlike their neighbors";
  case SMC::Interpretation_kind::DEGENERATE_FACES:      return "polygons without area";
  case SMC::Interpretation_kind::DUPLICATE_FACES:       return "polygons that are there twice";
  case SMC::Interpretation_kind::WELDED_VERTICES:       return "points at the same place";
  case SMC::Interpretation_kind::NON_ORIENTABLE_EDGES:  return "edges of a surface that has only one side";
  case SMC::Interpretation_kind::REPEATED_CORNERS:      return "polygons with corners that repeat others";
  case SMC::Interpretation_kind::DIVIDED_FACES:         return "polygons that visit a point several times";
  }
  return "";
}

} // namespace

// The library counts in `int`; a triangle has three halfedges.
void Named_surface::check_size() const
{
  constexpr std::size_t maximum = std::size_t((std::numeric_limits<int>::max)()) / 3;
  if(m_arguments.soup.number_of_points() > maximum || m_arguments.soup.corners.size() > maximum)
    refuse(Status_code::WRONG_PARAMETER, "more than " + std::to_string(maximum) + " points or corners");
}

void Named_surface::check_strictly() const
{
  Finding polygons;
  for(std::size_t p = 0; p < m_arguments.soup.number_of_polygons(); ++p)
    if(m_arguments.soup.polygon(p).size() != 3)
      polygons.faces.push_back(p);
  if(!polygons.faces.empty())
    refuse(Status_code::NOT_TRIANGULATED, "polygons that are not triangles", std::move(polygons));
  if(m_interpreted.empty())
    return;
  const SMC::Interpretation& first = m_interpreted.front();
  Finding elements;
  elements.vertices = first.vertices;
  elements.faces = first.polygons;
  for(const auto& edge : first.edges)
    elements.edges.emplace_back(edge[0], edge[1]);
  const bool is_degenerate = first.kind == SMC::Interpretation_kind::DEGENERATE_FACES;
  refuse(is_degenerate ? Status_code::NOT_TRIANGULATED : Status_code::NON_MANIFOLD, description(first.kind),
         std::move(elements));
}

std::vector<std::size_t> Named_surface::representatives(const Soup_adapter& adapter) const
{
  const Indices& corners = m_arguments.soup.corners;
  std::vector<std::size_t> result(m_arguments.soup.number_of_points());
  std::iota(result.begin(), result.end(), std::size_t(0));
  const SMC::internal::Soup_surface& surface = adapter.surface();
  for(std::size_t c = 0; c < corners.size(); ++c)
    if(surface.is_on_surface[c])
      result[std::size_t(corners[std::ptrdiff_t(c)])] = adapter.to_vertex(surface.polygons.vertices[surface.corners[c]]);
  return result;
}

Named_edges Named_surface::find(const char* name, const Indices& pairs, const Soup_adapter& adapter) const
{
  for(const std::int64_t v : pairs)
    if(std::size_t(v) >= m_representatives.size())
      refuse(Status_code::WRONG_PARAMETER, std::string(name) + ": there is no point " + std::to_string(v));
  Named_edges edges(pairs, m_representatives);
  if(edges.is_empty())
    return edges;
  std::vector<Edge> of_surface;
  for(int e = 0; e < adapter.mesh().number_of_edges(); ++e)
    if(!adapter.is_diagonal(e) && edges.position(adapter.to_edge(e)) >= 0)
      of_surface.push_back(adapter.to_edge(e));
  Finding unknown;
  unknown.edges = edges.without(std::move(of_surface));
  if(!unknown.edges.empty())
  {
    const auto [a, b] = unknown.edges.front();
    refuse(Status_code::WRONG_PARAMETER, std::string(name) + ": pairs of points that are no edges of the surface, such as "
                                       + std::to_string(a) + "-" + std::to_string(b), std::move(unknown));
  }
  return edges;
}

void Named_surface::find_terminals(const Soup_adapter& adapter)
{
  if(m_arguments.terminals.empty())
    return;
  std::vector<char> is_on_surface(m_representatives.size(), 0);
  for(const int v : adapter.surface().polygons.vertices)
    is_on_surface[adapter.to_vertex(v)] = 1;
  m_is_terminal.assign(m_representatives.size(), 0);
  Finding unknown;
  for(const std::int64_t v : m_arguments.terminals)
  {
    if(std::size_t(v) >= m_representatives.size())
      refuse(Status_code::WRONG_PARAMETER, "terminals: there is no point " + std::to_string(v));
    if(is_on_surface[m_representatives[std::size_t(v)]])
      m_is_terminal[m_representatives[std::size_t(v)]] = 1;
    else
      unknown.vertices.push_back(std::size_t(v));
  }
  if(!unknown.vertices.empty())
    refuse(Status_code::WRONG_PARAMETER, "terminals: points that are not on the surface, such as "
                                       + std::to_string(unknown.vertices.front()), std::move(unknown));
}

Soup_adapter Named_surface::read(const Go_further& go_further)
{
  check_size();
  const SMC::internal::Welding_words words = {"weld='on'", "weld_tolerance=", ""};
  const SMC::internal::Welding none;
  Soup_adapter adapter(m_arguments.soup.points(), m_arguments.soup.polygons(), m_arguments.is_strict ? none : m_arguments.welding,
                       SMC::internal::Execution::SEQUENTIAL, m_arguments.is_strict ? nullptr : &words, go_further);
  m_interpreted = adapter.surface().findings;
  if(m_arguments.is_strict && (adapter.status() || adapter.status().finding.code == Status_code::EMPTY_MESH))
    check_strictly();
  if(!adapter.status())
    return adapter;
  m_representatives = representatives(adapter);
  m_mandatory = find("mandatory_edges", m_arguments.mandatory_edges, adapter);
  m_forbidden = find("forbidden_edges", m_arguments.forbidden_edges, adapter);
  m_initial_cut = find("initial_cut", m_arguments.initial_cut, adapter);
  m_weighted = find("edge_weights", m_arguments.weighted_edges, adapter);
  find_terminals(adapter);
  return adapter;
}

} // namespace binding
