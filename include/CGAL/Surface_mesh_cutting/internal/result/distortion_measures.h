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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_DISTORTION_MEASURES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_DISTORTION_MEASURES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Distortion_measures.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Map_measures.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The map of one face, both areas in shares of the whole.
struct Face_distortion
{
  double area, image_area;
  double angle_change; // sum over the corners
  Eigen::Vector2d singular_values; // the larger one first

  // (x + 1/x) - 2, infinite for 0 and infinity.
  static double excess(double x) { return x > 0 ? x + 1 / x - 2 : (std::numeric_limits<double>::infinity)(); }

  double area_distortion() const { return excess(image_area / area); }
  double angle_distortion() const { return excess(singular_values[1] / singular_values[0]); }
  double symmetric_Dirichlet_energy() const
  { return singular_values.squaredNorm() + singular_values.cwiseInverse().squaredNorm(); }
};

// Sums up the faces of a map in the terms of [SSS22]. The surface and its image get an area of 1.
class Distortion_sums
{
public:
  // No corner is away from its chart vertex. `uv` is finite, and its area is not zero.
  Distortion_sums(const Indexed_mesh& mesh, const Corner_table& chart, std::vector<Eigen::Vector2d> uv)
    : m_mesh(mesh), m_chart(chart), m_uv(std::move(uv))
  {
    Surface_mesh_parameterization::internal::Bounding_box<2> box;
    for(const Triangle& t : chart.triangles())
      for(const int v : t)
        box.add(m_uv[v]);
    const double side = box.longest_side();
    for(Eigen::Vector2d& p : m_uv) // into the unit square, before areas can overflow
      p /= side;
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      m_area += mesh.face_area(f);
      m_image_area += std::abs(image_area(f));
    }
  }

  double area() const { return m_area; }
  double image_area() const { return m_image_area; }

  Distortion_measures measures() const
  {
    const std::vector<Eigen::Vector2d> singular_values
      = Surface_mesh_parameterization::internal::Map_measures(m_mesh.triangles(), m_mesh.points(), m_chart.triangles())
          .singular_values(m_uv);
    const double scale = std::sqrt(m_area / m_image_area);
    Distortion_measures result;
    result.smallest_singular_value = (std::numeric_limits<double>::infinity)();
    double faces = 0, clockwise = 0;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      const Eigen::Vector2d& s = singular_values[f];
      if(s[0] < 0) // a face of no area
        continue;
      faces += 1;
      clockwise += image_area(f) < 0;
      result.resolution = (std::max)(result.resolution, 1 / s[1]);
      add({m_mesh.face_area(f) / m_area, std::abs(image_area(f)) / m_image_area, angle_change(f), scale * s}, result);
    }
    result.proportion_of_flipped_faces = (std::min)(clockwise, faces - clockwise) / faces;
    return result;
  }

private:
  static void add(const Face_distortion& face, Distortion_measures& sums)
  {
    const auto raise = [](double& maximum, double value) { maximum = (std::max)(maximum, value); };
    raise(sums.largest_area_distortion, face.area_distortion());
    raise(sums.largest_angle_distortion, face.angle_distortion());
    raise(sums.largest_singular_value, face.singular_values[0]);
    sums.smallest_singular_value = (std::min)(sums.smallest_singular_value, face.singular_values[1]);
    sums.average_area_discrepancy += std::abs(face.image_area - face.area);
    sums.average_angle_discrepancy += face.area * face.angle_change;
    sums.symmetric_Dirichlet_energy += face.area * face.symmetric_Dirichlet_energy();
  }

  double image_area(int f) const
  { return Surface_mesh_parameterization::internal::triangle_area(m_chart.triangles()[f], m_uv); }

  double angle_change(int f) const
  {
    const Triangle &t = m_mesh.triangles()[f], &c = m_chart.triangles()[f];
    double sum = 0;
    for(int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      const Point a = m_mesh.point(t[l]) - m_mesh.point(t[k]), b = m_mesh.point(t[m]) - m_mesh.point(t[k]);
      const Eigen::Vector2d p = m_uv[c[l]] - m_uv[c[k]], q = m_uv[c[m]] - m_uv[c[k]];
      const bool is_defined = m_uv[c[0]] != m_uv[c[1]] && m_uv[c[1]] != m_uv[c[2]] && m_uv[c[2]] != m_uv[c[0]];
      const double angle
        = std::atan2(Surface_mesh_parameterization::internal::cross_product(a, b).norm(), a.dot(b));
      const double image = std::atan2(std::abs(p.x() * q.y() - p.y() * q.x()), p.dot(q));
      sum += is_defined ? std::abs(angle - image) : 2 * CGAL_PI;
    }
    return sum;
  }

  const Indexed_mesh& m_mesh;
  const Corner_table& m_chart;
  std::vector<Eigen::Vector2d> m_uv; // in the unit square
  double m_area = 0, m_image_area = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_DISTORTION_MEASURES_H
