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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SORT_UNIQUE_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SORT_UNIQUE_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// Sorts values and keeps one of those that are equal.
template <typename Value>
void sort_unique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// Adds values, which may be there already; sorted, each once.
template <typename Value>
void add_unique(const std::vector<Value>& added, std::vector<Value>& values)
{
  values.insert(values.end(), added.begin(), added.end());
  sort_unique(values);
}

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SORT_UNIQUE_H
