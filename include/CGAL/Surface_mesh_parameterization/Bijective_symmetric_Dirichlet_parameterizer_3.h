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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_BIJECTIVE_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_BIJECTIVE_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Free_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>

#include <CGAL/Default.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

struct Bijective_method
{
  static Newton_result map(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                           const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                           std::vector<Eigen::Vector2d>& uv)
  {
    return bijective_map(chart, points, shapes, linear_solvers, uv, Newton_options());
  }
  static bool is_valid(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
  {
    return is_bijective(chart, uv);
  }
};

} // namespace internal

/// \ingroup PkgSurfaceMeshCuttingParameterizersRef
///
/// The class `Bijective_symmetric_Dirichlet_parameterizer_3` maps a surface with border one to one to
/// the plane, with as little isometric distortion as possible. It minimizes the same energy as
/// `Symmetric_Dirichlet_parameterizer_3`, whose result is the answer if it has no overlap.
///
/// The border is free, but its image does not cross itself. No two triangles of the image overlap. Parts of the border may
/// touch.
///
/// Where there are overlaps, the method starts again from Tutte's embedding of a simplified surface, which it refines
/// without leaving the image found so far. A scaffold of triangles \cgalCite{cgal:jsp-scaf-17} surrounds the image: as
/// long as none of them flips, the border cannot cross itself. Newton's method optimizes image and scaffold together. The
/// method rebuilds the scaffold every few steps, until the energy decreases by less than a thousandth. The result is a
/// local minimum. Altogether it takes about three times as long as `Symmetric_Dirichlet_parameterizer_3`.
///
/// \cgalModels{Parameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`, for example a `CGAL::Seam_mesh`.
/// \tparam SolverTraits_ is the type of the solver of the sparse symmetric positive definite systems,
///         see `Free_border_parameterizer_3`.
///
/// \sa `Symmetric_Dirichlet_parameterizer_3`
/// \sa `compute_symmetric_Dirichlet_energy()`
template <typename TriangleMesh_, typename SolverTraits_ = Default>
class Bijective_symmetric_Dirichlet_parameterizer_3
  : public Free_border_parameterizer_3<TriangleMesh_, SolverTraits_, internal::Bijective_method>
{
public:
  using Free_border_parameterizer_3<TriangleMesh_, SolverTraits_,
                                    internal::Bijective_method>::Free_border_parameterizer_3;
};

} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_BIJECTIVE_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H
