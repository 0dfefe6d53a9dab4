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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_CUT_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_CUT_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/run/features_of_start.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sort_by_key.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {


// Whether features come from several starts. A given cut, or the paper, says where to begin.
inline bool searches(const Problem& problem, const Cutting_parameters& parameters)
{
  return parameters.number_of_starts > 1 && !problem.initial.is_given();
}

// Cuts from several starts, of which the best is refined. All but the first look for features on coarser versions of
// the problem's surface, each on one of another size, which changes more than another first cut does. Their cuts are
// mapped on the surface itself; only those that promise most are worth many solves. On request, cuts through the
// features of the best and those of others follow, from which refinement removes what is not needed.
class Cut_search
{
  static constexpr double ideal = Symmetric_Dirichlet_energy::ideal;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  // The references are kept. Of a coarser version, only features are handed on; then the cut remains a tree.
  Cut_search(const Problem& problem, const Context& context, bool is_coarser_version)
    : m_problem(problem), m_context(context), m_parameters(context.parameters), m_control(context.control),
      m_keeps_tree(is_coarser_version)
  {}

  Detected_features run(int first_start)
  {
    std::vector<Found> found(m_parameters.number_of_starts);
    execute(m_context.execution, int(found.size()), [&](int i)
    {
      if(m_control.go_further())
        found[i] = find(first_start + i, i);
    });
    CGAL::internal::Graph_kernel::sort_by_key(found, [this](const Found& f) { return expected_cost(f); });
    Detected_features result = found.front().detected;
    if(found.front().cost < infinity)
      combine(found, result);
    if(m_control.is_stopped())
      result.status = failure(m_control);
    return result;
  }

private:
  // Features, and the cut through them.
  struct Found
  {
    Detected_features detected;
    Open_chart chart;
    double cost = infinity; // no cut was mapped
    double energy = infinity;
    std::vector<Trade_off> trade_offs;
  };

  Found find(int start, int place) const
  {
    Found found;
    found.detected = detect(start, place);
    if(found.detected.status)
      map(found);
    return found;
  }

  Detected_features detect(int start, int place) const
  {
    constexpr double number_of_faces = 2000; // of the coarser versions: enough for all but details
    constexpr double largest_share = 0.4;    // of the faces; with more, a start would cost as much as on the surface
    constexpr int solves_with_bound = 14, solves_without_bound = 6;
    Cutting_parameters parameters = m_parameters;
    parameters.number_of_starts = 1;
    parameters.moves_ends = false;
    parameters.number_of_shortening_solves = m_parameters.has_bound() ? solves_with_bound : solves_without_bound;
    parameters.coarse_number_of_faces
      = int(relative_size(place) * (std::min)(number_of_faces, largest_share * m_problem.mesh.number_of_faces()));
    Run_control control(m_control, Run_control::share_of_detection() / m_parameters.number_of_starts);
    const Context context{parameters, control, m_context.clock, m_context.execution};
    if(place == 0 || !is_coarsened(m_problem, parameters)) // one start at least sees all details
      return refined_features(m_problem, start, context);
    return rough_features(m_problem, coarser_version(m_problem, context), start, context);
  }

  // Between 0.7 and 1.4, evenly spread however many there are.
  static double relative_size(int place)
  {
    constexpr double golden_ratio = 0.6180339887498949;
    const double position = place * golden_ratio + 0.5;
    return std::exp2(position - std::floor(position) - 0.5);
  }

  void map(Found& found) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
    Cut_refiner refiner(m_problem, m_context);
    if(refiner.connect(found.detected.features, false) && refiner.map())
      take(refiner, found);
  }

  static void take(const Cut_refiner& refiner, Found& found)
  {
    found.detected.features = refiner.cut().features();
    found.chart = refiner.cut().chart();
    found.cost = refiner.cut().cost();
    found.energy = refiner.cut().energy();
    found.trade_offs = refiner.cut().trade_offs();
  }

  // The smaller, the better; with a bound, what the cut is likely to cost once it is at the bound: the excess of the
  // energy falls about with the third power of the length.
  double expected_cost(const Found& found) const
  {
    if(!m_parameters.has_bound())
      return found.energy + exchange_parameters().decrease_per_cost * found.cost;
    return found.cost * std::cbrt((found.energy - ideal) / (m_parameters.maximum_average_distortion - ideal));
  }

  bool is_better(const Found& a, const Found& b) const
  {
    const auto rank = [this](const Found& f)
    { return std::make_pair(m_parameters.excess(f.energy), m_parameters.has_bound() ? f.cost : expected_cost(f)); };
    return rank(a) < rank(b);
  }

  // Refines the first, and then its features together with those of the next ones.
  void combine(const std::vector<Found>& found, Detected_features& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
    m_control.report(Phase::REFINE, 0);
    const double least_limit = found.front().energy + exchange_parameters().minimum_distortion_decrease;
    constexpr int rounds_of_moved_ends = 0;
    const auto limited = [&](int number_of_solves)
    {
      return Refinement_goal{m_parameters.maximum_average_distortion, result.repair_threshold, number_of_solves,
                             m_keeps_tree, rounds_of_moved_ends, least_limit};
    };
    Found best = refined_best(found, limited, result.trade_offs);
    const std::size_t last = (std::min)(found.size(), std::size_t(m_parameters.number_of_combinations + 1));
    for(std::size_t i = 1; i < last && m_control.go_further(); ++i)
    {
      m_control.report(Phase::REFINE, double(i) / double(last));
      constexpr int number_of_solves = 24; // most of the features are good already
      std::vector<int> united = best.detected.features;
      if(found[i].cost == infinity || !add_remote(found[i].detected.features, best.chart.cut, united))
        continue;
      Cut_refiner refiner(m_problem, m_context);
      Found other = refined(refiner, united, limited(number_of_solves));
      add(other.trade_offs, result.trade_offs);
      if(is_better(other, best))
        best = std::move(other);
    }
    m_control.report(Phase::REFINE, 1);
    result.features = std::move(best.detected.features);
    std::sort(result.features.begin(), result.features.end());
    result.chart = std::move(best.chart);
    result.is_refined = true;
  }

  // Of the first ones, each refined a little, refines the best further. What a cut becomes is known to a few percent
  // only; without a bound, it is what counts.
  template <typename Limited>
  Found refined_best(const std::vector<Found>& found, const Limited& limited, std::vector<Trade_off>& trade_offs) const
  {
    constexpr int solves_with_bound = 20, solves_without_bound = 12, finalists_with_bound = 2;
    constexpr int more_solves_with_bound = 40, more_solves_without_bound = 6;
    const bool is_bounded = m_parameters.has_bound();
    const int number_of_finalists = (std::min)(is_bounded ? finalists_with_bound : 1, int(found.size()));
    std::vector<Cut_refiner> refiners(number_of_finalists, Cut_refiner(m_problem, m_context));
    std::vector<Found> finalists(number_of_finalists);
    execute(m_context.execution, number_of_finalists, [&](int i)
    {
      if(found[i].cost < infinity)
        finalists[i] = refined(refiners[i], found[i].detected.features,
                               limited(is_bounded ? solves_with_bound : solves_without_bound));
    });
    const auto better = [this](const Found& a, const Found& b) { return is_better(a, b); };
    const auto first = std::min_element(finalists.begin(), finalists.end(), better);
    Cut_refiner& refiner = refiners[first - finalists.begin()];
    Found last;
    if(first->cost < infinity && m_control.go_further())
      last = refined_further(refiner, limited(is_bounded ? more_solves_with_bound : more_solves_without_bound));
    for(const Cut_refiner& r : refiners)
      add(r.cut().trade_offs(), trade_offs);
    const Found& finalist = better(last, *first) ? last : *first;
    return better(finalist, found.front()) ? finalist : found.front();
  }

  static void add(const std::vector<Trade_off>& others, std::vector<Trade_off>& trade_offs)
  {
    trade_offs.insert(trade_offs.end(), others.begin(), others.end());
  }

  Found refined(Cut_refiner& refiner, const std::vector<int>& features, const Refinement_goal& goal) const
  {
    if(!refiner.connect(features, false) || !refiner.map())
      return Found();
    return refined_further(refiner, goal);
  }

  Found refined_further(Cut_refiner& refiner, const Refinement_goal& goal) const
  {
    refine(refiner, goal, exchange_parameters());
    Found found;
    take(refiner, found);
    return found;
  }

  // Without a bound: the best of several cuts has less distortion than that of one start, and gives some of it back
  // for a shorter cut.
  Cutting_parameters exchange_parameters() const
  {
    constexpr double more_distortion = 2.5, more_per_cost = 1.15; // more makes many cuts shorter than pays off
    Cutting_parameters parameters = m_parameters;
    parameters.minimum_distortion_decrease *= more_distortion;
    parameters.decrease_per_cost *= more_per_cost;
    return parameters;
  }

  // Adds those that are not at the cut already. False if all are.
  bool add_remote(const std::vector<int>& others, const Cut& cut, std::vector<int>& features) const
  {
    constexpr double distance = 3; // in average edges; slits find what is nearer
    const double nearest = distance * average_edge_length(m_problem.mesh);
    CGAL::internal::Graph_kernel::Shortest_paths paths(m_problem.mesh.graph());
    const std::vector<char> is_open = open_vertices(m_problem.mesh, cut);
    for(int v = 0; v < m_problem.mesh.number_of_vertices(); ++v)
      if(is_open[v])
        paths.add_source(v);
    paths.run();
    const std::size_t size = features.size();
    std::copy_if(others.begin(), others.end(), std::back_inserter(features),
                 [&](int v) { return paths.distance(v) > nearest; });
    return features.size() > size;
  }

  const Problem& m_problem;
  const Context m_context;
  const Cutting_parameters& m_parameters;
  Run_control& m_control;
  const bool m_keeps_tree;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_CUT_SEARCH_H
