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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VECTORS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VECTORS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

inline bool is_finite(const Eigen::Vector2d& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y());
}

inline bool is_finite(const Eigen::Vector3d& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

// The coordinates of a point of any kernel, rounded to `double`.
template <typename Point_2>
Eigen::Vector2d to_vector_2(const Point_2& p)
{
  return Eigen::Vector2d(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
}

template <typename Point_3>
Eigen::Vector3d to_vector_3(const Point_3& p)
{
  return Eigen::Vector3d(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

// Eigen's own comes with its rotations, transformations and dense decompositions, which all programs would compile.
inline Eigen::Vector3d cross_product(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return Eigen::Vector3d(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x());
}

inline double determinant(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

// Twice the area of a triangle, negative if it is clockwise.
inline double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return determinant(b - a, c - a);
}

// The box around the points added; inside out while there are none.
template <int Dimension>
struct Bounding_box
{
  using Vector = Eigen::Matrix<double, Dimension, 1>;

  Vector low = Vector::Constant(std::numeric_limits<double>::infinity());
  Vector high = Vector::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vector& point)
  {
    for(int i = 0; i < Dimension; ++i)
    {
      low[i] = (std::min)(low[i], point[i]);
      high[i] = (std::max)(high[i], point[i]);
    }
  }

  Vector size() const { return high - low; }

  double longest_side() const
  {
    double longest = high[0] - low[0];
    for(int i = 1; i < Dimension; ++i)
      longest = (std::max)(longest, high[i] - low[i]);
    return longest;
  }

  // Moves all sides outwards.
  void grow(double margin)
  {
    for(int i = 0; i < Dimension; ++i)
    {
      low[i] -= margin;
      high[i] += margin;
    }
  }
};

// The e for which the box has an extent in [1, 2) after division by 2^e; 0 for a point. Scaling by a power of two
// loses no bit, and at this scale products of lengths neither overflow nor underflow.
inline int scale_exponent(const Bounding_box<3>& box)
{
  // Halves, as the difference of two finite numbers may be infinite.
  double half_extent = 0;
  for(int i = 0; i < 3; ++i)
    half_extent = (std::max)(half_extent, 0.5 * box.high[i] - 0.5 * box.low[i]);
  return half_extent > 0 ? std::ilogb(half_extent) + 1 : 0;
}

// `vector` times 2^e.
template <typename Vector>
Vector scaled(Vector vector, int e)
{
  for(Eigen::Index i = 0; i < vector.size(); ++i)
    vector[i] = std::ldexp(vector[i], e);
  return vector;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_VECTORS_H
