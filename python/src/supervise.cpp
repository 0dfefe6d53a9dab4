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
#include <set>
#include <thread>
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
      call_python([this]
      {
        handle_signals();
        report_progress();
      });
    call_python([this] { report_progress(); }); // the last one
    if(m_error)
      throw py::error_already_set(std::move(*m_error));
    work.get();
  }

  bool was_interrupted() const { return m_was_interrupted; }

private:
  template <typename Function>
  void call_python(const Function& function)
  {
    try
    {
      function();
    }
    catch(py::error_already_set& error)
    {
      m_monitor.stop();
      if(!m_was_interrupted && !m_error && error.matches(PyExc_KeyboardInterrupt))
        m_was_interrupted = true;
      else if(!m_error)
        m_error = std::move(error);
    }
  }

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
    if(m_progress(SMC::to_string(latest.phase), latest.fraction).is(py::bool_(false)))
      m_monitor.stop();
  }

  Run_monitor& m_monitor;
  py::object m_progress;
  Progress m_reported;
  bool m_was_interrupted = false;
  std::optional<py::error_already_set> m_error;
};

// All calls that have begun and not ended. Whoever touches this holds the interpreter's lock.
std::set<Run_monitor*> running;
std::optional<std::thread::id> closing_thread; // once no call of another one begins any more

class Running_call
{
public:
  explicit Running_call(Run_monitor& monitor) : m_monitor(monitor)
  {
    if(closing_thread && *closing_thread != std::this_thread::get_id())
      wait_for_end();
    running.insert(&m_monitor);
  }
  Running_call(const Running_call&) = delete;
  Running_call& operator=(const Running_call&) = delete;
  ~Running_call() { running.erase(&m_monitor); }

private:
  [[noreturn]] static void wait_for_end()
  {
    const py::gil_scoped_release unlocked;
    for(;;)
      std::this_thread::sleep_for(std::chrono::hours(1));
  }

  Run_monitor& m_monitor;
};

} // namespace

void stop_all_calls()
{
  constexpr std::chrono::milliseconds period(5);
  constexpr std::chrono::seconds patience(10); // a call may wait in its progress
  const auto end = std::chrono::steady_clock::now() + patience;
  closing_thread = std::this_thread::get_id();
  while(!running.empty() && std::chrono::steady_clock::now() < end)
  {
    for(Run_monitor* monitor : running)
      monitor->stop();
    const py::gil_scoped_release unlocked;
    std::this_thread::sleep_for(period);
  }
}

void forget_calls() { running.clear(); }

bool supervise(const Call& call, const std::function<void(Run_monitor&)>& work)
{
  double time_limit = std::numeric_limits<double>::infinity();
  int threads = 0; // all
  py::object progress = py::none();
  read(call, "time_limit", time_limit);
  read(call, "threads", threads);
  read(call, "progress", progress);

  Run_monitor monitor(time_limit);
  const Running_call running_call(monitor);
  Supervisor supervisor(monitor, progress);
  std::future<void> future
    = std::async(std::launch::async, [&] { run_with_threads(threads, [&] { work(monitor); }); });
  supervisor.wait_for(future);
  return supervisor.was_interrupted();
}

} // namespace binding
