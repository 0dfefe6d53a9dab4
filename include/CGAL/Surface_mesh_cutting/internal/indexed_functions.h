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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Distortion_measures.h>
#include <CGAL/Surface_mesh_cutting/Seam_measures.h>
#include <CGAL/Surface_mesh_cutting/Symmetry.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/Connected_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Indexed_packing.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/View.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Mesh_result.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Polygon_triangulation.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welding.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Indexed_symmetry.h>

#include <CGAL/boost/graph/internal/Graph_kernel/separate_implementation.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The large functions on index arrays, which do not depend on the caller's mesh: what the public functions call, and what
// the compiled library holds. The folder indexed_functions/ defines them, one header each; without the library, a public
// function includes the one that it calls.

// Refuses a mesh whose halfedges fit together but that is not manifold.
CGAL_INLINE_UNLESS_SEPARATE Indexed_status check_mesh(const Indexed_mesh& mesh, Execution execution);

// What is unusual about a mesh, though handled: why a result may look odd, or take long.
CGAL_INLINE_UNLESS_SEPARATE std::vector<Finding> mesh_warnings(const Indexed_mesh& mesh);

// The polygons of a surface as triangles. `opposites` holds the side across each side, or -1 on a border; no side has the
// same vertex twice. Linear in the number of corners on usual polygons.
CGAL_INLINE_UNLESS_SEPARATE
Polygon_triangulation triangulate_polygons(const std::vector<Point>& points, const Polygons& polygons,
                                           const std::vector<int>& opposites,
                                           const Go_further& go_further = always_go_further);

// Reads a polygon soup as a surface. Points that polygons use are finite, and indices in range. Nearly linear time.
CGAL_INLINE_UNLESS_SEPARATE
Soup_surface read_soup(const std::vector<Point>& points, const Polygons& soup, const Welding& welding, Execution execution,
                       const Go_further& go_further = always_go_further);

// Runs the method. `round`: what becomes of a UV at the scale of the indexed mesh when it is handed out and read back.
CGAL_INLINE_UNLESS_SEPARATE
Mesh_result cut_indexed_mesh(const Indexed_mesh& mesh, Output_kind output,
                             const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& round,
                             const Cutting_constraints& constraints, const Context& context);

// The symmetries of a mesh of which `diagonals` are no edges (empty: all are), from good to bad. The first one may be none.
CGAL_INLINE_UNLESS_SEPARATE
std::vector<Indexed_symmetry> find_indexed_symmetries(const Indexed_mesh& mesh, const Cut& diagonals, Symmetry choice,
                                                      Execution execution);

// Cuts the handles and then connects borders and terminals. The weight and its bound include those
// of the mandatory edges.
CGAL_INLINE_UNLESS_SEPARATE
Connected_cut connect_indexed_points(const Indexed_mesh& mesh, Edge_constraints constraints,
                                     const std::vector<int>& terminals, const Cutting_parameters& parameters,
                                     Execution execution, const Go_further& go_further);

// Whether a chart consists of disks, and a map given by its corners is proven to be valid.
CGAL_INLINE_UNLESS_SEPARATE
Indexed_status certify_indexed_map(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corner_uv, bool do_bijective);

// The measures of such a map, `resolution` at the scale of the indexed mesh, or why there are none.
CGAL_INLINE_UNLESS_SEPARATE
Indexed_status measure_indexed_map(const Indexed_mesh& mesh, const Cut& cut,
                                   const std::vector<Eigen::Vector2d>& corner_uv, Distortion_measures& measures);

// The measures of its seams, or why there are none.
CGAL_INLINE_UNLESS_SEPARATE
Indexed_status measure_indexed_seams(const Indexed_mesh& mesh, const Cut& cut, const std::vector<Eigen::Vector2d>& corner_uv,
                                     Execution execution, Seam_measures& measures);

// Moves the parts of a chart into the unit square. `mirrored_vertices`: per vertex of the chart, its mirror image; empty if there
// are none. `round`: what becomes of a UV when it is handed out and read back.
CGAL_INLINE_UNLESS_SEPARATE
Indexed_packing pack_indexed_charts(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corner_uv,
                                    const std::vector<int>& mirrored_vertices, const Packing_parameters& parameters,
                                    const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& round,
                                    Execution execution, Run_control& control);

// Whether the parts of a flat chart lie in the unit square and apart.
CGAL_INLINE_UNLESS_SEPARATE
Indexed_status certify_indexed_packing(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corner_uv,
                                       const Packing_parameters& parameters);

// The visibility of each edge, unless `control` ends the run. O(n k log n) for k rays on most surfaces.
CGAL_INLINE_UNLESS_SEPARATE
std::optional<std::vector<double> > visibilities(const Indexed_mesh& mesh, const View& view, Execution execution,
                                                Run_control& control);

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_H
