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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_PEAK_LOWERING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_PEAK_LOWERING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Peak_search.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A bound on the map as it will be rounded, and held by others in single precision: a little lower.
inline double with_reserve(double bound)
{
  constexpr double reserve = 1e-3; // of what the bound leaves above the ideal
  return Symmetric_Dirichlet_energy::ideal + (1 - reserve) * (bound - Symmetric_Dirichlet_energy::ideal);
}

// Brings faces and charts of a mapped component below the bounds that the parameters set, or as near as it comes: each chart
// by itself. Where maps must not overlap, a chart that is all border around what is above the bound is divided. The mean of
// the component keeps its bound, if it does.
class Peak_lowering
{
public:
  // The references are kept.
  Peak_lowering(const Problem& problem, const Context& context) : m_problem(problem), m_context(context) {}

  void operator()(Component_result& result) const
  {
    if(!result.has_map || !m_context.parameters.has_local_bounds())
      return;
    constexpr int maximum_rounds = 30; // of division
    for(int i = 0; i < maximum_rounds && lower(result) && m_context.control.go_further(); ++i)
      continue;
    result.keep_undominated_trade_offs();
  }

private:
  struct Lowered_chart
  {
    Injective_cut cut;
    std::vector<int> faces_left;
    bool are_single_faces_left = false;
    int dividing_edge = -1;
  };

  // True if a chart was divided.
  bool lower(Component_result& result) const
  {
    const double slack = m_context.parameters.maximum_average_distortion - result.energy;
    const std::vector<Indexed_component> charts = split_along(m_problem.mesh, result.cut);
    std::vector<Lowered_chart> lowered(charts.size());
    Surface_mesh_parameterization::internal::execute(m_context.execution, int(charts.size()), [&](int i)
    { lowered[i] = lowered_chart(charts[i], (std::max)(slack, 0.), result); });
    const Cut former = result.cut;
    bool is_divided = false;
    for(std::size_t i = 0; i < charts.size(); ++i)
    {
      charts[i].add_to(lowered[i].cut.cut, result.cut);
      for(int v : lowered[i].cut.ends)
        result.features.push_back(charts[i].vertices[v]);
      if(lowered[i].dividing_edge < 0)
        continue;
      result.cut[charts[i].edges[lowered[i].dividing_edge]] = 1;
      is_divided = true;
    }
    CGAL::internal::Graph_kernel::sort_unique(result.features);
    result.is_optimal = result.is_optimal && result.cut == former;
    take_maps(charts, lowered, result);
    say_if_missed(charts, lowered, result);
    return is_divided;
  }

  void say_if_missed(const std::vector<Indexed_component>& charts, const std::vector<Lowered_chart>& lowered,
                     Component_result& result) const
  {
    const Cutting_parameters& parameters = m_context.parameters;
    std::vector<int> single_faces, all_faces;
    for(std::size_t i = 0; i < charts.size(); ++i)
      for(int f : lowered[i].faces_left)
        (lowered[i].are_single_faces_left ? single_faces : all_faces).push_back(charts[i].faces[f]);
    if(result.energy > parameters.maximum_average_distortion)
      result.status.finding = bound_missed(result.energy, parameters.maximum_average_distortion).finding;
    else if(!single_faces.empty())
      result.status.finding = local_bound_missed("face", std::move(single_faces), parameters.maximum_face_distortion).finding;
    else if(!all_faces.empty())
      result.status.finding = local_bound_missed("chart", std::move(all_faces), parameters.maximum_chart_distortion).finding;
    else
      result.status.finding = Finding();
  }

  Lowered_chart lowered_chart(const Indexed_component& chart, double slack, const Component_result& result) const
  {
    const std::vector<Rest_shape> shapes = shapes_of(chart.faces);
    Lowered_chart lowered;
    Injective_cut& cut = lowered.cut;
    cut.cut.assign(chart.edges.size(), 0);
    cut.chart = make_chart(chart.mesh, cut.cut);
    cut.map.uv.resize(cut.chart.number_of_vertices());
    for(std::size_t f = 0; f < chart.faces.size(); ++f)
      for(int k = 0; k < 3; ++k)
        cut.map.uv[cut.chart.triangles()[f][k]] = result.uv[result.chart.triangles()[chart.faces[f]][k]];
    const double mean = mean_energy(shapes, cut);
    Distortion_bounds bounds(m_context.parameters);
    bounds.face = with_reserve(bounds.face);
    bounds.mean = (std::min)(with_reserve(bounds.mean), mean + slack);
    const Edge_constraints constraints = internal::restriction(m_problem.constraints, chart);
    Peak_search search(chart.mesh, shapes, constraints, bounds, m_context);
    search.lower(cut);
    lowered.faces_left = search.faces_left();
    lowered.are_single_faces_left = search.are_single_faces_left();
    if(m_context.parameters.do_bijective)
      lowered.dividing_edge = search.dividing_edge(cut.cut);
    return lowered;
  }

  static double mean_energy(const std::vector<Rest_shape>& shapes, const Injective_cut& cut)
  {
    using namespace Surface_mesh_parameterization::internal;
    return area_average(shapes, face_energies<Symmetric_Dirichlet_energy>(shapes, cut.chart.triangles(), cut.map.uv));
  }

  std::vector<Rest_shape> shapes_of(const std::vector<int>& faces) const
  {
    std::vector<Rest_shape> shapes;
    shapes.reserve(faces.size());
    for(int f : faces)
      shapes.push_back(m_problem.shapes[f]);
    return shapes;
  }

  void take_maps(const std::vector<Indexed_component>& charts, const std::vector<Lowered_chart>& lowered,
                 Component_result& result) const
  {
    result.chart = make_chart(m_problem.mesh, result.cut);
    result.uv.resize(result.chart.number_of_vertices());
    for(std::size_t i = 0; i < charts.size(); ++i)
    {
      const Injective_cut& cut = lowered[i].cut;
      for(std::size_t f = 0; f < charts[i].faces.size(); ++f)
        for(int k = 0; k < 3; ++k)
          result.uv[result.chart.triangles()[charts[i].faces[f]][k]] = cut.map.uv[cut.chart.triangles()[f][k]];
    }
    result.length = cut_length(m_problem.mesh, result.cut);
    result.cost = cut_cost(m_problem.constraints, result.cut);
    result.energy = mean_energy(m_problem.shapes, {result.cut, result.chart, {result.uv, 0}, {}});
  }

  const Problem& m_problem;
  const Context m_context;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_PEAK_LOWERING_H
