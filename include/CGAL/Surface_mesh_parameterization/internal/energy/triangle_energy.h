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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_TRIANGLE_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_TRIANGLE_ENERGY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Value and derivatives of an energy of the two numbers x = |f_z|^2 and y = |f_z̄|^2 of an affine
// map; the determinant is x - y, the squared Frobenius norm 2 (x + y).
struct Energy_derivatives
{
  double value, x, y, xx, xy, yy;
};

// The conformal energy [HG00]: 0.5 |J|^2 / det J = (x + y) / (x - y), ideally 1.
struct MIPS_energy
{
  static constexpr double ideal = 1;

  static double value(double x, double y) { return (x + y) / (x - y); }

  static Energy_derivatives derivatives(double x, double y)
  {
    const double i = 1 / (x - y), i2 = 2 * i * i, i3 = i2 * i;
    return {(x + y) * i, -y * i2, x * i2, 2 * y * i3, -(x + y) * i3, 2 * x * i3};
  }
};

// The isometric energy [SS15]: |J|^2 + |J^-1|^2 = 2 (x + y) (1 + 1 / (x - y)^2), ideally 4.
struct Symmetric_Dirichlet_energy
{
  static constexpr double ideal = 4;

  static double value(double x, double y)
  {
    const double d = x - y;
    return 2 * (x + y) * (1 + 1 / (d * d));
  }

  static Energy_derivatives derivatives(double x, double y)
  {
    const double s = x + y, i = 1 / (x - y), i2 = i * i, i3 = i2 * i, i4 = i2 * i2;
    return {2 * s * (1 + i2),
            2 * (1 + i2) - 4 * s * i3,
            2 * (1 + i2) + 4 * s * i3,
            -8 * i3 + 12 * s * i4,
            -12 * s * i4,
            8 * i3 + 12 * s * i4};
  }
};

// The derivatives of the affine map of a triangle with respect to z and conjugate(z), as vectors of the plane.
struct Wirtinger_derivatives
{
  Eigen::Vector2d z, conjugate;
  double x() const { return z.squaredNorm(); }
  double y() const { return conjugate.squaredNorm(); }
};

// With g_i the gradients of the hat functions as complex numbers, f_z = 1/2 sum of conj(g_i) u_i
// and f_z̄ = 1/2 sum of g_i u_i.
inline Wirtinger_derivatives wirtinger_derivatives(const Rest_shape& s, const Eigen::Vector2d& u0,
                                                   const Eigen::Vector2d& u1, const Eigen::Vector2d& u2)
{
  // g0 = -g1 - g2: differences keep the digits that sums of large coordinates would lose.
  const Eigen::Vector2d a = u1 - u0, b = u2 - u0;
  const double xx = s.g1.x() * a.x() + s.g2.x() * b.x(), yy = s.g1.y() * a.y() + s.g2.y() * b.y();
  const double xy = s.g1.x() * a.y() + s.g2.x() * b.y(), yx = s.g1.y() * a.x() + s.g2.y() * b.x();
  return {Eigen::Vector2d(0.5 * (xx + yy), 0.5 * (xy - yx)),
          Eigen::Vector2d(0.5 * (xx - yy), 0.5 * (xy + yx))};
}

// The 4x4 Hessian of an energy E(x, y) in (f_z, f_z̄) splits: one eigenvalue across each of the two vectors, and a 2x2
// block in their directions. KP-Newton [GSC18] sets negative eigenvalues to zero, here in closed form.
struct Projected_hessian
{
  double across_z, across_conjugate; // eigenvalues
  double zz, zc, cc;                 // the block

  Projected_hessian(const Energy_derivatives& e, double x, double y)
  {
    across_z = (std::max)(0., 2 * e.x);
    across_conjugate = (std::max)(0., 2 * e.y);
    zz = 2 * e.x + 4 * e.xx * x;
    zc = 4 * e.xy * std::sqrt(x * y);
    cc = 2 * e.y + 4 * e.yy * y;
    project_block();
  }

private:
  void project_block()
  {
    const double mean = 0.5 * (zz + cc), difference = 0.5 * (zz - cc);
    const double radius = std::sqrt(difference * difference + zc * zc);
    if(mean - radius >= 0)
      return;
    const double eigenvalue = mean + radius;
    if(!(eigenvalue > 0))
    {
      zz = zc = cc = 0;
      return;
    }
    // The positive eigenspace alone; its direction from the larger of the two equivalent formulas.
    double c = difference >= 0 ? difference + radius : zc;
    double s = difference >= 0 ? zc : radius - difference;
    const double n = std::sqrt(c * c + s * s);
    c /= n;
    s /= n;
    zz = eigenvalue * c * c;
    zc = eigenvalue * c * s;
    cc = eigenvalue * s * s;
  }
};

// Times its weight; infinite unless the triangle is positive, whatever it weighs.
template <typename Energy>
double triangle_energy(double weight, const Rest_shape& shape, const Eigen::Vector2d& u0, const Eigen::Vector2d& u1,
                       const Eigen::Vector2d& u2)
{
  const Wirtinger_derivatives f = wirtinger_derivatives(shape, u0, u1, u2);
  const double x = f.x(), y = f.y();
  return x > y ? weight * Energy::value(x, y) : std::numeric_limits<double>::infinity();
}

// Energy, gradient and projected Hessian of one triangle, per unit of area.
struct Triangle_terms
{
  double value;
  Eigen::Vector2d gradient[3];
  Eigen::Matrix2d diagonal[3]; // blocks (0,0) (1,1) (2,2)
  Eigen::Matrix2d mixed[3];    // blocks (0,1) (1,2) (2,0)
};

namespace complex {

inline Eigen::Vector2d product(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return Eigen::Vector2d(a.x() * b.x() - a.y() * b.y(), a.x() * b.y() + a.y() * b.x());
}
inline Eigen::Vector2d conjugate_product(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return Eigen::Vector2d(a.x() * b.x() + a.y() * b.y(), a.x() * b.y() - a.y() * b.x());
}

} // namespace complex

// Those of the first `corners` corners; the mixed blocks come with all of them.
template <typename Energy, int corners = 3>
void triangle_terms(const Rest_shape& shape, const Eigen::Vector2d& u0, const Eigen::Vector2d& u1,
                    const Eigen::Vector2d& u2, Triangle_terms& terms)
{
  const Wirtinger_derivatives f = wirtinger_derivatives(shape, u0, u1, u2);
  const double x = f.x(), y = f.y();
  const Energy_derivatives e = Energy::derivatives(x, y);
  const Projected_hessian h(e, x, y);
  const Eigen::Vector2d z = f.z / std::sqrt(x);
  // Where f_z̄ vanishes its direction does not matter: `zc` is zero and `cc` equals the eigenvalue across.
  const Eigen::Vector2d c = y > 0 ? Eigen::Vector2d(f.conjugate / std::sqrt(y)) : Eigen::Vector2d(1, 0);

  // f_z = sum of conj(d_i) u_i, f_z̄ = sum of d_i u_i with d_i = g_i / 2.
  const Eigen::Vector2d d[3] = {0.5 * shape.g0, 0.5 * shape.g1, 0.5 * shape.g2};
  Eigen::Vector2d p[3], q[3]; // the transposed maps applied to the unit vectors z and c
  for(int i = 0; i < corners; ++i)
  {
    p[i] = complex::product(d[i], z);
    q[i] = complex::conjugate_product(d[i], c);
  }

  terms.value = e.value;
  const double slope_z = 2 * e.x * std::sqrt(x), slope_c = 2 * e.y * std::sqrt(y);
  for(int i = 0; i < corners; ++i)
    terms.gradient[i] = slope_z * p[i] + slope_c * q[i];

  const double along_z = h.zz - h.across_z, along_c = h.cc - h.across_conjugate;
  const auto block = [&](int i, int j, Eigen::Matrix2d& b)
  {
    // The two rotation-scaling parts, d_i conj(d_j) and its conjugate, differ in the sign of their
    // imaginary entries only.
    const Eigen::Vector2d r = complex::conjugate_product(d[i], d[j]);
    const double real = (h.across_z + h.across_conjugate) * r.x();
    const double imaginary = (h.across_z - h.across_conjugate) * r.y();
    const Eigen::Vector2d a = along_z * p[j] + h.zc * q[j], t = h.zc * p[j] + along_c * q[j];
    b(0, 0) = real + p[i].x() * a.x() + q[i].x() * t.x();
    b(0, 1) = imaginary + p[i].x() * a.y() + q[i].x() * t.y();
    b(1, 0) = -imaginary + p[i].y() * a.x() + q[i].y() * t.x();
    b(1, 1) = real + p[i].y() * a.y() + q[i].y() * t.y();
  };
  for(int i = 0; i < corners; ++i)
    block(i, i, terms.diagonal[i]);
  if constexpr(corners == 3)
    for(int i = 0; i < 3; ++i)
      block(i, (i + 1) % 3, terms.mixed[i]);
}

// Energy and gradient alone, per unit of area.
template <typename Energy>
double triangle_gradient(const Rest_shape& shape, const Eigen::Vector2d& u0, const Eigen::Vector2d& u1,
                         const Eigen::Vector2d& u2, Eigen::Vector2d gradient[3])
{
  const Wirtinger_derivatives f = wirtinger_derivatives(shape, u0, u1, u2);
  const Energy_derivatives e = Energy::derivatives(f.x(), f.y());
  const Eigen::Vector2d z = e.x * f.z, c = e.y * f.conjugate;
  const Eigen::Vector2d* const g[3] = {&shape.g0, &shape.g1, &shape.g2};
  for(int i = 0; i < 3; ++i)
    gradient[i] = complex::product(*g[i], z) + complex::conjugate_product(*g[i], c);
  return e.value;
}

// The energy of each triangle, infinite where the image is not counterclockwise.
template <typename Energy>
std::vector<double> face_energies(const std::vector<Rest_shape>& shapes, const std::vector<Triangle>& triangles,
                                  const std::vector<Eigen::Vector2d>& uv,
                                  Execution execution = Execution::SEQUENTIAL)
{
  std::vector<double> energies(shapes.size());
  execute_blocks(execution, int(shapes.size()), [&](int begin, int end)
  {
    for(int t = begin; t < end; ++t)
    {
      const Triangle& v = triangles[t];
      const Wirtinger_derivatives d = wirtinger_derivatives(shapes[t], uv[v[0]], uv[v[1]], uv[v[2]]);
      const double x = d.x(), y = d.y();
      energies[t] = x > y ? Energy::value(x, y) : std::numeric_limits<double>::infinity();
    }
  });
  return energies;
}

// The average over the area of the surface.
inline double area_average(const std::vector<Rest_shape>& shapes, const std::vector<double>& energies)
{
  double sum = 0, area = 0;
  for(std::size_t t = 0; t < shapes.size(); ++t)
  {
    sum += shapes[t].area * energies[t];
    area += shapes[t].area;
  }
  return sum / area;
}

// The sums of area |J|^2 and area |J^-1|^2, which decide on the best scale of a map.
struct Stretch_sums
{
  double stretch = 0, compression = 0;

  // The factor to multiply the map with, so that its area-averaged symmetric Dirichlet energy becomes as
  // small as possible: that of |sJ|^2 + |(sJ)^-1|^2 = s^2 |J|^2 + s^-2 |J^-1|^2.
  double best_scale() const { return std::sqrt(std::sqrt(compression / stretch)); }
};

// Those of a flip-free map.
inline Stretch_sums stretch_sums(const std::vector<Rest_shape>& shapes, const std::vector<Triangle>& triangles,
                                 const std::vector<Eigen::Vector2d>& uv)
{
  Stretch_sums sums;
  for(std::size_t t = 0; t < shapes.size(); ++t)
  {
    const Triangle& v = triangles[t];
    const Wirtinger_derivatives d = wirtinger_derivatives(shapes[t], uv[v[0]], uv[v[1]], uv[v[2]]);
    const double squared_norm = 2 * (d.x() + d.y()), determinant = d.x() - d.y();
    sums.stretch += shapes[t].area * squared_norm;
    sums.compression += shapes[t].area * squared_norm / (determinant * determinant);
  }
  return sums;
}

inline double best_scale(const std::vector<Rest_shape>& shapes, const std::vector<Triangle>& triangles,
                         const std::vector<Eigen::Vector2d>& uv)
{
  return stretch_sums(shapes, triangles, uv).best_scale();
}

// The average over the triangles at each vertex, weighted by area; 0 at an isolated vertex.
inline std::vector<double> vertex_averages(const std::vector<Rest_shape>& shapes,
                                           const std::vector<Triangle>& triangles,
                                           const std::vector<double>& face_values,
                                           int number_of_vertices)
{
  std::vector<double> sums(number_of_vertices, 0), areas(number_of_vertices, 0);
  for(std::size_t t = 0; t < shapes.size(); ++t)
    for(int v : triangles[t])
    {
      sums[v] += shapes[t].area * face_values[t];
      areas[v] += shapes[t].area;
    }
  for(int v = 0; v < number_of_vertices; ++v)
    if(areas[v] > 0)
      sums[v] /= areas[v];
  return sums;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_TRIANGLE_ENERGY_H
