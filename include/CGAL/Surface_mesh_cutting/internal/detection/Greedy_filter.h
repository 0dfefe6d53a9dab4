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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_GREEDY_FILTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_GREEDY_FILTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Trade_off.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/Speculative_map.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/initial_features.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Chooses among the candidates (paper, Section 3.1.2): one after the other is connected to the cut,
// and stays if this lowers the distortion by more than epsilon_iso. Terminals stay in any case. No
// forbidden edge is opened; candidates that only such edges lead to are passed over.
class Greedy_filter
{
public:
  // The references are kept.
  Greedy_filter(const Problem& problem, const Context& context)
    : m_mesh(problem.mesh), m_constraints(problem.constraints), m_parameters(context.parameters),
      m_control(context.control), m_disks(problem.mesh), m_paths(problem.mesh.graph()),
      m_maps(problem.mesh, problem.shapes, mapping_policy(context.parameters), context.execution,
             context.control),
      m_is_on_cut(problem.mesh.number_of_vertices(), 0), m_is_terminal(problem.terminal_marks())
  {}

  // For a closed surface of genus 0. False if no flip-free map was found or the run was stopped.
  bool run(const std::vector<Candidate>& candidates)
  {
    const Initial_features initial = initialize_features(m_mesh, m_constraints, candidates, m_parameters, m_disks);
    m_features = initial.features;
    return run_from(make_cut(m_mesh, initial.cut), initial.queue);
  }

  // For a surface that `cut` leaves as one disk: all candidates are judged against it.
  bool run_on_disk(const Cut& cut, std::vector<Candidate> candidates)
  {
    sort_by_scope(candidates);
    std::vector<int> queue;
    for(const Candidate& c : candidates)
      queue.push_back(c.vertex);
    m_disks.set(queue, m_parameters.candidate_radius * average_edge_length(m_mesh));
    return run_from(cut, queue);
  }

  const std::vector<int>& features() const { return m_features; }
  const Incremental_parameterization& map() const { return m_maps.map(); }
  // The cuts that were accepted, each containing the one before.
  const std::vector<Trade_off>& trade_offs() const { return m_trade_offs; }

private:
  bool run_from(const Cut& cut, const std::vector<int>& queue)
  {
    m_is_on_cut = open_vertices(m_mesh, cut);
    if(!m_maps.initialize(cut))
      return false;
    m_trade_offs.push_back({cut_length(m_mesh, cut), cut_cost(m_constraints, cut), map().energy()});
    judge_queue(std::deque<int>(queue.begin(), queue.end()));
    if(!m_parameters.use_published_method)
      judge_most_distorted();
    std::sort(m_features.begin(), m_features.end());
    return !m_control.is_stopped();
  }

  void mark_on_cut(int e)
  {
    m_is_on_cut[m_mesh.source(m_mesh.halfedge(e))] = 1;
    m_is_on_cut[m_mesh.target(m_mesh.halfedge(e))] = 1;
  }

  void judge_queue(std::deque<int> queue)
  {
    const double total = double(queue.size());
    std::size_t blocked = 0;
    while(!queue.empty() && !gives_up() && m_control.go_further())
    {
      m_control.report(Phase::FILTER, 1 - double(queue.size()) / total);
      int v = queue.front();
      queue.pop_front();
      std::vector<int> path;
      if(find_path(v, m_disks.faces_open_to(v), path))
        blocked = 0;
      else if(++blocked <= queue.size())
      {
        queue.push_back(v); // its path may open when others are judged
        continue;
      }
      else
      {
        // A full turn without progress: the nearest one passes through the disks of others.
        queue.push_back(v);
        v = take_nearest(queue, path);
        if(v < 0)
          return; // only forbidden edges lead to the others
        blocked = 0;
      }
      m_disks.release(v);
      judge(v, path, queue);
    }
  }

  bool gives_up() const
  {
    constexpr std::size_t enough_hopeless_features = 50; // a limit: on a hopeless map, every slit gains
    return map().is_hopeless() && m_features.size() > enough_hopeless_features;
  }

  // A path that connects a candidate to the cut.
  struct Proposal
  {
    int vertex;
    std::vector<int> path;
    double least_gain;
  };

  Proposal proposal(int v, const std::vector<int>& path) const
  {
    return {v, path, m_is_terminal[v] ? -std::numeric_limits<double>::infinity() : least_gain(path)};
  }

  // Judges `v` and, with several threads, those after it in the queue as if the ones before were
  // rejected.
  void judge(int v, const std::vector<int>& path, std::deque<int>& queue)
  {
    std::deque<Proposal> proposals(1, proposal(v, path));
    // A candidate on the cut gains nothing, for which the paper rejects it. Beyond the paper it stays, so that
    // what it has gained is not lost when the features are connected in another way.
    const std::size_t accepted
      = path.empty() ? std::size_t(m_parameters.use_published_method) : m_maps.open_first_useful([&](std::size_t i) -> const Proposal*
        {
          return i < proposals.size() || look_ahead(queue, proposals) ? &proposals[i] : nullptr;
        });
    if(accepted < proposals.size())
      accept(proposals[accepted]);
    // Those after it meet with another cut.
    for(; proposals.size() > accepted + 1; proposals.pop_back())
    {
      queue.push_front(proposals.back().vertex);
      m_disks.cover(queue.front());
    }
  }

  void accept(const Proposal& p)
  {
    m_features.push_back(p.vertex);
    for(int e : p.path)
      mark_on_cut(e);
    m_trade_offs.push_back({m_trade_offs.back().cut_length + total_length(m_mesh, p.path),
                            m_trade_offs.back().cut_cost + total_cost(m_constraints, p.path), map().energy()});
  }

  // Moves the first of the queue to the proposals if its path is known whether they are judged or not.
  bool look_ahead(std::deque<int>& queue, std::deque<Proposal>& proposals)
  {
    if(queue.empty() || m_is_terminal[proposals.back().vertex]) // which is accepted for sure
      return false;
    const int v = queue.front();
    std::vector<int> path;
    if(!find_path(v, m_disks.faces_open_to(v), path) || path.empty())
      return false;
    queue.pop_front();
    m_disks.release(v);
    proposals.push_back(proposal(v, path));
    return true;
  }

  double weight(int arc) const { return m_constraints.weights[m_mesh.graph().arcs[arc].edge]; }

  // A slit has to lower the energy by epsilon_iso (paper, Section 3.1.2), an expensive one by more.
  double least_gain(const std::vector<int>& slit) const
  {
    return (std::max)(m_parameters.minimum_distortion_decrease,
                      m_parameters.decrease_per_cost * total_cost(m_constraints, slit));
  }

  // The shortest path from `v` to the cut over the edges of the given faces (none given: all).
  bool find_path(int v, const std::vector<char>& is_open, std::vector<int>& path)
  {
    path.clear();
    if(m_is_on_cut[v])
      return true;
    int end = -1;
    m_paths.clear();
    m_paths.add_source(v);
    const auto is_edge_open = [&](int e)
    {
      const int h = m_mesh.halfedge(e), o = m_mesh.opposite(h);
      return is_open.empty() || is_open[h / 3] || (o >= 0 && is_open[o / 3]);
    };
    const auto& arcs = m_mesh.graph().arcs;
    m_paths.run([&](int w)
                {
                  if(!m_is_on_cut[w])
                    return true;
                  end = w;
                  return false;
                },
                [&](int a) { return is_edge_open(arcs[a].edge) ? weight(a) : Shortest_paths::infinity(); });
    if(end < 0)
      return false;
    m_paths.path(end, std::back_inserter(path));
    return true;
  }

  // Removes from the queue the candidate closest to the cut when disks are ignored; -1 if there is
  // none.
  int take_nearest(std::deque<int>& queue, std::vector<int>& path)
  {
    m_paths.clear();
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_is_on_cut[v])
        m_paths.add_source(v);
    int nearest = -1;
    m_paths.run([&](int w)
                {
                  if(std::find(queue.begin(), queue.end(), w) == queue.end())
                    return true;
                  nearest = w;
                  return false;
                },
                [this](int a) { return weight(a); });
    if(nearest < 0)
      return nearest;
    queue.erase(std::find(queue.begin(), queue.end(), nearest));
    path.clear();
    m_paths.path(nearest, std::back_inserter(path));
    return nearest;
  }

  // Smooth surfaces have too few local maximizers: once the queue is empty, proposes the most distorted
  // vertex under the same test, until several proposals in a row, far from each other, fail.
  void judge_most_distorted()
  {
    constexpr int maximum_failures = 3; // in a row
    const double reach = m_parameters.candidate_radius * average_edge_length(m_mesh);
    std::vector<char> is_excluded = m_is_on_cut;
    const std::vector<char> is_reachable = reachable_vertices(m_mesh, m_constraints);
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      is_excluded[v] = is_excluded[v] || !is_reachable[v];
    for(int failures = 0; failures < maximum_failures && !gives_up() && m_control.go_further();)
    {
      const int v = most_distorted_vertex(is_excluded);
      std::vector<int> path;
      if(v < 0 || !find_path(v, {}, path))
        return;
      const std::size_t before = m_features.size();
      std::deque<int> others;
      judge(v, path, others);
      if(m_features.size() > before)
      {
        failures = 0;
        for(int w = 0; w < m_mesh.number_of_vertices(); ++w)
          is_excluded[w] = is_excluded[w] || m_is_on_cut[w];
      }
      else
      {
        ++failures;
        exclude_around(v, reach, is_excluded);
      }
    }
  }

  int most_distorted_vertex(const std::vector<char>& is_excluded) const
  {
    const std::vector<double> distortion = map().vertex_distortion();
    int best = -1;
    for(int v = 0; v < int(distortion.size()); ++v)
      if(!is_excluded[v] && (best < 0 || distortion[v] > distortion[best]))
        best = v;
    return best;
  }

  void exclude_around(int v, double radius, std::vector<char>& is_excluded)
  {
    m_paths.clear();
    m_paths.add_source(v);
    m_paths.run([&](int w)
                {
                  if(m_paths.distance(w) > radius)
                    return false;
                  is_excluded[w] = 1;
                  return true;
                });
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  const Cutting_parameters& m_parameters;
  Run_control& m_control;
  Candidate_disks m_disks;
  Shortest_paths m_paths;
  Speculative_map m_maps;
  std::vector<char> m_is_on_cut, m_is_terminal; // per vertex
  std::vector<int> m_features;
  std::vector<Trade_off> m_trade_offs;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_GREEDY_FILTER_H
