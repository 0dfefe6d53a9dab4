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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COMPONENT_CUTTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COMPONENT_CUTTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Start_run.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The whole method for one connected surface (paper, Section 3): handles, features, connection and,
// on request, refinement and UVs. The features of a large surface are found on a coarser version
// of it, at a cost that no longer grows with the surface, and connected on the surface itself.
template <typename ConcurrencyTag>
class Component_cutter
{
public:
  // Nothing is mandatory yet. The references that the context holds are kept.
  Component_cutter(Problem problem, const Context& context)
    : m_problem(std::move(problem)), m_context(context)
  {}

  Component_result detect()
  {
    Component_result result;
    result.status = open_handles<ConcurrencyTag>(m_problem, m_context);
    if(!result.status)
      return result;
    Detected_features detected = detect_features<ConcurrencyTag>(m_problem, 0, m_context);
    result.status = detected.status;
    result.number_of_candidates = detected.number_of_candidates;
    result.features = std::move(detected.features);
    return result;
  }

  // Runs from as many starts as the parameters say. The best is the cheapest of those whose energy
  // is within epsilon_iso of the lowest, if possible among those that keep the bound. Only where no cut is there
  // yet, the start matters.
  Component_result run(bool needs_uv)
  {
    const bool is_closed = m_problem.is_sphere && !m_problem.initial.is_given();
    const int number_of_starts = is_closed ? m_context.parameters.number_of_starts : 1;
    Component_result failed;
    failed.status = open_handles<ConcurrencyTag>(m_problem, m_context);
    if(!failed.status)
      return failed;
    const Start_run<ConcurrencyTag> run_from(m_problem, m_context);
    std::vector<Component_result> results;
    for(int i = 0; i < number_of_starts && m_context.control.go_further(); ++i)
    {
      Component_result result = run_from(i, needs_uv || number_of_starts > 1);
      if(!result.has_cut && results.empty())
        return result;
      if(result.has_cut)
        results.push_back(std::move(result));
    }
    if(results.empty())
    {
      failed.status = failure(m_context.control);
      return failed;
    }
    return best_of(results);
  }

private:
  Component_result best_of(std::vector<Component_result>& results) const
  {
    const Cutting_parameters& parameters = m_context.parameters;
    double lowest = std::numeric_limits<double>::infinity();
    for(const Component_result& r : results)
      lowest = (std::min)(lowest, r.energy);
    const double limit = has_bound(parameters) ? (std::max)(parameters.maximum_average_distortion, lowest)
                                               : lowest + parameters.minimum_distortion_decrease;
    Component_result* best = nullptr;
    for(Component_result& r : results)
      if(r.energy <= limit && (best == nullptr || r.cost < best->cost))
        best = &r;
    return std::move(*best);
  }

  Problem m_problem;
  const Context m_context;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COMPONENT_CUTTER_H
