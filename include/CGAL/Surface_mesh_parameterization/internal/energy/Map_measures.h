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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_MAP_MEASURES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_MAP_MEASURES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The affine map J of a triangle of the surface to one of the plane.
struct Triangle_stretch
{
  double area = 0; // on the surface
  double squared_norm = 0, squared_norm_of_inverse = 0;

  // The larger one first; negative if there is no area.
  Eigen::Vector2d singular_values() const
  {
    if(!(area > 0))
      return Eigen::Vector2d(-1, -1);
    const double determinant = std::sqrt(squared_norm / squared_norm_of_inverse);
    const double difference = std::sqrt((std::max)(0., squared_norm - 2 * determinant));
    const double larger = 0.5 * (std::sqrt(squared_norm + 2 * determinant) + difference);
    return Eigen::Vector2d(larger, larger > 0 ? determinant / larger : 0);
  }
};

// In exact arithmetic, for triangles so thin that rounding spoils their heights. With G and H the Gram matrices
// of two edges on the surface and in the plane, |J|^2 = tr(adj(G) H) / det G and |J^-1|^2 the same over det H.
inline Triangle_stretch exact_stretch(const Eigen::Vector3d (&p)[3], const Eigen::Vector2d (&u)[3])
{
  using Number = Exact_rational;
  // Not in one expression: each would be a type of its own.
  const auto difference = [](const Number& a, const Number& b) -> Number { return a - b; };
  const auto product = [](const Number& a, const Number& b) -> Number { return a * b; };
  const auto quotient = [](const Number& a, const Number& b) { return CGAL::to_double(Number(a / b)); };
  Number g[3] = {0, 0, 0}, h[3] = {0, 0, 0}; // entries 00, 01, 11
  const auto add = [&](double origin, double a, double b, Number (&gram)[3])
  {
    const Number s = difference(a, origin), t = difference(b, origin);
    gram[0] += product(s, s);
    gram[1] += product(s, t);
    gram[2] += product(t, t);
  };
  for(int i = 0; i < 3; ++i)
    add(p[0][i], p[1][i], p[2][i], g);
  for(int i = 0; i < 2; ++i)
    add(u[0][i], u[1][i], u[2][i], h);
  const Number det_g = difference(product(g[0], g[2]), product(g[1], g[1]));
  const Number det_h = difference(product(h[0], h[2]), product(h[1], h[1]));
  Number trace = product(g[2], h[0]);
  trace += product(g[0], h[2]);
  trace -= product(g[1], h[1]);
  trace -= product(g[1], h[1]);
  Triangle_stretch result;
  if(det_g == 0)
    return result;
  result.area = 0.5 * std::sqrt(CGAL::to_double(det_g));
  result.squared_norm = quotient(trace, det_g);
  result.squared_norm_of_inverse = det_h == 0 ? (std::numeric_limits<double>::infinity)()
                                              : quotient(trace, det_h);
  return result;
}

// Symmetric Dirichlet energies of a map as it is: where the engine works with thickened triangles, here are the
// triangles themselves. Faces of no area at all, which have no energy, do not count.
class Map_measures
{
public:
  // `surface` and `chart` hold the same faces over `points` and `uv`. The references are kept.
  Map_measures(const std::vector<Triangle>& surface, const std::vector<Eigen::Vector3d>& points,
               const std::vector<Triangle>& chart, Execution execution = Execution::SEQUENTIAL)
    : m_surface(surface), m_points(points), m_chart(chart), m_execution(execution),
      m_shapes(rest_shapes(surface, points, execution))
  {
    execute_blocks(execution, int(m_shapes.size()), [&](int begin, int end)
    {
      for(int f = begin; f < end; ++f)
        if(!is_higher(surface[f], minimal_coarse_height))
          m_shapes[f].area = 0; // without weight in sums over the others
    });
    for(int f = 0; f < int(m_shapes.size()); ++f)
      if(m_shapes[f].area == 0)
        m_thin.push_back({f, !is_higher(surface[f], minimal_height)});
  }

  // See `Stretch_sums`.
  double best_scale(const std::vector<Eigen::Vector2d>& uv) const
  {
    Stretch_sums sums = stretch_sums(m_shapes, m_chart, uv);
    for(const Thin_face& face : m_thin)
    {
      const Triangle_stretch s = stretch(face.index, uv);
      if(s.area > 0)
      {
        sums.stretch += s.area * s.squared_norm;
        sums.compression += s.area * s.squared_norm_of_inverse;
      }
    }
    const double scale = sums.best_scale();
    return std::isfinite(scale) && scale > 0 ? scale : 1; // a surface of no area
  }

  struct Energies
  {
    double average = 0, maximum = 0; // the average is over the area
    double average_of_others = 0;    // without the thickened faces
    std::vector<double> faces, areas; // of each; faces of no area have no weight
  };

  Energies energies(const std::vector<Eigen::Vector2d>& uv) const
  {
    Energies result;
    result.faces = face_energies<Symmetric_Dirichlet_energy>(m_shapes, m_chart, uv, m_execution);
    Average all;
    for(std::size_t f = 0; f < m_shapes.size(); ++f)
    {
      result.areas.push_back(m_shapes[f].area);
      if(m_shapes[f].area > 0)
      {
        all.add(m_shapes[f].area, result.faces[f]);
        result.maximum = (std::max)(result.maximum, result.faces[f]);
      }
    }
    Average others = all;
    for(const Thin_face& face : m_thin)
    {
      const Triangle_stretch s = stretch(face.index, uv);
      if(!(s.area > 0))
        continue;
      const double energy = s.squared_norm + s.squared_norm_of_inverse;
      all.add(s.area, energy);
      result.areas[face.index] = s.area;
      result.faces[face.index] = energy;
      if(!face.is_thickened)
        others.add(s.area, energy);
      result.maximum = (std::max)(result.maximum, energy);
    }
    result.average = all.value();
    result.average_of_others = others.value();
    return result;
  }

  // Those of the map of each face, the larger one first; negative where a face has no area.
  std::vector<Eigen::Vector2d> singular_values(const std::vector<Eigen::Vector2d>& uv) const
  {
    std::vector<Eigen::Vector2d> result;
    for(std::size_t f = 0; f < m_shapes.size(); ++f)
    {
      const Triangle& v = m_chart[f];
      const Wirtinger_derivatives d = wirtinger_derivatives(m_shapes[f], uv[v[0]], uv[v[1]], uv[v[2]]);
      const double x = d.z.norm(), y = d.conjugate.norm();
      result.emplace_back(x + y, std::abs(x - y));
    }
    for(const Thin_face& face : m_thin)
      result[face.index] = stretch(face.index, uv).singular_values();
    return result;
  }

  bool has_thickened_faces() const
  {
    return std::any_of(m_thin.begin(), m_thin.end(), [](const Thin_face& face) { return face.is_thickened; });
  }

private:
  struct Thin_face
  {
    int index;
    bool is_thickened; // by the engine
  };

  struct Average
  {
    double sum = 0, area = 0;

    void add(double face_area, double energy)
    {
      sum += face_area * energy;
      area += face_area;
    }
    double value() const { return sum / area; }
  };

  // Whether the height is more than this fraction of the longest edge.
  bool is_higher(const Triangle& t, double height) const
  {
    const Eigen::Vector3d a = m_points[t[1]] - m_points[t[0]], b = m_points[t[2]] - m_points[t[0]];
    const double squared_length = (std::max)({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
    return cross_product(a, b).norm() > height * squared_length;
  }

  Triangle_stretch stretch(int f, const std::vector<Eigen::Vector2d>& uv) const
  {
    const Triangle &s = m_surface[f], &c = m_chart[f];
    return exact_stretch({m_points[s[0]], m_points[s[1]], m_points[s[2]]}, {uv[c[0]], uv[c[1]], uv[c[2]]});
  }

  const std::vector<Triangle>& m_surface;
  const std::vector<Eigen::Vector3d>& m_points;
  const std::vector<Triangle>& m_chart;
  Execution m_execution;
  std::vector<Rest_shape> m_shapes;
  std::vector<Thin_face> m_thin;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_MAP_MEASURES_H
