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

#ifndef CGAL_SURFACE_MESH_CUTTING_VISIBILITY_WEIGHTS_H
#define CGAL_SURFACE_MESH_CUTTING_VISIBILITY_WEIGHTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/put_weights.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/View.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/Visitor.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <vector>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/visibilities.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

namespace internal {

inline Eigen::Vector3d read_axis(internal_np::Param_not_found) { return View().axis; }

// One that is no direction becomes NaN, which `check_view()` refuses.
template <typename Vector_3>
Eigen::Vector3d read_axis(const Vector_3& up_direction)
{
  const Eigen::Vector3d axis = Surface_mesh_parameterization::internal::to_vector_3(up_direction);
  return axis.stableNormalized().isZero() ? Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()) : axis;
}

template <typename NamedParameters>
View read_view(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  View view;
  view.number_of_rays = choose_parameter(get_parameter(np, internal_np::number_of_rays), view.number_of_rays);
  view.random_seed = choose_parameter(get_parameter(np, internal_np::random_seed), view.random_seed);
  view.axis = read_axis(get_parameter(np, internal_np::up_direction));
  view.is_uniform = choose_parameter(get_parameter(np, internal_np::use_uniform_directions), view.is_uniform);
  view.radius = choose_parameter(get_parameter(np, internal_np::occlusion_radius), view.radius);
  return view;
}

inline Indexed_status check_view(const View& view)
{
  const char* const message = view.number_of_rays < 1 ? "number_of_rays must be at least 1"
    : !Surface_mesh_parameterization::internal::is_finite(view.axis) ? "up_direction must be finite and not zero"
    : !(view.radius > 0) ? "occlusion_radius must be greater than 0" : nullptr;
  return message == nullptr ? Indexed_status() : Indexed_status(Status_code::WRONG_PARAMETER, message);
}

} // namespace internal

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// computes edge weights that favor hidden edges.
///
/// The weight of an edge is its length times a factor: `smallest_factor` where the surface fills the
/// whole view from the middle of the edge, 1 where it blocks none of it, and in between linear in the
/// free part of the view. The smaller `smallest_factor`, the longer cuts become to stay hidden. Random rays sample the view
/// on the side of the surface that its normals point to; closed parts are viewed from outside even if they are oriented
/// inward.
///
/// By default, the view is the hemisphere around the normal of the edge, weighted by the cosine of the
/// angle with it. Two named parameters give other views. With `up_direction`, all edges have the same hemisphere, like a
/// dome of sky, of which the underside of the surface sees little. With `occlusion_radius`, only nearby parts of the surface
/// block the view (ambient occlusion), so that grooves and folds count, but not distant parts opposite.
///
/// With \f$ n \f$ edges and \f$ k \f$ rays, the time is \f$ O(k\,n \log n) \f$ on most surfaces.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeWeightMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a value type that
///         `double` converts to
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_weight_map receives the weights, for the named parameter `edge_weight_map` of
///        `greedy_cut()`, `unwrap()` and the functions for the steps of the method
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
///        listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_rays}
///     \cgalParamDescription{the number of rays per edge, at least one}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`64`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{smallest_factor}
///     \cgalParamDescription{the factor of a hidden edge, between 0 and 1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.25`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{up_direction}
///     \cgalParamDescription{the axis of the hemisphere from which all edges are viewed; not zero}
///     \cgalParamType{a vector type with the members `x()`, `y()` and `z()`, such as `%Vector_3`}
///     \cgalParamDefault{each edge has its normal as axis}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{use_uniform_directions}
///     \cgalParamDescription{whether all directions of the hemisphere count equally, and not by the cosine of their angle
///                           with its axis}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{occlusion_radius}
///     \cgalParamDescription{the distance, as a fraction of the bounding box diagonal, up to which the surface blocks
///                           the view; greater than 0}
///     \cgalParamType{`double`}
///     \cgalParamDefault{infinite}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{the seed for drawing the directions of the rays}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{can end the run: it is called every few milliseconds, but not while the
///                           search structure is built}
///     \cgalParamType{a class model of `CuttingVisitor`, of which only `go_further()` is called}
///     \cgalParamDefault{`Surface_mesh_cutting::Default_visitor`}
///     \cgalParamExtra{It is copied; pass it by `std::ref` to keep it.}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run ends with
///                           `Status_code::STOPPED`; 0 means no limit, and a negative value ends the run at once}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \copydetails PkgSurfaceMeshCuttingWeightParameters
///
/// \return `Status_code::OK`; `Status_code::WRONG_PARAMETER`; `Status_code::STOPPED`; or, for an unsupported mesh,
///         `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD`
///         or `Status_code::INVALID_POINT`. Writes the weights only with `Status_code::OK`.
///
/// \sa `crease_weights()`
/// \sa `straightness_weights()`
/// \sa `painted_weights()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Result_status<TriangleMesh> visibility_weights(const TriangleMesh& tmesh, EdgeWeightMap edge_weight_map,
                                               const NamedParameters& np = parameters::default_values())
{
  const internal::View view = internal::read_view(np);
  const double smallest_factor = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::smallest_factor), 0.25);
  Default_visitor default_visitor;
  internal::Visitor_reference<NamedParameters>
    visitor = parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor),
                                           default_visitor);
  internal::Run_control control = internal::read_run_control(visitor, np);
  return internal::put_weights(tmesh, edge_weight_map, np, [&](const auto& adapter, std::vector<double>& factors)
  {
    internal::Indexed_status status = internal::check_factor("smallest_factor", smallest_factor);
    if(status)
      status = internal::check_view(view);
    if(!status)
      return status;
    const std::optional<std::vector<double> >
      values = internal::visibilities(adapter.mesh(), view,
                                      Surface_mesh_parameterization::internal::execution_of<ConcurrencyTag>(), control);
    if(!values)
      return internal::stopped_status();
    for(const double value : *values)
      factors.push_back(internal::interpolated_factor(smallest_factor, value));
    return status;
  });
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_VISIBILITY_WEIGHTS_H
