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

#ifndef CGAL_LICENSE_SURFACE_MESH_CUTTING_H
#define CGAL_LICENSE_SURFACE_MESH_CUTTING_H

#include <CGAL/config.h>
#include <CGAL/license.h>

// Tells users who ask for it (CGAL_LICENSE_WARNING, CGAL_LICENSE_ERROR) that
// they use the package under the GPL. It stands in for the file that CGAL
// generates from its list of GPL packages.
#ifndef CGAL_SURFACE_MESH_CUTTING_COMMERCIAL_LICENSE
#  ifdef CGAL_LICENSE_WARNING
     CGAL_pragma_warning("You use the CGAL package Surface_mesh_cutting under the terms of the GPLv3+.")
#  endif
#  ifdef CGAL_LICENSE_ERROR
#    error "CGAL_LICENSE_ERROR is defined, and the CGAL package Surface_mesh_cutting is used under the terms of the GPLv3+."
#  endif
#endif

#endif // CGAL_LICENSE_SURFACE_MESH_CUTTING_H
