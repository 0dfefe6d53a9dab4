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

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/cut_indexed_mesh.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

template Mesh_result cut_indexed_mesh<Sequential_tag>(
  const Indexed_mesh&, Output_kind, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>&, const Cutting_constraints&,
  const Context&);
#ifdef CGAL_LINKED_WITH_TBB
template Mesh_result cut_indexed_mesh<Parallel_tag>(
  const Indexed_mesh&, Output_kind, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>&, const Cutting_constraints&,
  const Context&);
#endif

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL
