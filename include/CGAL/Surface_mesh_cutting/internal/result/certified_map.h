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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_CERTIFIED_MAP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_CERTIFIED_MAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>

#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Rounding_repair.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/Scaffold.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What the caller's map makes of a UV, which it may hold with fewer digits.
using Round = Surface_mesh_parameterization::internal::Rounding_repair::Round;

// A map as the caller's map will hold it, and its proof.
struct Certified_map
{
  std::vector<Eigen::Vector2d> uv;
  Certificate certificate;
};

// Rounds the map, moving vertices where triangles would flip. If no two triangles may overlap, those of
// a triangulation of what lies between the borders must not flip either.
inline std::vector<Eigen::Vector2d> rounded_without_flips(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv,
                                                          bool do_bijective, const Round& round)
{
  using Surface_mesh_parameterization::internal::Rounding_repair;
  using Surface_mesh_parameterization::internal::Scaffold;

  const int n = chart.number_of_vertices();
  std::vector<Triangle> triangles = chart.triangles();
  std::vector<Eigen::Vector2d> result = uv;
  std::vector<char> is_fixed;
  Scaffold scaffold;
  if(do_bijective && scaffold.build(chart, uv)) // it cannot be built where borders touch
  {
    triangles.insert(triangles.end(), scaffold.triangles().begin(), scaffold.triangles().end());
    result = scaffold.points();
    is_fixed.assign(n, 0);
    is_fixed.resize(n + Scaffold::number_of_corners, 1);
  }
  Rounding_repair(triangles, int(result.size()), round, n, std::move(is_fixed))(result);
  result.resize(n);
  return result;
}

// The map rounded as it will be held, certified; what rounding spoils is repaired, if need be at scales that
// round differently.
inline Certified_map certified_map(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv, bool do_bijective,
                                   const Round& round, Execution execution)
{
  Certified_map held;
  for(const Eigen::Vector2d& u : uv)
    held.uv.push_back(round(u));
  held.certificate = certify(chart, held.uv, do_bijective, execution);
  if(held.certificate || !certify(chart, uv, do_bijective, execution))
    return held;
  // A thousandth of scale costs a millionth of energy.
  for(double scale : {1., 1.0007, 0.9993, 1.0019, 0.9981})
  {
    std::vector<Eigen::Vector2d> scaled = uv;
    for(Eigen::Vector2d& u : scaled)
      u *= scale;
    held.uv = rounded_without_flips(chart, scaled, do_bijective, round);
    held.certificate = certify(chart, held.uv, do_bijective, execution);
    if(held.certificate)
      break;
  }
  return held;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_CERTIFIED_MAP_H
