// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SEPARATE_IMPLEMENTATION_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SEPARATE_IMPLEMENTATION_H

// Large functions that do not depend on the caller's types are declared in X.h and defined in X_impl.h, as elsewhere in
// CGAL. X.h includes X_impl.h, whose functions are inline, unless all units of a program define
// CGAL_SEPARATE_IMPLEMENTATION. Then one of them, or the compiled library, defines these functions for all by including
// CGAL/Surface_mesh_cutting/implementation.h.
#ifdef CGAL_SEPARATE_IMPLEMENTATION
#define CGAL_INLINE_UNLESS_SEPARATE
#else
#define CGAL_INLINE_UNLESS_SEPARATE inline
#endif

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SEPARATE_IMPLEMENTATION_H
