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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CORNER_UVS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CORNER_UVS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Of each halfedge, where its source lies: what remains when a chart is cut otherwise.
inline std::vector<Eigen::Vector2d> corner_uvs(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
{
  std::vector<Eigen::Vector2d> corners;
  corners.reserve(chart.opposites().size());
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    corners.push_back(uv[chart.source(h)]);
  return corners;
}

// The UVs of the vertices; another check says whether corners disagree.
inline std::vector<Eigen::Vector2d> vertex_uvs(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corners)
{
  std::vector<Eigen::Vector2d> uv(chart.number_of_vertices(), Eigen::Vector2d::Zero());
  for(int h = 0; h < int(corners.size()); ++h)
    uv[chart.source(h)] = corners[h];
  return uv;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CORNER_UVS_H
