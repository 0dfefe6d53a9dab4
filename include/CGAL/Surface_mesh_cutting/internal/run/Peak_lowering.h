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
    result.status.finding = finding(result);
  }

private:
  struct Lowered_chart
  {
    Injective_cut cut;
    int dividing_edge = -1;
  };

  Finding finding(const Component_result& result) const
  {
    const double bound = m_context.parameters.maximum_average_distortion;
    if(result.energy > bound)
      return bound_missed(result.energy, bound).finding;
    const std::vector<double> faces = energies(m_problem.shapes, result.chart, result.uv),
                              areas = Surface_mesh_parameterization::internal::area_weights(m_problem.shapes);
    const std::vector<int> charts = Connected_parts(result.chart.opposites()).part;
    return Distortion_bounds(m_context.parameters).status(faces, areas, chart_energies(faces, areas, charts), charts).finding;
  }

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
    return is_divided;
  }

  Lowered_chart lowered_chart(const Indexed_component& chart, double slack, const Component_result& result) const
  {
    const std::vector<Rest_shape> shapes = m_problem.shapes_of(chart.faces);
    Lowered_chart lowered;
    Injective_cut& cut = lowered.cut;
    cut.cut.assign(chart.edges.size(), 0);
    cut.chart = make_chart(chart.mesh, cut.cut);
    cut.map.uv.resize(cut.chart.number_of_vertices());
    for(std::size_t f = 0; f < chart.faces.size(); ++f)
      for(int k = 0; k < 3; ++k)
        cut.map.uv[cut.chart.triangles()[f][k]] = result.uv[result.chart.triangles()[chart.faces[f]][k]];
    const double mean = mean_energy(shapes, cut.chart, cut.map.uv);
    Distortion_bounds bounds(m_context.parameters);
    bounds.face = with_reserve(bounds.face);
    bounds.mean = (std::min)(with_reserve(bounds.mean), mean + slack);
    const Edge_constraints constraints = internal::restriction(m_problem.constraints, chart);
    Peak_search search(chart.mesh, shapes, constraints, bounds, m_context);
    search.lower(cut);
    if(m_context.parameters.do_bijective)
      lowered.dividing_edge = search.dividing_edge(cut.cut);
    return lowered;
  }

  static std::vector<double> energies(const std::vector<Rest_shape>& shapes, const Corner_table& chart,
                                      const std::vector<Eigen::Vector2d>& uv)
  {
    return Surface_mesh_parameterization::internal::face_energies<Symmetric_Dirichlet_energy>(shapes, chart.triangles(), uv);
  }

  static double mean_energy(const std::vector<Rest_shape>& shapes, const Corner_table& chart,
                            const std::vector<Eigen::Vector2d>& uv)
  {
    return Surface_mesh_parameterization::internal::area_average(shapes, energies(shapes, chart, uv));
  }

  void take_maps(const std::vector<Indexed_component>& charts, const std::vector<Lowered_chart>& lowered,
                 Component_result& result) const
  {
    result.chart = make_chart(m_problem.mesh, result.cut);
    result.uv.resize(result.chart.number_of_vertices());
    for(std::size_t i = 0; i < charts.size(); ++i)
      charts[i].add_map(lowered[i].cut.chart, lowered[i].cut.map.uv, result.chart, result.uv);
    result.length = cut_length(m_problem.mesh, result.cut);
    result.cost = cut_cost(m_problem.constraints, result.cut);
    result.energy = mean_energy(m_problem.shapes, result.chart, result.uv);
  }

  const Problem& m_problem;
  const Context m_context;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_PEAK_LOWERING_H
