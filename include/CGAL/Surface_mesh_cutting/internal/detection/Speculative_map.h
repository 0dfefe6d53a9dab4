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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_SPECULATIVE_MAP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_SPECULATIVE_MAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {


// A running map to which slits are proposed one after the other. Most are rejected, which leaves the map
// as it is; so, with several threads, further ones are tried meanwhile on copies of the map, as if those
// before were rejected. A trial is abandoned once one before it turns out to be useful. The outcome is
// that of one thread, to the last bit.
class Speculative_map
{
  static constexpr int none = (std::numeric_limits<int>::max)();

public:
  Speculative_map(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes, const Mapping_policy& policy,
                  Execution execution, Run_control& control)
    : m_execution(execution), m_control(control), m_trials(number_of_copies(execution), none)
  {
    for(std::size_t i = 0; i < m_trials.size(); ++i)
      m_copies.push_back(std::make_unique<Incremental_parameterization>(
        mesh, shapes, policy, [this, i] { return m_trials[i] <= m_first_useful && m_control.go_further(); }));
  }

  bool initialize(const Cut& cut)
  {
    m_are_equal = false;
    return m_copies[m_current]->initialize(cut);
  }

  const Incremental_parameterization& map() const { return *m_copies[m_current]; }

  // Opens the first useful slit. `proposal(i)` points to the i-th one, its `path` and the `least_gain` that
  // makes it useful, or is null if the next proposal depends on pending ones; it is called in order, by one
  // thread at a time. Returns the index of the slit that was opened; if there is none, an index beyond all
  // that were proposed.
  template <typename Proposal>
  int open_first_useful(Proposal proposal)
  {
    make_equal();
    m_first_useful = none;
    std::fill(m_trials.begin(), m_trials.end(), none);
    int number_of_trials = 0;
    std::mutex mutex;
    execute(m_execution, int(m_copies.size()), [&](int i)
    {
      const auto next = [&]
      {
        const std::lock_guard<std::mutex> lock(mutex);
        const bool is_over = m_first_useful < none || number_of_trials == look_ahead() || m_control.is_stopped();
        const auto slit = is_over ? nullptr : proposal(number_of_trials);
        if(slit != nullptr)
          m_trials[i] = number_of_trials++;
        return slit;
      };
      for(auto slit = next(); slit != nullptr; slit = next())
        if(m_copies[i]->try_slit(slit->path, slit->least_gain))
        {
          claim(m_trials[i]);
          m_copies[i]->converge();
          return;
        }
    });
    take_first_useful();
    return m_first_useful;
  }

private:
  // More would bring little: the map must converge after each accepted slit before the next one can be
  // tried.
  static std::size_t number_of_copies(Execution execution)
  {
    return std::size_t((std::min)(number_of_threads(execution), 4));
  }

  // How many slits are tried per call: more than there are threads, since some are rejected long before
  // others.
  int look_ahead() const { return m_copies.size() == 1 ? 1 : 4 * int(m_copies.size()); }

  // A rejected slit leaves no trace: the copies differ only after one was opened.
  void make_equal()
  {
    for(std::size_t i = 0; i < m_copies.size() && !m_are_equal; ++i)
      if(i != m_current)
        m_copies[i]->restore(m_copies[m_current]->state());
    m_are_equal = true;
  }

  void claim(int trial)
  {
    for(int first = m_first_useful; trial < first;)
      if(m_first_useful.compare_exchange_weak(first, trial))
        return;
  }

  void take_first_useful()
  {
    if(m_first_useful == none)
      return;
    m_are_equal = false;
    m_current = std::size_t(std::find(m_trials.begin(), m_trials.end(), m_first_useful) - m_trials.begin());
  }

  const Execution m_execution;
  Run_control& m_control;
  std::vector<std::unique_ptr<Incremental_parameterization> > m_copies;
  std::size_t m_current = 0; // the copy that is the map
  bool m_are_equal = false;
  std::vector<int> m_trials; // of each copy, the one in work or the latest
  std::atomic<int> m_first_useful{none};
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_SPECULATIVE_MAP_H
