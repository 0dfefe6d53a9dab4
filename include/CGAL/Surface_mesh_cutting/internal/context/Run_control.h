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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_RUN_CONTROL_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_RUN_CONTROL_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Surface_mesh_cutting {

namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// Reports the progress of a run to its caller and learns when to stop; a stopped run stays stopped. Several
// threads may call it; only one at a time calls the caller.
class Run_control
{
  using Clock = std::chrono::steady_clock;

public:
  Run_control() = default;
  Run_control(Go_further go_further, std::function<void(Phase, double)> progress)
    : m_go_further(std::move(go_further)), m_progress(std::move(progress))
  {}

  bool go_further()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(!m_is_stopped && !m_go_further())
    {
      m_stop = Clock::now();
      m_is_stopped = true;
    }
    return !m_is_stopped;
  }
  bool is_stopped() const { return m_is_stopped; }

  // Whether the stop is so short a time ago that the caller still waits without complaint.
  bool was_just_stopped() const
  {
    constexpr std::chrono::milliseconds patience(500);
    return m_is_stopped && Clock::now() - m_stop < patience;
  }

  // What the layers below ask, as long as this control lives.
  operator Go_further() { return [this] { return go_further(); }; }

  // `fraction` of the phase that is done, 0 at its start.
  void report(Phase phase, double fraction)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_progress)
      m_progress(phase, fraction);
  }

private:
  Go_further m_go_further = always_go_further;
  std::function<void(Phase, double)> m_progress;
  Clock::time_point m_stop; // once it is stopped
  std::atomic<bool> m_is_stopped{false};
  std::mutex m_mutex;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_RUN_CONTROL_H
