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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LIBRARY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LIBRARY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

// A function that is declared with it is inline, or comes from the compiled library: programs linked with the CMake
// target Surface_mesh_cutting::library define CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY and do not see its definition.
#ifdef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#define CGAL_SURFACE_MESH_CUTTING_INLINE
#else
#define CGAL_SURFACE_MESH_CUTTING_INLINE inline
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LIBRARY_H
