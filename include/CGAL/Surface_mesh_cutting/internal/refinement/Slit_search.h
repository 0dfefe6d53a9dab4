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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_SLIT_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_SLIT_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/estimate_gains.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/local_maximizers.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Looks for the slit that lowers the distortion most for its cost. Promising are ends where the
// distortion is large and the cut is far: there is distortion all along the way. The few most
// promising ones are tried among the local maximizers of the distortion and of that product; the
// former may all lie on the cut.
class Slit_search
{
public:
  Slit_search(const Indexed_mesh& mesh, const Edge_constraints& constraints)
    : m_mesh(mesh), m_constraints(constraints), m_paths(mesh.graph())
  {}

  // `is_excluded` holds, per vertex, where no slit may end. The tip is -1 if there is none.
  Slit best(Incremental_parameterization& map, const std::vector<char>& is_excluded)
  {
    constexpr std::size_t number_of_trials = 12; // each costs the solve of a window
    std::vector<Slit> slits = proposals(map.cut(), map.vertex_distortion(), is_excluded, number_of_trials);
    estimate_gains(map, slits);
    Slit best;
    for(Slit& slit : slits)
      if(slit.gain_per_cost() > best.gain_per_cost())
        best = std::move(slit);
    return best;
  }

  // At most so many slits, those first that seem to gain most: to local maxima of the distortion, which is one value
  // per vertex, or of the distortion along the way there. Their gains are not known yet.
  std::vector<Slit> proposals(const Cut& cut, const std::vector<double>& distortion,
                              const std::vector<char>& is_excluded, std::size_t maximum_number)
  {
    measure_distances(cut);
    std::vector<double> score(distortion.size(), 0);
    for(std::size_t v = 0; v < score.size(); ++v)
      if(!is_excluded[v] && m_paths.distance(int(v)) < Shortest_paths::infinity())
        score[v] = (distortion[v] - Symmetric_Dirichlet_energy::ideal) * worth(int(v));
    std::vector<std::pair<double, int> > tips;
    for(bool by_score : {false, true})
      for(int v : local_maximizers(m_mesh, by_score ? score : distortion))
        if(score[v] > 0)
          tips.emplace_back(-score[v], v);
    CGAL::internal::Graph_kernel::sort_unique(tips);
    if(tips.size() > maximum_number)
      tips.resize(maximum_number);
    std::vector<Slit> slits;
    for(const auto& tip : tips)
      slits.push_back(slit_from(tip.second));
    return slits;
  }

  // The cheapest slit to `v`. The tip is -1 if there is none, since the cut passes through `v` or cannot reach it.
  Slit slit_to(int v, const Cut& cut)
  {
    measure_distances(cut);
    return is_off_cut(v) ? slit_from(v) : Slit();
  }

  // Slits to vertices that are cheaper to reach than `tip`, within `reach` of it. Their gains are not known yet.
  std::vector<Slit> cheap_ends_about(const Cut& cut, int tip, double reach)
  {
    measure_distances(cut);
    std::vector<Slit> slits;
    for(int end : ends_around(tip, reach))
      if(end != tip)
        slits.push_back(slit_from(end));
    return slits;
  }

  // Slits to ends all about the tip of a part of the cut that is closed: on the part itself and within `reach` of its
  // tip, each as far from the others as possible. Their gains are not known yet.
  std::vector<Slit> ends_about(const Cut& cut, const std::vector<int>& closed_edges, int tip, double reach)
  {
    constexpr int ends_on_part = 3, number_of_ends = 5;
    measure_distances(cut);
    std::vector<int> ends;
    for(int i = 1; i <= ends_on_part; ++i) // from the middle of each third
      ends.push_back(m_mesh.source(m_mesh.halfedge(closed_edges[(2 * i - 1) * closed_edges.size() / (2 * ends_on_part)])));
    Shortest_paths around(m_mesh.graph());
    for(double distance : {reach / 3, reach})
      add_spread(tip, distance, number_of_ends, around, ends);
    CGAL::internal::Graph_kernel::sort_unique(ends);
    std::vector<Slit> slits;
    for(int v : ends)
      if(is_off_cut(v) && v != tip)
        slits.push_back(slit_from(v));
    return slits;
  }

  // Short slits to vertices all about the ends of the cut, which most of them prolong, by about `reach` or an edge. Their
  // gains are not known yet.
  std::vector<Slit> prolongations(const Cut& cut, const std::vector<char>& is_excluded, double reach)
  {
    constexpr int number_of_directions = 5;
    measure_distances(cut);
    const std::vector<int> degrees = cut_degrees(m_mesh, cut);
    Shortest_paths around(m_mesh.graph());
    std::vector<int> tips;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(degrees[v] == 1)
        add_spread(v, (std::max)(reach, shortest_edge_at(v)), number_of_directions, around, tips);
    CGAL::internal::Graph_kernel::sort_unique(tips);
    std::vector<Slit> slits;
    for(int v : tips)
      if(is_off_cut(v) && !is_excluded[v])
        slits.push_back(slit_from(v));
    return slits;
  }

private:
  double shortest_edge_at(int v) const
  {
    double shortest = std::numeric_limits<double>::infinity();
    for(int a = m_mesh.graph().offsets[v]; a < m_mesh.graph().offsets[v + 1]; ++a)
      shortest = (std::min)(shortest, m_mesh.length(m_mesh.graph().arcs[a].edge));
    return shortest;
  }

  // `tip`, and the cheapest vertices within some distances of it, each twice the one before, up to `reach`; without
  // those on the cut.
  std::vector<int> ends_around(int tip, double reach) const
  {
    constexpr int number_of_distances = 6;
    double limit = std::ldexp(reach, 1 - number_of_distances);
    int cheapest = tip;
    std::vector<int> ends(1, tip);
    Shortest_paths around(m_mesh.graph());
    around.add_source(tip);
    around.run([&](int v)
    {
      for(; around.distance(v) > limit && limit <= reach; limit *= 2)
        ends.push_back(cheapest);
      if(m_paths.distance(v) < m_paths.distance(cheapest))
        cheapest = v;
      return limit <= reach;
    });
    CGAL::internal::Graph_kernel::sort_unique(ends);
    ends.erase(std::remove_if(ends.begin(), ends.end(), [this](int v) { return !is_off_cut(v); }), ends.end());
    return ends;
  }

  // Adds vertices within `reach` of `center`, each as far from it and from the others as possible. `around` is cleared: to
  // make it anew for each center takes time proportional to the surface.
  void add_spread(int center, double reach, int number, Shortest_paths& around, std::vector<int>& ends) const
  {
    std::vector<int> near;
    around.clear();
    around.add_source(center);
    around.run([&](int v)
               {
                 if(around.distance(v) <= reach)
                   near.push_back(v);
                 return around.distance(v) <= reach;
               });
    std::vector<double> distances(near.size(), std::numeric_limits<double>::infinity());
    for(int last = center; number > 0; --number)
    {
      for(std::size_t i = 0; i < near.size(); ++i)
        distances[i] = (std::min)(distances[i], (m_mesh.point(near[i]) - m_mesh.point(last)).norm());
      last = near[std::max_element(distances.begin(), distances.end()) - distances.begin()];
      ends.push_back(last);
    }
  }

  bool is_off_cut(int v) const { return m_paths.distance(v) < Shortest_paths::infinity() && m_paths.last_edge(v) >= 0; }

  void measure_distances(const Cut& cut)
  {
    const std::vector<char> is_open = open_vertices(m_mesh, cut);
    m_paths.clear();
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(is_open[v])
        m_paths.add_source(v);
    m_lengths.assign(m_mesh.number_of_vertices(), 0);
    m_paths.run([this](int v)
                {
                  const int e = m_paths.last_edge(v);
                  if(e >= 0)
                    m_lengths[v] = m_lengths[m_paths.predecessor(v)] + m_mesh.length(e);
                  return true;
                },
                [this](int a) { return m_constraints.weights[m_mesh.graph().arcs[a].edge]; });
  }

  // The length of the way to the cut: what distortion there is along it is gained. The less, the more a unit of it
  // costs.
  double worth(int v) const
  {
    const double length = m_lengths[v], cost = m_paths.distance(v);
    return cost > 0 ? length * (length / cost) : length;
  }

  Slit slit_from(int v) const
  {
    Slit slit;
    slit.tip = v;
    m_paths.path(v, std::back_inserter(slit.edges));
    slit.cost = total_cost(m_constraints, slit.edges);
    return slit;
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  Shortest_paths m_paths;
  std::vector<double> m_lengths; // of the paths
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_SLIT_SEARCH_H
