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

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Surface_mesh_cutting {

namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// Reports the progress of a run to its caller and learns when to stop; a stopped run stays stopped. Several
// threads may call it; only one at a time calls the caller.
//
// Stages tell how far a phase is. The caller learns how far the whole run is: the fraction that is done is an estimate, but
// never decreases. Where a part of the run goes through all phases, as a component or a start does, it has a control of its own.
class Run_control
{
  using Clock = std::chrono::steady_clock;

  // What all parts of a run share.
  struct Caller
  {
    Go_further go_further = always_go_further;
    std::function<void(Phase, double)> progress;
    std::atomic<bool> is_stopped{false};
    Clock::time_point stop; // once it is stopped
    std::mutex mutex;
  };

public:
  Run_control() : m_caller(std::make_shared<Caller>()) {}
  Run_control(Go_further go_further, std::function<void(Phase, double)> progress) : Run_control()
  {
    m_caller->go_further = std::move(go_further);
    m_caller->progress = std::move(progress);
  }

  // Of a part of `whole`, which has to live longer: a share of it. Once this control is gone, the part is done.
  Run_control(Run_control& whole, double share) : m_caller(whole.m_caller), m_whole(&whole), m_share(share) {}
  Run_control(const Run_control&) = delete;
  Run_control& operator=(const Run_control&) = delete;
  ~Run_control()
  {
    if(m_whole)
      finish();
  }

  bool go_further()
  {
    const std::lock_guard<std::mutex> lock(m_caller->mutex);
    if(!m_caller->is_stopped && !m_caller->go_further())
    {
      m_caller->stop = Clock::now();
      m_caller->is_stopped = true;
    }
    return !m_caller->is_stopped;
  }
  bool is_stopped() const { return m_caller->is_stopped; }

  // Whether the stop is so short a time ago that the caller still waits without complaint.
  bool was_just_stopped() const
  {
    constexpr std::chrono::milliseconds patience(500);
    return is_stopped() && Clock::now() - m_caller->stop < patience;
  }

  // What the layers below ask, as long as this control lives.
  operator Go_further() { return [this] { return go_further(); }; }

  // `fraction` of the phase that is done, 0 at its start.
  void report(Phase phase, double fraction)
  {
    const std::lock_guard<std::mutex> lock(m_caller->mutex);
    const Span span = span_of(phase);
    move_to(phase, span.begin + (span.end - span.begin) * fraction);
  }

  // All is done, unless the run was stopped.
  void finish()
  {
    const std::lock_guard<std::mutex> lock(m_caller->mutex);
    if(!is_stopped())
      move_to(m_phase, 1);
  }

  // How much of what a control stands for are the candidates and their selection.
  static double share_of_detection() { return span_of(Phase::FILTER).end; }

private:
  struct Span
  {
    double begin, end;
  };

  // Of a phase in a run; packing is one of its own.
  static Span span_of(Phase phase)
  {
    switch(phase)
    {
    case Phase::CANDIDATES:   return {0, 0.1};
    case Phase::FILTER:       return {0.1, 0.45};
    case Phase::CONNECT:      return {0.45, 0.5};
    case Phase::REFINE:       return {0.5, 0.8};
    case Phase::PARAMETERIZE: return {0.8, 1};
    default:                  return {0, 1};
    }
  }

  // Phases that come again, from another start, add nothing until they are further than before.
  void move_to(Phase phase, double done)
  {
    const double step = (std::max)(0., (std::min)(1., done) - m_done);
    const bool is_new = step > 0 || phase != m_phase || !m_has_reported;
    m_done += step;
    m_phase = phase;
    m_has_reported = true;
    if(m_whole)
      m_whole->move_to(phase, m_whole->m_done + m_share * step);
    else if(is_new && m_caller->progress)
      m_caller->progress(phase, m_done);
  }

  const std::shared_ptr<Caller> m_caller;
  Run_control* const m_whole = nullptr;
  const double m_share = 1;
  double m_done = 0; // of what this control stands for, from 0 to 1
  Phase m_phase = Phase::CANDIDATES; // the latest
  bool m_has_reported = false;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_RUN_CONTROL_H
