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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FREE_BORDER_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FREE_BORDER_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Mesh_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <CGAL/use.h>

#include <boost/graph/graph_traits.hpp>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Base of the methods that promise a map without flips, but not without overlaps.
struct Flip_free_method
{
  static bool is_valid(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
  {
    return count_flips(chart.triangles(), uv) == 0;
  }
};

} // namespace internal

/// \ingroup PkgSurfaceMeshCuttingParameterizersRef
///
/// The class `Free_border_parameterizer_3` is the base of the parameterizers that minimize an energy
/// of the triangles over maps with a free border and without flipped triangles. It reads the
/// surface, reports why a surface cannot be mapped, and proves the promised properties of the map.
/// The surface may have any number of borders, but no handles. Degenerate faces get a small height.
///
/// The method simplifies the surface by half-edge collapses, starts from Tutte's embedding
/// \cgalCite{cgal:t-hdg-63} of the coarsest stage, and undoes the collapses, placing each vertex where
/// it flips no triangle. Newton's method with analytically projected Hessians
/// \cgalCite{cgal:gsc-plmo-18} optimizes each stage; its steps end before the first triangle flips
/// \cgalCite{cgal:ss-bpfb-15}.
///
/// For \f$ n \f$ vertices, the method factorizes a sparse matrix of about \f$ 2n \f$ rows at most 200
/// times, and usually fewer than ten times. Each factorization takes \f$ O(n^{1.5}) \f$ time and
/// \f$ O(n \log n) \f$ memory on usual meshes.
///
/// \cgalModels{Parameterizer_3}
///
/// \tparam TriangleMesh_ must be a model of `FaceGraph`, for example a `CGAL::Seam_mesh`.
/// \tparam SolverTraits_ is the type of the solver of the sparse symmetric positive definite systems:
///         a class with the member functions `analyzePattern()`, `factorize()`, `solve()`, and `info()`
///         of \eigen's direct sparse solvers, or a model of `SparseLinearAlgebraWithFactorTraits_d`, for example
///         `CGAL::Eigen_solver_traits` of a direct solver.<br>
///         <b>%Default:</b> a supernodal Cholesky factorization that needs no other library; `Eigen::SimplicialLDLT`
///         for systems of less than 1,000 unknowns. Eigen 3.3 (or greater) is required.
/// \tparam Method_ is chosen by the derived class.
///
/// \sa `MIPS_parameterizer_3`
/// \sa `Symmetric_Dirichlet_parameterizer_3`
/// \sa `Bijective_symmetric_Dirichlet_parameterizer_3`
template <typename TriangleMesh_, typename SolverTraits_, typename Method_>
class Free_border_parameterizer_3
{
public:
  /// %Triangle mesh type
  using TriangleMesh = TriangleMesh_;

  /// %Halfedge type of the mesh
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// Solver type, `CGAL::Default` for the default solver
  using Solver_traits = SolverTraits_;

  /// Constructor
  ///
  /// \param solver solves all sparse systems. If it has the interface of \eigen, a copy of it solves each system; if it
  ///        is a model of `SparseLinearAlgebraWithFactorTraits_d`, a default-constructed object of its type does. The
  ///        symbolic analysis is reused while only the values of a matrix change.
  ///        The unknowns come in an order that keeps the factors sparse.
  explicit Free_border_parameterizer_3(const Solver_traits& solver = Solver_traits())
    : m_linear_solvers(internal::make_solvers(solver))
  {}

  /// computes a map from the connected component of `bhd` to the plane.
  ///
  /// \tparam VertexUVmap must be a model of `ReadWritePropertyMap` with
  ///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
  ///         `%Point_2` (of any \cgal kernel) as value type.
  /// \tparam VertexIndexMap must be a model of `ReadablePropertyMap` with
  ///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
  ///         a unique integer as value type. The method does not use it.
  /// \tparam VertexParameterizedMap must be a model of `ReadWritePropertyMap` with
  ///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a Boolean as value type.
  ///
  /// \param mesh a triangulated surface.
  /// \param bhd a halfedge on a border of `mesh`. It selects the connected component; all its borders are free.
  /// \param uvmap receives the position in the plane of each vertex of the component.
  /// \param vimap unique indices of the vertices.
  /// \param vpmap receives `true` for each vertex of the component that was given a position.
  ///
  /// \return `OK` or an error, one of
  /// - `ERROR_EMPTY_MESH`: `bhd` is null or has no face at its edge;
  /// - `ERROR_NON_TRIANGULAR_MESH`: a face is not a triangle;
  /// - `ERROR_NO_TOPOLOGICAL_DISC`: `bhd` is not on a border, the component has handles, or
  ///   a vertex is not manifold;
  /// - `ERROR_BORDER_TOO_SHORT`: no border has three edges;
  /// - `ERROR_WRONG_PARAMETER`: a coordinate is not finite;
  /// - `ERROR_NO_1_TO_1_MAPPING`: floating-point arithmetic found no map of the promised kind, or the
  ///   number type of the UVs cannot represent it;
  /// - `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`: the solver failed.
  template <typename VertexUVmap, typename VertexIndexMap, typename VertexParameterizedMap>
  Error_code parameterize(TriangleMesh& mesh, halfedge_descriptor bhd, VertexUVmap uvmap, VertexIndexMap vimap,
                          VertexParameterizedMap vpmap)
  {
    CGAL_USE(vimap);
    internal::Mesh_chart<TriangleMesh> component;
    const Error_code error = component.read(mesh, bhd);
    if(error != OK)
      return error;
    const std::vector<internal::Rest_shape> shapes
      = internal::rest_shapes(component.chart().triangles(), component.points());
    std::vector<Eigen::Vector2d> uv;
    const internal::Newton_result result
      = Method_::map(component.chart(), component.points(), shapes, m_linear_solvers, uv);
    if(result.outcome != internal::Newton_outcome::FAILED)
      return component.write(std::move(uv), uvmap, vpmap, &Method_::is_valid);
    // Without a factorization there was no map to start from.
    return result.iterations == 0 ? ERROR_NO_1_TO_1_MAPPING : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  }

private:
  internal::Solvers m_linear_solvers;
};

} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FREE_BORDER_PARAMETERIZER_3_H
