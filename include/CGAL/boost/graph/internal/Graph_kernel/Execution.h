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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_EXECUTION_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_EXECUTION_H

#include <CGAL/tags.h>

#include <algorithm>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL::internal::Graph_kernel {

// Whether loops may use several threads. Results do not depend on it: each iteration writes to places of its own,
// and sums have a fixed order.
enum class Execution { SEQUENTIAL, PARALLEL };

template <typename ConcurrencyTag>
constexpr Execution execution_of()
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
#endif
  return std::is_convertible<ConcurrencyTag, Parallel_tag>::value ? Execution::PARALLEL : Execution::SEQUENTIAL;
}

// How many threads a loop may use here.
inline int number_of_threads(Execution execution)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(execution == Execution::PARALLEL)
    return (std::min)(tbb::this_task_arena::max_concurrency(),
                      int(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)));
#endif
  (void)execution;
  return 1;
}

// Calls `f`, within which a thread that waits for others does not take up work from outside, such as a whole
// component, which would keep it for long.
template <typename Function>
void execute_in_isolation(Execution execution, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(execution == Execution::PARALLEL)
  {
    tbb::this_task_arena::isolate(f);
    return;
  }
#endif
  (void)execution;
  f();
}

// Calls `f(i)` for i in 0..size-1.
template <typename Function>
void execute(Execution execution, int size, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(execution == Execution::PARALLEL && size > 1)
  {
    execute_in_isolation(execution, [&] { tbb::parallel_for(0, size, f); });
    return;
  }
#endif
  (void)execution;
  for(int i = 0; i < size; ++i)
    f(i);
}

// Calls both. The thread that is done first helps in the loops of the other one, which isolation would prevent.
template <typename First, typename Second>
void execute_both(Execution execution, const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(execution == Execution::PARALLEL)
  {
    tbb::parallel_invoke(first, second);
    return;
  }
#endif
  (void)execution;
  first();
  second();
}

// The iterations that one thread takes at a time: more than starting it costs.
constexpr int block_size = 4096;

inline int number_of_blocks(int size, int largest = block_size) { return (size + largest - 1) / largest; }

// Calls `f(begin, end)` for blocks of 0..size-1, of at most `largest`.
template <typename Function>
void execute_blocks(Execution execution, int size, const Function& f, int largest = block_size)
{
  execute(execution, number_of_blocks(size, largest),
          [&](int b) { f(b * largest, (std::min)(size, (b + 1) * largest)); });
}

// The results of `f(begin, end)` for blocks of 0..size-1, reduced in order.
template <typename T, typename Function, typename Reduce>
T reduce_blocks(Execution execution, int size, T value, const Function& f, const Reduce& reduce)
{
  std::vector<T> parts(number_of_blocks(size), value);
  execute_blocks(execution, size, [&](int begin, int end) { parts[begin / block_size] = f(begin, end); });
  for(const T& part : parts)
    value = reduce(std::move(value), part);
  return value;
}

// Polled for cancellation: returns false to stop. The only way to stop long computations, in all layers.
using Go_further = std::function<bool()>;

inline bool always_go_further() { return true; }

// Polls for cancellation in loops with short steps, once in many of them; a refusal is final.
class Patience
{
  const Go_further& m_go_further;
  unsigned int m_number_of_steps = 0;
  bool m_is_over = false;

public:
  explicit Patience(const Go_further& go_further) : m_go_further(go_further) {}

  // to be called at each step
  bool lasts()
  {
    if(++m_number_of_steps % 1024 == 0) // well below a millisecond
      m_is_over = m_is_over || !m_go_further();
    return !m_is_over;
  }
};

} // namespace CGAL::internal::Graph_kernel

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_EXECUTION_H
