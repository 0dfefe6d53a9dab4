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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_PHASE_CLOCK_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_PHASE_CLOCK_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Run_profile.h>
#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <mutex>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Adds up wall and CPU time (of all threads) and the unknowns of the systems that are factorized per phase. Several
// threads may measure; phases that run at the same time then have the CPU time and the unknowns of both.
class Phase_clock
{
  struct Moment
  {
    double wall, cpu;
    long long unknowns;
  };

public:
  Phase_clock() : m_total_start(now()) {}

  // For the solvers to add to.
  std::atomic<long long>& unknowns() { return m_unknowns; }

  // Measures a phase as long as it lives.
  class Measurement
  {
  public:
    Measurement(Phase_clock& clock, Phase phase) : m_clock(clock), m_phase(phase), m_start(clock.now()) {}
    Measurement(const Measurement&) = delete;
    Measurement& operator=(const Measurement&) = delete;
    ~Measurement()
    {
      const Moment end = m_clock.now();
      const std::lock_guard<std::mutex> lock(m_clock.m_mutex);
      share(m_clock.m_wall, m_phase) += end.wall - m_start.wall;
      share(m_clock.m_cpu, m_phase) += end.cpu - m_start.cpu;
      share(m_clock.m_counts, m_phase) += end.unknowns - m_start.unknowns;
    }

  private:
    Phase_clock& m_clock;
    Phase m_phase;
    Moment m_start;
  };

  Run_profile profile() const
  {
    const Moment end = now();
    return {with_total(m_wall, end.wall - m_total_start.wall), with_total(m_cpu, end.cpu - m_total_start.cpu),
            with_total(m_counts, end.unknowns)};
  }

private:
  Moment now() const
  {
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double>(wall).count(), double(std::clock()) / CLOCKS_PER_SEC,
            m_unknowns};
  }

  // Of `Phase_times` or `Phase_counts`.
  template <typename Sums>
  static decltype(Sums::total)& share(Sums& sums, Phase phase)
  {
    switch(phase)
    {
    case Phase::CANDIDATES: return sums.candidates;
    case Phase::FILTER:     return sums.filter;
    case Phase::CONNECT:    return sums.connect;
    case Phase::REFINE:     return sums.refine;
    default:                return sums.parameterize;
    }
  }

  template <typename Sums, typename Total>
  static Sums with_total(Sums sums, Total total)
  {
    sums.total = total;
    return sums;
  }

  std::atomic<long long> m_unknowns{0};
  std::mutex m_mutex; // of the sums
  Moment m_total_start;
  Phase_times m_wall, m_cpu;
  Phase_counts m_counts;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_PHASE_CLOCK_H
