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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_GO_FURTHER_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_GO_FURTHER_H

#include <functional>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// Asks whoever started a computation whether to go on; false ends it soon. The only way to stop what takes long,
// in all layers.
using Go_further = std::function<bool()>;

inline bool always_go_further() { return true; }

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_GO_FURTHER_H
