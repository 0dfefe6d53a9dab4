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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_DESCRIPTORS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_DESCRIPTORS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The types that stand for the elements of a surface in results. A surface that is no graph specializes them.
template <typename Surface>
struct Descriptors
{
  using vertex_descriptor = typename boost::graph_traits<Surface>::vertex_descriptor;
  using edge_descriptor = typename boost::graph_traits<Surface>::edge_descriptor;
  using face_descriptor = typename boost::graph_traits<Surface>::face_descriptor;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_DESCRIPTORS_H
