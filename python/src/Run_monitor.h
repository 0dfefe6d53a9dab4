// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Lets one thread watch and end a run of the library in another one.

#ifndef SURFACE_MESH_CUTTING_PYTHON_RUN_MONITOR_H
#define SURFACE_MESH_CUTTING_PYTHON_RUN_MONITOR_H

#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <mutex>

namespace binding {

struct Progress
{
  CGAL::Surface_mesh_cutting::Phase phase = CGAL::Surface_mesh_cutting::Phase::CANDIDATES;
  double fraction = -1; // of the call that is done; negative before the first one

  bool operator!=(const Progress& other) const { return phase != other.phase || fraction != other.fraction; }
};

// A model of `CuttingVisitor`.
class Run_monitor
{
  using Clock = std::chrono::steady_clock;

public:
  // The run ends `time_limit` seconds from now; infinity means no limit.
  explicit Run_monitor(double time_limit = std::numeric_limits<double>::infinity())
    : m_start(Clock::now()), m_time_limit(time_limit)
  {}

  bool go_further() const
  {
    const std::chrono::duration<double> elapsed = Clock::now() - m_start;
    return !m_is_stopped && !(elapsed.count() > m_time_limit);
  }

  // What progresses from here on is a part of the call, from `begin` to `end` (0 to 1).
  void begin_part(double begin, double end)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_begin = begin;
    m_end = end;
  }

  void progress(CGAL::Surface_mesh_cutting::Phase phase, double fraction)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_progress = {phase, m_begin + (m_end - m_begin) * fraction};
  }

  void ended(const CGAL::Surface_mesh_cutting::Run_profile& profile) { m_profile = profile; }

  // The profile of the last run that has ended.
  const CGAL::Surface_mesh_cutting::Run_profile& profile() const { return m_profile; }

  void stop() { m_is_stopped = true; }
  Progress latest_progress() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_progress;
  }

private:
  const Clock::time_point m_start;
  const double m_time_limit;
  std::atomic<bool> m_is_stopped{false};
  mutable std::mutex m_mutex;
  double m_begin = 0, m_end = 1;
  Progress m_progress;
  CGAL::Surface_mesh_cutting::Run_profile m_profile;
};

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_RUN_MONITOR_H
