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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_FLAT_FUNCTIONS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_FLAT_FUNCTIONS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Connected_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Flat_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Flat_status.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Mesh_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Phase_clock.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Run_control.h>

#include <CGAL/Surface_mesh_parameterization/internal/library.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The large functions on flat arrays, which do not depend on the caller's mesh: what the public functions call, and what
// the compiled library holds. The folder flat_functions/ defines them, one header each; without the library, a public
// function includes the one that it calls.

// Refuses a mesh whose halfedges fit together but that is not manifold; warns of what is unusual.
CGAL_SURFACE_MESH_CUTTING_INLINE Flat_status check_mesh(const Flat_mesh& mesh);

// Runs the method. `round`: what becomes of a UV at the scale of the flat mesh when it is handed out and read back.
template <typename ConcurrencyTag>
Mesh_result cut_flat_mesh(const Flat_mesh& mesh, Goal goal,
                          const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& round,
                          const Cutting_constraints& constraints, const Request& request, Run_control& control,
                          Phase_clock& clock);

// Cuts the handles and then connects borders and terminals. The weight and its bound include those
// of the mandatory edges.
template <typename ConcurrencyTag>
Connected_cut cut_through_points(const Flat_mesh& mesh, Edge_constraints constraints, const std::vector<int>& terminals,
                                 const Request& request, const std::function<bool()>& go_further);

// Whether a chart consists of disks, and a map given by its corners is proven to be valid.
CGAL_SURFACE_MESH_CUTTING_INLINE
Flat_status certify_flat_map(const Chart& chart, const std::vector<Eigen::Vector2d>& corner_uv, bool do_bijective);

// The visibility of each edge, unless `control` ends the run. O(n k log n) for k rays on most surfaces.
template <typename ConcurrencyTag>
std::optional<std::vector<double> > visibilities(const Flat_mesh& mesh, int number_of_rays, unsigned int random_seed,
                                                 Run_control& control);

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_FLAT_FUNCTIONS_H
