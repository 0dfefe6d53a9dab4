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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Free_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>

#include <CGAL/Default.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

struct Conformal_method : Flip_free_method
{
  static Newton_result map(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                           const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                           std::vector<Eigen::Vector2d>& uv)
  {
    return Chart_parameterizer(chart, points, shapes, linear_solvers).conformal_map(uv, Newton_options());
  }
};

} // namespace internal

/// \ingroup PkgSurfaceMeshCuttingParameterizersRef
///
/// The class `MIPS_parameterizer_3` implements the <em>most isometric parameterization</em> (MIPS) of a surface with
/// border \cgalCite{cgal:hg-megpm-00}: the map to the plane that preserves angles as well as possible. It minimizes
/// the average of \f$ \frac{1}{2} \|J\|_F^2 / \det J \f$ over the area of the surface, where \f$ J \f$ is the Jacobian
/// of a triangle. This energy is 1 for a similarity and grows to infinity as a triangle degenerates.
///
/// The border is free. No triangle is flipped. Distant parts of the image may overlap. The result has the area of the
/// surface. `Free_border_parameterizer_3` describes method, time, and memory.
///
/// \cgalModels{Parameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`, for example a `CGAL::Seam_mesh`.
/// \tparam SolverTraits_ is the type of the solver of the sparse symmetric positive definite systems,
///         see `Free_border_parameterizer_3`.
///
/// \sa `Symmetric_Dirichlet_parameterizer_3`
/// \sa `compute_MIPS_energy()`
template <typename TriangleMesh_, typename SolverTraits_ = Default>
class MIPS_parameterizer_3
  : public Free_border_parameterizer_3<TriangleMesh_, SolverTraits_, internal::Conformal_method>
{
public:
  using Free_border_parameterizer_3<TriangleMesh_, SolverTraits_,
                                    internal::Conformal_method>::Free_border_parameterizer_3;
};

} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H
