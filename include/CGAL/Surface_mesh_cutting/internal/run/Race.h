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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RACE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RACE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/detection/corners.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Cut_refiner.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Run_plan.h>
#include <CGAL/Surface_mesh_cutting/internal/run/detect_features.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A start on its way: what is known of it, and its mapped cut.
struct Runner
{
  Detected_features detected;
  std::unique_ptr<Cut_refiner> refiner; // none if no cut was mapped
};

// A race of several starts by halving: all are mapped, the better half by the objective is brought to the bound and
// shortened, and the better half of these is refined further. On one
// resolution of a surface; features of most starts are detected on still coarser versions, which takes little time and leads
// to different cuts.
class Race
{
public:
  // The references are kept. `keeps_tree`: see `Refinement_goal`.
  Race(const Problem& problem, const Context& context, const Run_plan& plan, bool keeps_tree)
    : m_problem(problem), m_context(context), m_plan(plan),
      m_goal{Objective(context.parameters), plan.number_of_solves, keeps_tree, plan.rounds_of_moved_ends}
  {}

  // The prepared ones, those first that are refined, both by what the objective says. Only the first one's `detected` tells
  // about a failure; a run that was stopped returns what it has.
  std::vector<Runner> run() const
  {
    std::vector<Runner> runners(m_plan.number_of_starts);
    begin(runners[0], 0);
    execute(runners, 1, int(runners.size()), [&](Runner& runner, int i) { begin(runner, i); });
    drop_same(runners);
    sort(runners, int(runners.size()));
    m_context.control.report(Phase::REFINE, 0);
    const int number = is_far(runners.front()) ? 1 : m_plan.number_of_prepared(); // with the bound out of reach, one tells as much
    if(int(runners.size()) > number)
      runners.resize(number);
    advance(int(runners.size()), runners, [&](Cut_refiner& refiner) { refiner.prepare(m_goal); });
    m_context.control.report(Phase::REFINE, 0.5);
    advance((std::min)(m_plan.number_of_refined(), int(runners.size())), runners,
            [&](Cut_refiner& refiner) { refiner.refine(m_goal); });
    m_context.control.report(Phase::REFINE, 1);
    return runners;
  }

  // Refines one of those that were left behind, too.
  void refine(Runner& runner) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
    runner.refiner->refine(m_goal);
  }

private:
  // Starts by seeds alternate between those that ask features for the gain that the parameters say and for twice as much:
  // fewer ones, which others join on the way. Few runs depend on the given seed: it is that of the last start.
  Cutting_parameters parameters_of_start(int i) const
  {
    constexpr double more = 2;
    Cutting_parameters parameters = m_context.parameters;
    const int last = m_plan.number_of_starts - 1;
    parameters.random_seed = i < last ? unsigned(i) : (std::max)(parameters.random_seed, unsigned(last));
    if(i % 2 == 1)
      parameters.minimum_distortion_decrease *= more;
    return parameters;
  }

  // In faces, 0 for those of the problem: the first start sees all details, others see between 0.7 and 1.4 times the mean.
  int size_of_start(int i) const
  {
    constexpr double golden_ratio = 0.6180339887498949, mean = 2000;
    const double position = i * golden_ratio + 0.5;
    const double size = std::exp2(position - std::floor(position) - 0.5);
    return i == 0 ? 0 : int(size * (std::min)(mean, double(m_problem.mesh.number_of_faces())));
  }

  void begin(Runner& runner, int i) const
  {
    if(i > 0 && !m_context.control.go_further())
      return;
    Run_control control(m_context.control, Run_control::share_of_detection() / m_plan.number_of_starts);
    const int size = size_of_start(i);
    Cutting_parameters parameters = parameters_of_start(i);
    if(size == 0 && m_goal.keeps_tree) // a coarser version
      parameters = parameters_on_coarse_mesh(parameters);
    const Context context{parameters, control, m_context.clock, m_context.execution};
    if(i == 1)
      runner.detected.features = corners(m_problem);
    if(runner.detected.features.empty())
      runner.detected = detect_features(m_problem, size, context);
    if(runner.detected.status)
      map(runner);
  }

  void map(Runner& runner) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::CONNECT);
    m_context.control.report(Phase::CONNECT, 0);
    auto refiner = std::make_unique<Cut_refiner>(m_problem, m_context);
    const bool matters = !m_plan.refines() && !runner.detected.is_hopeless;
    runner.detected.status = refiner->connect(runner.detected.features, matters);
    if(!runner.detected.status)
      return;
    if(!refiner->map())
    {
      runner.detected.status = failure(m_context.control);
      return;
    }
    Open_chart& found = runner.detected.chart; // the paths that led to the features
    if(!found.cut.empty() && !m_goal.keeps_tree && !m_context.parameters.use_published_method && !m_problem.initial.is_given() &&
       m_goal.objective(cut_cost(m_problem.constraints, found.cut), found.energy) < value(*refiner))
      refiner->replace_tree(std::move(found));
    found = Open_chart();
    runner.refiner = std::move(refiner);
  }

  bool is_far(const Runner& runner) const
  {
    return runner.refiner && m_goal.objective.is_far(runner.refiner->cut().cost(), runner.refiner->cut().energy());
  }

  double value(const Cut_refiner& refiner) const { return m_goal.objective(refiner.cut().cost(), refiner.cut().energy()); }

  // The first `number` do the next stage, and the best of them come first then.
  template <typename Stage>
  void advance(int number, std::vector<Runner>& runners, const Stage& stage) const
  {
    execute(runners, 0, number, [&](Runner& runner, int)
    {
      const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
      if(runner.refiner && m_plan.refines())
        stage(*runner.refiner);
    });
    sort(runners, number);
  }

  // Side by side; if the run is stopped, the first one alone.
  template <typename Function>
  void execute(std::vector<Runner>& runners, int first, int end, const Function& function) const
  {
    Surface_mesh_parameterization::internal::execute(m_context.execution, end - first, [&](int i)
    {
      if(i == 0 || m_context.control.go_further())
        function(runners[first + i], first + i);
    });
  }

  void sort(std::vector<Runner>& runners, int number) const
  {
    const auto rank = [this](const Runner& runner)
    { return runner.refiner ? value(*runner.refiner) : std::numeric_limits<double>::infinity(); };
    std::stable_sort(runners.begin(), runners.begin() + number, [&](const Runner& a, const Runner& b) { return rank(a) < rank(b); });
  }

  // Keeps the first one with the same features.
  static void drop_same(std::vector<Runner>& runners)
  {
    std::vector<Runner> kept;
    for(Runner& runner : runners)
      if(kept.empty() || (runner.refiner && std::none_of(kept.begin(), kept.end(), [&](const Runner& other)
                                                         { return other.detected.features == runner.detected.features; })))
        kept.push_back(std::move(runner));
    runners = std::move(kept);
  }

  const Problem& m_problem;
  const Context m_context;
  const Run_plan m_plan;
  const Refinement_goal m_goal;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RACE_H
