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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_THREADS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_THREADS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/boost/graph/internal/Graph_kernel/for_each_index.h>

#include <algorithm>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// How many threads a parallel loop may use here; 1 if the tag is sequential.
template <typename ConcurrencyTag>
int number_of_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  if(std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    return (std::min)(tbb::this_task_arena::max_concurrency(),
                      int(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)));
#endif
  return 1;
}

// As `for_each_index()`; a thread that waits for the others in the end does not take up work from outside
// the loop, such as a whole component, which would keep it for long.
template <typename ConcurrencyTag, typename Function>
void for_each_index_in_isolation(int size, const Function& f)
{
  using CGAL::internal::Graph_kernel::for_each_index;
#ifdef CGAL_LINKED_WITH_TBB
  if(std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    tbb::this_task_arena::isolate([&] { for_each_index<ConcurrencyTag>(size, f); });
    return;
  }
#endif
  for_each_index<ConcurrencyTag>(size, f);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_THREADS_H
