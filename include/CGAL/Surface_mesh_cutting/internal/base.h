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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_BASE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_BASE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#ifndef CGAL_SURFACE_MESH_CUTTING_NAMED_PARAMETERS
#  error "The include directory of Surface_mesh_cutting must precede the include directory of CGAL."
#endif

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_BASE_H
