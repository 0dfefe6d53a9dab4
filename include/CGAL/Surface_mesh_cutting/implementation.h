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

#ifndef CGAL_SURFACE_MESH_CUTTING_IMPLEMENTATION_H
#define CGAL_SURFACE_MESH_CUTTING_IMPLEMENTATION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

/// \file
/// \ingroup PkgSurfaceMeshCuttingRef
///
/// defines all functions that do not depend on types of the program. In a program of several units that is not linked with
/// the compiled library, all units define the macro `CGAL_SEPARATE_IMPLEMENTATION`, and one unit includes this header: the
/// others then compile several times as fast.

// In the compiled library, each paragraph is a unit.

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/cut_indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map_impl.h>
#include <CGAL/boost/graph/internal/Steiner_tree/solve_impl.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/connect_indexed_points.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/pack_indexed_charts.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/certify_indexed_packing.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/certify_indexed_map.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/check_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/find_indexed_symmetries.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/measure_indexed_map.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/measure_indexed_seams.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/mesh_warnings.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/visibilities.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Polygon_adapter_impl.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/read_soup.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/triangulate_polygons.h>

#endif // CGAL_SURFACE_MESH_CUTTING_IMPLEMENTATION_H
