// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "Named_edges.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace binding {

Named_edges::Named_edges(const Indices& pairs, const std::vector<std::size_t>& representatives)
{
  for(std::ptrdiff_t i = 0; 2 * i < std::ptrdiff_t(pairs.size()); ++i)
    m_edges.emplace_back(std::minmax(representatives[std::size_t(pairs[2 * i])],
                                     representatives[std::size_t(pairs[2 * i + 1])]), -i);
  std::sort(m_edges.begin(), m_edges.end()); // the last position of an edge comes first
  m_edges.erase(std::unique(m_edges.begin(), m_edges.end(),
                            [](const auto& a, const auto& b) { return a.first == b.first; }), m_edges.end());
  for(auto& [edge, position] : m_edges)
    position = -position;
}

std::ptrdiff_t Named_edges::position(const Edge& edge) const
{
  const auto found = std::lower_bound(m_edges.begin(), m_edges.end(), edge,
                                      [](const auto& a, const Edge& b) { return a.first < b; });
  return found != m_edges.end() && found->first == edge ? found->second : -1;
}

std::vector<Edge> Named_edges::without(std::vector<Edge> others) const
{
  std::sort(others.begin(), others.end());
  std::vector<Edge> all, result;
  for(const auto& [edge, position] : m_edges)
    all.push_back(edge);
  std::set_difference(all.begin(), all.end(), others.begin(), others.end(), std::back_inserter(result));
  return result;
}

double Edge_weights::weight(const Edge& edge) const
{
  const std::ptrdiff_t position = edges->position(edge);
  if(position >= 0)
    return weights[position];
  const double* const a = coordinates.begin() + 3 * edge.first;
  const double* const b = coordinates.begin() + 3 * edge.second;
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace binding
