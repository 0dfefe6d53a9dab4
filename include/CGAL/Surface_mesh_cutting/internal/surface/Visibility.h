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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_VISIBILITY_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_VISIBILITY_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/flatness.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/parts_inside_out.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Triangle_tree.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/View.h>

#include <CGAL/number_type_config.h>
#include <CGAL/Random.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Which part of the light from a hemisphere reaches the middle of an edge.
class Visibility
{
  using Kernel = Triangle_tree::Kernel;

public:
  // O(n log n). The same directions, relative to the axis of the view, serve all edges.
  Visibility(const Indexed_mesh& mesh, const View& view)
    : m_mesh(mesh), m_is_inside_out(inside_out(mesh)), m_axis(view.axis.stableNormalized()), m_radius(view.radius * bounding_box_diagonal(mesh)),
      m_directions(random_directions(view)), m_triangles(mesh)
  {}

  // The part of the rays from the middle of the edge that leave the surface behind: 0 if the edge
  // is hidden, 1 if nothing is in the way. Can be called by several threads.
  double operator()(int e) const
  {
    const int h = m_mesh.halfedge(e);
    Eigen::Vector3d normal = outward_normal(h / 3);
    if(!m_mesh.is_border(h))
      normal += outward_normal(m_mesh.opposite(h) / 3);
    normal = normal.stableNormalized();
    if(normal.isZero())
      return 1;
    const Point& source = m_mesh.point(m_mesh.source(h));
    const Eigen::Vector3d edge = m_mesh.point(m_mesh.target(h)) - source;
    const Eigen::Vector3d& axis = m_axis.isZero() ? normal : m_axis;
    const Eigen::Vector3d first = axis.unitOrthogonal(), second = axis.cross(first);
    // Off the surface, lest its own faces are in the way.
    const Point origin = source + 0.5 * edge + 1e-3 * edge.norm() * normal;
    int number_of_free_rays = 0;
    for(const Eigen::Vector3d& d : m_directions)
      number_of_free_rays += is_free(origin, d.x() * first + d.y() * second + d.z() * axis);
    return number_of_free_rays / double(m_directions.size());
  }

private:
  // Of a closed part, whichever way its faces are oriented; otherwise as they are.
  Eigen::Vector3d outward_normal(int f) const { return (m_is_inside_out[f] ? -1. : 1.) * unit_normal(m_mesh, f); }

  // Around the third axis. A spiral by the golden angle spreads them evenly, with far less noise than if each was
  // drawn alone; how it is turned, and where they lie between the neighbors, is random.
  static std::vector<Eigen::Vector3d> random_directions(const View& view)
  {
    const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
    Random random(view.random_seed);
    const double turn = random.get_double(0, 2 * CGAL_PI);
    std::vector<Eigen::Vector3d> directions;
    for(int i = 0; i < view.number_of_rays; ++i)
    {
      // of the distance from the axis, which `x` from 0 to 1 gives the density that is asked for
      const double x = (i + random.get_double()) / view.number_of_rays, square = view.is_uniform ? x * (2 - x) : x;
      const double angle = turn + i * golden_angle;
      directions.emplace_back(std::sqrt(square) * std::cos(angle),
                              std::sqrt(square) * std::sin(angle), std::sqrt(1 - square));
    }
    return directions;
  }

  bool is_free(const Point& origin, const Eigen::Vector3d& direction) const
  {
    const auto to_cgal = Triangle_tree::to_cgal;
    if(std::isfinite(m_radius))
      return !m_triangles.tree().do_intersect(Kernel::Segment_3(to_cgal(origin), to_cgal(origin + m_radius * direction)));
    return !m_triangles.tree().do_intersect(Kernel::Ray_3(
      to_cgal(origin), Kernel::Direction_3(direction.x(), direction.y(), direction.z())));
  }

  const Indexed_mesh& m_mesh;
  const std::vector<char> m_is_inside_out; // per face
  const Eigen::Vector3d m_axis; // zero for the normals of the edges
  const double m_radius;
  const std::vector<Eigen::Vector3d> m_directions;
  const Triangle_tree m_triangles;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_VISIBILITY_H
