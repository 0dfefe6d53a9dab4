// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "supervise.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <chrono>
#include <exception>
#include <future>
#include <limits>
#include <optional>
#include <utility>

namespace binding {

namespace {

void run_with_threads(int number, const std::function<void()>& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::task_arena arena(number > 0 ? number : int(tbb::task_arena::automatic));
  arena.execute(work);
#else
  (void)number;
  work();
#endif
}

// What the thread that called does meanwhile. Holds the interpreter's lock except while it waits.
class Supervisor
{
public:
  Supervisor(Run_monitor& monitor, py::object progress) : m_monitor(monitor), m_progress(std::move(progress)) {}

  void wait_for(std::future<void>& work)
  {
    while(!is_ready(work))
      try
      {
        handle_signals();
        report_progress();
      }
      catch(py::error_already_set& error)
      {
        m_monitor.stop();
        if(!m_was_interrupted && !m_error && error.matches(PyExc_KeyboardInterrupt))
          m_was_interrupted = true;
        else if(!m_error)
          m_error = std::move(error);
      }
    if(m_error)
      throw py::error_already_set(std::move(*m_error));
    work.get();
  }

  bool was_interrupted() const { return m_was_interrupted; }

private:
  static bool is_ready(const std::future<void>& work)
  {
    constexpr std::chrono::milliseconds period(20);
    const py::gil_scoped_release unlocked;
    return work.wait_for(period) == std::future_status::ready;
  }

  static void handle_signals()
  {
    if(PyErr_CheckSignals() != 0)
      throw py::error_already_set();
  }

  void report_progress()
  {
    const Progress latest = m_monitor.latest_progress();
    if(m_progress.is_none() || m_error || !(latest != m_reported))
      return;
    m_reported = latest;
    if(m_progress(name_of(latest.phase), latest.fraction).is(py::bool_(false)))
      m_monitor.stop();
  }

  Run_monitor& m_monitor;
  py::object m_progress;
  Progress m_reported;
  bool m_was_interrupted = false;
  std::optional<py::error_already_set> m_error;
};

} // namespace

bool supervise(const Call& call, const std::function<void(Run_monitor&)>& work)
{
  double time_limit = std::numeric_limits<double>::infinity();
  int threads = 0; // all
  py::object progress = py::none();
  read(call, "time_limit", time_limit);
  read(call, "threads", threads);
  read(call, "progress", progress);

  Run_monitor monitor(time_limit);
  Supervisor supervisor(monitor, progress);
  std::future<void> future
    = std::async(std::launch::async, [&] { run_with_threads(threads, [&] { work(monitor); }); });
  supervisor.wait_for(future);
  return supervisor.was_interrupted();
}

} // namespace binding
