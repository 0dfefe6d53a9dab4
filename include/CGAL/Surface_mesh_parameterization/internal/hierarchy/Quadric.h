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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_QUADRIC_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_QUADRIC_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/cross_product.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapsible_chart.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Squared distances to a set of planes, weighted [Garland, Heckbert 1997].
struct Quadric
{
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double c = 0;

  void add_plane(const Eigen::Vector3d& normal, const Eigen::Vector3d& point, double weight)
  {
    const double offset = -normal.dot(point);
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        a(i, j) += weight * normal[i] * normal[j];
    b += weight * offset * normal;
    c += weight * offset * offset;
  }
  void add(const Quadric& q)
  {
    a += q.a;
    b += q.b;
    c += q.c;
  }
  double operator()(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d product = a * p;
    return p.dot(product) + 2 * b.dot(p) + c;
  }
};

// Adds what a triangle says about a corner of it: its plane, and upright planes on its border edges, which keep the
// border where it is.
inline void add_planes(const Collapsible_chart& chart, const std::vector<Eigen::Vector3d>& points, int t, int v,
                       Quadric& quadric)
{
  const Triangle& c = chart.triangles()[t];
  const Eigen::Vector3d normal = cross_product(points[c[1]] - points[c[0]], points[c[2]] - points[c[0]]);
  const double twice_area = normal.norm();
  if(!(twice_area > 0))
    return;
  const Eigen::Vector3d unit = normal / twice_area;
  for(int k = 0; k < 3; ++k)
  {
    const int s = c[k], e = c[(k + 1) % 3];
    if(s == v)
      quadric.add_plane(unit, points[v], twice_area);
    if((s != v && e != v) || chart.opposites()[3 * t + k] >= 0)
      continue;
    const Eigen::Vector3d edge = points[e] - points[s];
    const Eigen::Vector3d wall = cross_product(edge, unit);
    const double length = wall.norm();
    if(length > 0)
      quadric.add_plane(wall / length, points[s], length * length);
  }
}

// Of all vertices. Sums have the order of the triangles, whatever the number of threads.
inline std::vector<Quadric> vertex_quadrics(const Collapsible_chart& chart, const std::vector<Eigen::Vector3d>& points,
                                            Execution execution)
{
  std::vector<Quadric> quadrics(points.size());
  execute_blocks(execution, int(points.size()), [&](int begin, int end)
  {
    std::vector<int> fan;
    for(int v = begin; v < end; ++v)
    {
      if(!chart.is_used(v))
        continue;
      chart.fan(v, fan);
      std::sort(fan.begin(), fan.end());
      for(int h : fan)
        add_planes(chart, points, h / 3, v, quadrics[v]);
    }
  });
  return quadrics;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_QUADRIC_H
