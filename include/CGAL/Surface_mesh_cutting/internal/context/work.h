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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_WORK_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_WORK_H

#include <CGAL/license/Surface_mesh_cutting.h>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The unit of work is a solved face: one for each face of a map in each factorization, some five microseconds. No single
// stage does more than this without a result that is worth it: some ten seconds.
constexpr double work_of_stage = 2e6;

// The number of steps that a stage can afford if each takes so many solves of `faces`.
inline int affordable_steps(int faces, int solves = 1) { return int(work_of_stage / (double(solves) * faces)); }

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_WORK_H
