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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_MARKED_TRIANGULATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_MARKED_TRIANGULATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace CGAL::Surface_mesh_parameterization::internal {

using Marked_kernel = Exact_predicates_inexact_constructions_kernel;

// The constrained Delaunay triangulation that all users share: every further type adds seconds of compile time.
// Vertices have an index, faces a mark. With this tag, constraints that cross end the triangulation by an exception;
// constructing their crossings would cost seconds, too. Constraints that touch leave fewer edges.
using Marked_triangulation = Constrained_Delaunay_triangulation_2<
  Marked_kernel,
  Triangulation_data_structure_2<
    Triangulation_vertex_base_with_info_2<int, Marked_kernel>,
    Triangulation_face_base_with_info_2<bool, Marked_kernel, Constrained_triangulation_face_base_2<Marked_kernel> > >,
  No_constraint_intersection_requiring_constructions_tag>;

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_MARKED_TRIANGULATION_H
