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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EXECUTION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EXECUTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

namespace CGAL::Surface_mesh_parameterization::internal {

using CGAL::internal::Graph_kernel::Execution;
using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;
using CGAL::internal::Graph_kernel::block_size;
using CGAL::internal::Graph_kernel::execute;
using CGAL::internal::Graph_kernel::execute_blocks;
using CGAL::internal::Graph_kernel::execute_both;
using CGAL::internal::Graph_kernel::execute_in_isolation;
using CGAL::internal::Graph_kernel::execution_of;
using CGAL::internal::Graph_kernel::number_of_blocks;
using CGAL::internal::Graph_kernel::number_of_threads;
using CGAL::internal::Graph_kernel::reduce_blocks;

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_EXECUTION_H
