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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_EXACT_CERTIFICATE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_EXACT_CERTIFICATE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/result/check_disks.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <Eigen/Core>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What the exact check of a map to the plane found.
using Surface_mesh_parameterization::internal::Execution;

struct Certificate
{
  int non_finite = 0;   // triangles with a coordinate that is infinite or not a number
  int torn = 0;         // triangles with a corner away from the others of its chart vertex
  int flips = 0;        // triangles that are not strictly counterclockwise, those above included
  int crossings = 0;    // pairs of border edges at which the surface overlaps
  int containments = 0; // pairs of parts, one inside the other
  std::vector<int> faces; // at which something was found, sorted

  int overlaps() const { return crossings + containments; }
  explicit operator bool() const { return faces.empty(); }

  Indexed_status status() const
  {
    if(faces.empty())
      return Indexed_status();
    std::string message;
    const auto add = [&message](int count, const char* what)
    {
      if(count > 0)
        message += (message.empty() ? "" : ", ") + std::string(what) + ": " + std::to_string(count);
    };
    add(non_finite, "triangles whose UVs are infinite or not a number");
    add(torn, "triangles torn off where no edge is cut");
    add(flips - non_finite, "triangles that are not counterclockwise");
    add(crossings, "overlaps of chart borders");
    add(containments, "charts on top of another chart");
    return Indexed_status(Status_code::NOT_CERTIFIED, std::move(message), Element_kind::FACE, faces);
  }
};

// The triangles that are not strictly counterclockwise.
inline Certificate certify_triangles(const std::vector<Triangle>& triangles,
                                     const std::vector<Eigen::Vector2d>& uv, Execution execution)
{
  using Surface_mesh_parameterization::internal::count_flips;
  using Surface_mesh_parameterization::internal::is_finite;

  Certificate certificate;
  certificate.flips = count_flips(triangles, uv, &certificate.faces, execution);
  // A triangle with a value that is not finite is never counterclockwise.
  for(int f : certificate.faces)
  {
    const Triangle& t = triangles[f];
    if(!(is_finite(uv[t[0]]) && is_finite(uv[t[1]]) && is_finite(uv[t[2]])))
      ++certificate.non_finite;
  }
  return certificate;
}

// Checks with exact predicates that `uv`, one per chart vertex, is finite and maps each triangle to
// a strictly counterclockwise one and, on request, that no two triangles overlap.
inline Certificate certify(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv,
                           bool do_bijective, Execution execution = Execution::SEQUENTIAL)
{
  Certificate certificate = certify_triangles(chart.triangles(), uv, execution);
  if(!do_bijective || certificate.non_finite > 0)
    return certificate;
  const Connected_parts parts(chart.opposites());
  const Surface_mesh_parameterization::internal::Border_overlaps overlaps(chart, parts, uv);
  certificate.crossings = int(overlaps.crossings().size());
  certificate.containments = int(overlaps.containments().size());
  std::vector<int>& faces = certificate.faces;
  for(const std::pair<int, int>& crossing : overlaps.crossings())
  {
    faces.push_back(crossing.first / 3);
    faces.push_back(crossing.second / 3);
  }
  const auto begin = parts.part.begin(), end = parts.part.end();
  for(const std::pair<int, int>& containment : overlaps.containments())
    faces.push_back(int(std::find(begin, end, containment.first) - begin));
  CGAL::internal::Graph_kernel::sort_unique(faces);
  return certificate;
}

// The same for UVs given per corner, which have to agree at each chart vertex.
inline Certificate certify_corners(const Corner_table& chart,
                                   const std::vector<Eigen::Vector2d>& corner_uv,
                                   bool do_bijective, Execution execution = Execution::SEQUENTIAL)
{
  std::vector<Eigen::Vector2d> uv(chart.number_of_vertices(), Eigen::Vector2d::Zero());
  std::vector<char> is_set(uv.size(), 0);
  std::vector<int> torn;
  for(int h = 0; h < int(corner_uv.size()); ++h)
  {
    const int v = chart.source(h);
    if(!std::exchange(is_set[v], char(1)))
      uv[v] = corner_uv[h];
    else if(uv[v] != corner_uv[h] && (torn.empty() || torn.back() != h / 3))
      torn.push_back(h / 3);
  }
  if(torn.empty())
    return certify(chart, uv, do_bijective, execution);

  std::vector<Triangle> triangles;
  for(int h = 0; h < int(corner_uv.size()); h += 3)
    triangles.push_back({h, h + 1, h + 2});
  Certificate certificate = certify_triangles(triangles, corner_uv, execution);
  certificate.torn = int(torn.size());
  std::vector<int> faces;
  std::set_union(certificate.faces.begin(), certificate.faces.end(), torn.begin(), torn.end(),
                 std::back_inserter(faces));
  certificate.faces = std::move(faces);
  return certificate;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_EXACT_CERTIFICATE_H
