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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Mesh_chart.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <CGAL/Default.h>
#include <CGAL/use.h>

#include <boost/graph/graph_traits.hpp>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {

/// \ingroup PkgSurfaceMeshCuttingParameterizersRef
///
/// The class `Symmetric_Dirichlet_parameterizer_3` maps a surface with border to the plane with as
/// little isometric distortion as possible \cgalCite{cgal:ss-bpfb-15}. It minimizes the average of
/// \f$ \|J\|_F^2 + \|J^{-1}\|_F^2 \f$ over the area of the surface, where \f$ J \f$ is the
/// Jacobian of a triangle. This energy is 4 for a rigid motion and grows to infinity as a triangle
/// degenerates.
///
/// The border is free. No triangle is flipped, which is verified with exact predicates; distant
/// parts of the image may overlap. The result has the scale at which its energy is smallest. The
/// surface may have any number of borders, but no handles.
///
/// The method simplifies the surface by half-edge collapses, starts from Tutte's embedding
/// \cgalCite{cgal:t-hdg-63} of the coarsest stage, and undoes the collapses, with
/// each vertex placed where it flips no triangle; Newton's method with analytically projected
/// Hessians \cgalCite{cgal:gsc-plmo-18} optimizes each stage, and steps end before the first
/// triangle flips.
///
/// A sparse matrix of about \f$ 2n \f$ rows for \f$ n \f$ vertices is factorized, which takes
/// \f$ O(n^{1.5}) \f$ time and \f$ O(n \log n) \f$ memory on usual meshes, at most 200 times, and
/// usually less than ten times. Degenerate faces are given a small height.
///
/// \cgalModels{Parameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`, for example a `CGAL::Seam_mesh`.
/// \tparam SolverTraits_ must be a model of `SparseLinearAlgebraWithFactorTraits_d` whose solver
///         takes symmetric positive definite systems.<br>
///         <b>%Default:</b> `Eigen::SimplicialLDLT` with an ordering that is computed once for all
///         iterations. Eigen 3.3 (or greater) is required.
///
/// \sa `MIPS_parameterizer_3`
/// \sa `compute_symmetric_Dirichlet_energy()`
template <typename TriangleMesh_, typename SolverTraits_ = Default>
class Symmetric_Dirichlet_parameterizer_3
{
public:
  /// %Triangle mesh type
  using TriangleMesh = TriangleMesh_;

  /// %Halfedge type of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// computes a map from the connected component of `bhd` to the plane without flipped triangles.
  ///
  /// \tparam VertexUVmap must be a model of `ReadWritePropertyMap` with
  ///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
  ///         `%Point_2` (of any \cgal kernel) as value type.
  /// \tparam VertexIndexMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
  ///         a unique integer as value type. It is not used.
  /// \tparam VertexParameterizedMap must be a model of `ReadWritePropertyMap` with
  ///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
  ///         a Boolean as value type.
  ///
  /// \param mesh a triangulated surface.
  /// \param bhd a halfedge on a border of `mesh`. It selects the connected component; all its
  ///        borders are free.
  /// \param uvmap receives the position in the plane of each vertex of the component.
  /// \param vimap unique indices of the vertices.
  /// \param vpmap is set to `true` for each vertex of the component that was given a position.
  ///
  /// \return `OK`, or what is wrong with the component:
  /// - `ERROR_EMPTY_MESH`: `bhd` is null or has no face at its edge;
  /// - `ERROR_NON_TRIANGULAR_MESH`: a face is not a triangle;
  /// - `ERROR_NO_TOPOLOGICAL_DISC`: `bhd` is not on a border, the component has handles, or
  ///   a vertex is not manifold;
  /// - `ERROR_BORDER_TOO_SHORT`: no border has three edges;
  /// - `ERROR_WRONG_PARAMETER`: a coordinate is not finite;
  /// - `ERROR_NO_1_TO_1_MAPPING`: no map without flipped triangles could be found in floating-point
  ///   arithmetic, or it cannot be represented by the number type of the UVs;
  /// - `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`: the solver failed.
  template <typename VertexUVmap, typename VertexIndexMap, typename VertexParameterizedMap>
  Error_code parameterize(TriangleMesh& mesh,
                          halfedge_descriptor bhd,
                          VertexUVmap uvmap,
                          VertexIndexMap vimap,
                          VertexParameterizedMap vpmap)
  {
    CGAL_USE(vimap);
    const auto solve = [](auto& parameterizer, std::vector<Eigen::Vector2d>& uv)
    { return parameterizer.isometric_map(uv, internal::Newton_options()); };
    return internal::parameterize_component<SolverTraits_>(mesh, bhd, uvmap, vpmap, solve);
  }
};

} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H
