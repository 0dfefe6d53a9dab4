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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_FOR_EACH_INDEX_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_FOR_EACH_INDEX_H

#include <CGAL/tags.h>

#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// calls `f(i)` for i in 0..size-1; each call writes to its own place only
template <typename ConcurrencyTag, typename Function>
void for_each_index(int size, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
    tbb::parallel_for(0, size, f);
    return;
  }
#else
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  for(int i = 0; i < size; ++i)
    f(i);
}

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_FOR_EACH_INDEX_H
