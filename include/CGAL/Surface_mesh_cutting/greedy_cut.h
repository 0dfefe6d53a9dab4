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

#ifndef CGAL_SURFACE_MESH_CUTTING_GREEDY_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_GREEDY_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Unwrap_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// finds a short cut that leaves only topological disks which can be flattened with low isometric
/// distortion: feature points are detected and connected by a short tree \cgalCite{cgal:zycf-gccp-20}.
/// The surface may have any number of handles, borders and components; borders are open already and
/// never marked.
///
/// The cost is dominated by solving sparse linear systems: a few dozen for the candidates and one or two
/// for each candidate that small windows do not decide. With \f$ n \f$ vertices, a system takes
/// \f$ O(n^{1.5}) \f$ time and \f$ O(n \log n) \f$ memory on usual meshes. The feature points of large
/// surfaces are found on a coarser version, see `coarse_number_of_faces`; then only a few systems have the
/// size of the surface. While feature points are connected, memory is linear in the size of the surface for
/// each of them; the search for a shortest tree is bounded by `maximum_number_of_states`.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface; it is not modified
/// \param edge_is_cut_map receives `true` or `false` for each edge if `Cut_result::has_result`, and is left alone
///        otherwise. See `make_seam_mesh()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{minimum_distortion_decrease}
///     \cgalParamDescription{the decrease of the area-averaged symmetric Dirichlet energy that a point must bring to be kept, \f$ \varepsilon_{iso} \f$}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.01`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_decrease_per_length}
///     \cgalParamDescription{the decrease of the area-averaged symmetric Dirichlet energy, per length in bounding box diagonals, that makes a point worth the cut to it; 0 leaves the decision to `minimum_distortion_decrease` alone, as in the paper}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.15`, and `0` with `faithful(true)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_distortion}
///     \cgalParamDescription{the area-averaged symmetric Dirichlet energy that the map must not exceed, greater than 4. The cut is made longer until the map of the surface opened along it keeps this bound, and then shortened as far as the bound allows}
///     \cgalParamType{`double`}
///     \cgalParamDefault{no bound}
///     \cgalParamExtra{if no cut is found that keeps it, the status is `Status_code::BOUND_NOT_REACHED`, and the result is the best one found}
///   \cgalParamNEnd
///   \cgalParamNBegin{coarse_number_of_faces}
///     \cgalParamDescription{the number of faces of the coarser version on which feature points are found; components of up to 5/4 as many faces are not coarsened, and none is with `0`}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`5000`, and `0` with `Effort::BEST` or `faithful(true)`}
///     \cgalParamExtra{constraints and terminals are observed on the mesh itself, where the points are connected. A component with an initial cut is not coarsened. On the coarser version, points have to bring only 0.85 times the decrease, since a coarse map resolves less of it}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_length_decrease}
///     \cgalParamDescription{the decrease of the cut length that an auxiliary point must bring when the points are connected greedily, as a fraction of the length of the bounding box diagonal, \f$ \varepsilon_{len} \f$}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.01`}
///     \cgalParamExtra{used by `Connection::GREEDY` with `faithful(true)` only}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_area_ratio}
///     \cgalParamDescription{the share of the area that must lie far from the first cut and its maximizers, \f$ \alpha \f$}
///     \cgalParamType{`double` between 0 and 1}
///     \cgalParamDefault{`0.1`}
///   \cgalParamNEnd
///   \cgalParamNBegin{influence_threshold}
///     \cgalParamDescription{the scope of influence above which a candidate is a feature point from the outset, in units of the average edge length, \f$ \beta \f$}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`20`}
///   \cgalParamNEnd
///   \cgalParamNBegin{forbidden_radius}
///     \cgalParamDescription{the initial distance of the second cut from the first cut and its maximizers, in units of the average edge length, \f$ d_n \f$}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`10`}
///   \cgalParamNEnd
///   \cgalParamNBegin{faithful}
///     \cgalParamDescription{whether to stay with the paper to the letter: no coarser version, conformal maps by Newton's method, only local maximizers of the proxy metric as candidates, points connected greedily, and no shortening. `effort` has no effect then}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{conformal_solver}
///     \cgalParamDescription{how the conformal maps are computed from which the candidates are read}
///     \cgalParamType{`Surface_mesh_cutting::Conformal_solver`}
///     \cgalParamDefault{`Conformal_solver::SPECTRAL`, and `Conformal_solver::KP_NEWTON` with `faithful(true)`}
///     \cgalParamExtra{spectral maps yield about as many candidates in a tenth of the time, and cuts of the same length and distortion}
///   \cgalParamNEnd
///   \cgalParamNBegin{effort}
///     \cgalParamDescription{how much work is put into a short cut}
///     \cgalParamType{`Surface_mesh_cutting::Effort`}
///     \cgalParamDefault{`Effort::DEFAULT`}
///     \cgalParamExtra{`Effort::DEFAULT` shortens the cut as long as that costs less than `minimum_distortion_decrease`, with a small budget of solves; `Effort::BEST` does so with a large one, tries four starts and takes the shortest cut among those whose energy is within `minimum_distortion_decrease` of the lowest}
///   \cgalParamNEnd
///   \cgalParamNBegin{connection}
///     \cgalParamDescription{how the feature points are connected}
///     \cgalParamType{`Surface_mesh_cutting::Connection`}
///     \cgalParamDefault{`Connection::BEST`, and `Connection::GREEDY` with `faithful(true)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_states}
///     \cgalParamDescription{the budget of the search for a shortest tree; it counts states, not seconds, so that results are reproducible}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`20000000`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{marks edges that are part of the cut from the start. They may separate the surface; then each part is cut to a disk}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_forbidden_map}
///     \cgalParamDescription{marks edges that must not be cut}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
///     \cgalParamDefault{no edge is forbidden}
///   \cgalParamNEnd
///   \cgalParamNBegin{initial_cut_map}
///     \cgalParamDescription{marks a cut to start from, such as seams drawn by hand. It is connected, extended and shortened; in contrast to constrained edges, its edges need not stay. Parts that it separates are joined again}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type}
///     \cgalParamDefault{no edge is marked}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_weight_map}
///     \cgalParamDescription{what it costs to cut an edge: paths and trees are sought whose sums of weights are small. Weights are not negative; an edge of infinite weight is not cut}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a number type as value type}
///     \cgalParamDefault{the lengths of the edges}
///     \cgalParamExtra{see `crease_weights()` and `visibility_weights()`. Lengths in the result are geometric; bounds on them are computed without this map only}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{marks vertices through which the cut has to pass unless they lie on a border; they are among the feature points}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value type}
///     \cgalParamDefault{no vertex is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{the seed from which the start vertex is drawn}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told about the progress and can end the run}
///     \cgalParamType{a class model of `CuttingVisitor`}
///     \cgalParamDefault{`Surface_mesh_cutting::Default_visitor`}
///     \cgalParamExtra{pass it by `std::ref` if it is not to be copied}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run ends with `Status_code::STOPPED`; 0 means no limit}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{the solver of all sparse systems, which are symmetric and positive definite. It keeps the
///                           settings it has. Its symbolic analysis serves as long as only the values of a matrix change; the
///                           unknowns come in an order that keeps the factors sparse, which CHOLMOD leaves as it is unless
///                           it was set up to try others}
///     \cgalParamType{a class with the member functions `analyzePattern()`, `factorize()`, `solve()`, and `info()` of the
///                    direct sparse solvers of \eigen, or a class model of `SparseLinearAlgebraWithFactorTraits_d`, such as
///                    `CGAL::Eigen_solver_traits` of a direct solver}
///     \cgalParamDefault{a Cholesky factorization of \eigen}
///     \cgalParamExtra{Each system has its own copy of a solver with the interface of \eigen. Pass a solver that cannot be
///                     copied by `std::ref`: as a model of the concept, it is lent to one system at a time, so that with
///                     several threads the systems wait for each other. The result does not depend on the number of threads.}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was found. Its `status` is `Status_code::OK`, or `Status_code::BOUND_NOT_REACHED` where
///         `maximum_distortion` cannot be kept or with `connection(Connection::EXACT)` where the budget does not
///         suffice for a proof, or
///         `Status_code::EMPTY_MESH`, `NOT_TRIANGULATED`, `NON_MANIFOLD` or `INVALID_POINT` for a surface
///         that the package does not take, `INFEASIBLE_CONSTRAINTS` with the edges or vertices in conflict,
///         `WRONG_PARAMETER`, with the edges of invalid weight if there are any, `NUMERICAL_FAILURE`, or
///         `STOPPED`.
///
/// \sa `unwrap()`
/// \sa `detect_feature_points()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeIsCutMap,
          typename NamedParameters = parameters::Default_named_parameters>
Cut_result<TriangleMesh> greedy_cut(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                    const NamedParameters& np = parameters::default_values())
{
  return internal::run<ConcurrencyTag>(tmesh, internal::Goal::CUT,
                                       [&](const auto& adapter, const internal::Mesh_result& result)
                                       { adapter.write_cut(result.cut, edge_is_cut_map); }, np);
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_GREEDY_CUT_H
