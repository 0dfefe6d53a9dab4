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

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/connect_indexed_points.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

template Connected_cut connect_indexed_points<Sequential_tag>(
  const Indexed_mesh&, Edge_constraints, const std::vector<int>&, const Cutting_parameters&, const Go_further&);
#ifdef CGAL_LINKED_WITH_TBB
template Connected_cut connect_indexed_points<Parallel_tag>(
  const Indexed_mesh&, Edge_constraints, const std::vector<int>&, const Cutting_parameters&, const Go_further&);
#endif

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL
