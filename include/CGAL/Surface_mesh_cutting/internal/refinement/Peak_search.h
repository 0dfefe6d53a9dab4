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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_PEAK_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_PEAK_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Slit_search.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Distortion_bounds.h>

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/Scaffold_minimization.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Brings the faces of a chart, and its mean, below their bounds. Faces above are weighed more, solve by solve, as long as that
// flattens them; then slits are opened to those that are left.
class Peak_search
{
  using Scaffold_minimization = Surface_mesh_parameterization::internal::Scaffold_minimization;
  using Scaffold_options = Surface_mesh_parameterization::internal::Scaffold_options;

public:
  // `mesh` is a disk. The references are kept.
  Peak_search(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes, const Edge_constraints& constraints,
              const Distortion_bounds& bounds, const Context& context)
    : m_mesh(mesh), m_shapes(shapes), m_areas(Surface_mesh_parameterization::internal::area_weights(shapes)),
      m_constraints(constraints), m_bounds(bounds), m_context(context), m_slits(mesh, constraints)
  {}

  // The map is without overlaps before and afterwards if the parameters ask for that. The cut only grows.
  void lower(Injective_cut& cut)
  {
    constexpr double slow = 0.7; // of the excess, left after a solve
    Peaks peaks = this->peaks(cut.chart, cut.map.uv);
    for(bool is_open = !peaks.are_none(); is_open; is_open = !peaks.are_none() && has_time() && open_slits(peaks, cut))
    {
      solve(cut.chart, m_shapes, cut.map.uv);
      peaks = flattened(cut, slow);
    }
    if(!peaks.are_none())
      peaks = flattened(cut, 1);
    cut.map.energy = Surface_mesh_parameterization::internal::area_average(m_shapes, peaks.energies);
    if(peaks.are_none())
      return;
    m_faces_left = std::move(peaks.faces);
    if(m_faces_left.empty()) // the mean is above its bound
    {
      m_faces_left.resize(peaks.energies.size());
      std::iota(m_faces_left.begin(), m_faces_left.end(), 0);
    }
    CGAL::internal::Graph_kernel::sort_by_key(m_faces_left, [&](int f) { return -peaks.energies[f]; });
  }

  // After lower(): an edge between two points of the border, which divides the chart in two: the cheapest one of the most
  // distorted face above the bound, or of all if the mean is above, that has such edges. -1 if nothing is above or there is none.
  int dividing_edge(const Cut& cut) const
  {
    const std::vector<char> is_open = open_vertices(m_mesh, cut);
    for(int f : m_faces_left)
    {
      int best = -1;
      for(int h = 3 * f; h < 3 * f + 3; ++h)
      {
        const int e = m_mesh.edge(h);
        const bool divides = !m_mesh.is_border_edge(e) && !cut[e] && is_open[m_mesh.source(h)] && is_open[m_mesh.target(h)];
        if(divides && !m_constraints.is_forbidden(e) && (best < 0 || m_constraints.weights[e] < m_constraints.weights[best]))
          best = e;
      }
      if(best >= 0)
        return best;
    }
    return -1;
  }

private:
  // Energies, and by how much they exceed the bounds.
  struct Peaks
  {
    std::vector<double> energies; // of all faces
    std::vector<int> faces;
    double excess = 0; // of the faces and the mean, area-averaged

    bool are_none() const { return excess == 0; }
  };

  bool has_time() const { return m_number_of_solved_faces <= work_of_stage && m_context.control.go_further(); }

  Peaks peaks(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv) const
  {
    Peaks peaks;
    peaks.energies
      = Surface_mesh_parameterization::internal::face_energies<Symmetric_Dirichlet_energy>(m_shapes, chart.triangles(), uv);
    peaks.faces = m_bounds.faces_above(peaks.energies, m_areas);
    for(int f : peaks.faces)
      peaks.excess += m_areas[f] * (peaks.energies[f] - m_bounds.face);
    const double mean = Surface_mesh_parameterization::internal::area_average(m_shapes, peaks.energies);
    peaks.excess += (std::max)(0., mean - m_bounds.mean);
    return peaks;
  }

  // The map with the smallest excess that weights lead to; where a solve leaves more than the share `slow` of it, the last.
  Peaks flattened(Injective_cut& cut, double slow)
  {
    constexpr int maximum_rounds = 20;
    Peaks best = peaks(cut.chart, cut.map.uv), last = best;
    double former = best.excess;
    std::vector<Eigen::Vector2d> uv = cut.map.uv;
    std::vector<double> weights(m_areas.size(), 1);
    for(int round = 0; round < maximum_rounds && !best.are_none() && has_time(); ++round)
    {
      weigh(last.energies, weights);
      if(!solve(cut.chart, weighed_shapes(weights), uv))
        break;
      last = peaks(cut.chart, uv);
      if(last.excess < best.excess)
      {
        best = last;
        cut.map.uv = uv;
      }
      if(best.excess > slow * former)
        break;
      former = best.excess;
    }
    return best;
  }

  // A face weighs the more the longer it stays above the bound, and less again below, so slowly that it stays there.
  void weigh(const std::vector<double>& energies, std::vector<double>& weights) const
  {
    constexpr double slowest = 0.9, fastest = 4; // in one solve
    constexpr double ideal = Symmetric_Dirichlet_energy::ideal;
    const double allowed = m_bounds.face - ideal;
    for(std::size_t f = 0; f < energies.size(); ++f)
    {
      const double excess = (energies[f] - ideal) / allowed;
      weights[f] = (std::max)(1., weights[f] * std::clamp(excess * excess, slowest, fastest));
    }
  }

  std::vector<Rest_shape> weighed_shapes(const std::vector<double>& weights) const
  {
    std::vector<Rest_shape> shapes = m_shapes;
    for(std::size_t f = 0; f < shapes.size(); ++f)
      shapes[f].area *= weights[f];
    return shapes;
  }

  // From `uv`, with the areas of `shapes`; false if there is no better map.
  bool solve(const Corner_table& chart, const std::vector<Rest_shape>& shapes, std::vector<Eigen::Vector2d>& uv)
  {
    const bool is_injective = m_context.parameters.do_bijective;
    std::vector<Eigen::Vector2d> next = uv;
    const Newton_result newton = is_injective ? solve_injectively(chart, shapes, next) : solve_freely(chart, shapes, next);
    m_number_of_solved_faces += double(newton.iterations) * double(shapes.size());
    if(newton.outcome == Newton_outcome::FAILED ||
       (is_injective && !Surface_mesh_parameterization::internal::is_bijective(chart, next)))
      return false;
    const double scale = Surface_mesh_parameterization::internal::best_scale(m_shapes, chart.triangles(), next);
    for(Eigen::Vector2d& u : next)
      u *= scale;
    uv = std::move(next);
    return true;
  }

  Newton_result solve_injectively(const Corner_table& chart, const std::vector<Rest_shape>& shapes,
                                  std::vector<Eigen::Vector2d>& uv) const
  {
    Scaffold_options options;
    options.decrease = 1e-4; // peaks are a small part of the energy
    options.maximum_rounds = 4;
    options.go_further = m_context.control;
    return Scaffold_minimization(chart, shapes, *m_context.parameters.linear_solvers, options)(uv);
  }

  Newton_result solve_freely(const Corner_table& chart, const std::vector<Rest_shape>& shapes,
                             std::vector<Eigen::Vector2d>& uv) const
  {
    return Chart_parameterizer(chart, chart_points(m_mesh, chart), shapes, *m_context.parameters.linear_solvers)
      .improve_isometrically(uv, final_options(m_context));
  }

  // To where the excess is largest; false if no way leads there.
  bool open_slits(const Peaks& peaks, Injective_cut& cut)
  {
    constexpr std::size_t maximum_number = 4; // at once
    constexpr int farthest = 3;               // edges from the excess
    std::vector<double> distortion = slit_goals(peaks);
    const std::vector<char> is_excluded(m_mesh.number_of_vertices(), 0);
    std::vector<Slit> slits = m_slits.proposals(cut.cut, distortion, is_excluded, maximum_number);
    for(int i = 0; i < farthest && slits.empty(); ++i) // around faces that are on the border with all their corners
    {
      distortion = spread(distortion);
      slits = m_slits.proposals(cut.cut, distortion, is_excluded, maximum_number);
    }
    std::vector<int> edges;
    for(const Slit& slit : slits)
    {
      edges.insert(edges.end(), slit.edges.begin(), slit.edges.end());
      cut.ends.push_back(slit.tip);
    }
    CGAL::internal::Graph_kernel::sort_unique(edges); // paths of one forest, so that they leave a disk together
    cut.open(m_mesh, edges);
    return !edges.empty();
  }

  // Per vertex: how far its faces are above their bound, counted from the ideal; their energy if only the mean is above.
  std::vector<double> slit_goals(const Peaks& peaks) const
  {
    std::vector<double> energies = peaks.energies;
    if(!peaks.faces.empty())
    {
      energies.assign(m_areas.size(), Symmetric_Dirichlet_energy::ideal);
      for(int f : peaks.faces)
        energies[f] += peaks.energies[f] - m_bounds.face;
    }
    return Surface_mesh_parameterization::internal::vertex_averages(m_shapes, m_mesh.triangles(), energies,
                                                                    m_mesh.number_of_vertices());
  }

  // The mean of each vertex and its most distorted neighbor.
  std::vector<double> spread(const std::vector<double>& values) const
  {
    std::vector<double> largest = values;
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      const int v = m_mesh.source(m_mesh.halfedge(e)), w = m_mesh.target(m_mesh.halfedge(e));
      largest[v] = (std::max)(largest[v], values[w]);
      largest[w] = (std::max)(largest[w], values[v]);
    }
    for(std::size_t v = 0; v < values.size(); ++v)
      largest[v] = (largest[v] + values[v]) / 2;
    return largest;
  }

  const Indexed_mesh& m_mesh;
  const std::vector<Rest_shape>& m_shapes;
  const std::vector<double> m_areas; // in shares of the whole
  const Edge_constraints& m_constraints;
  const Distortion_bounds m_bounds;
  const Context m_context;
  Slit_search m_slits;
  double m_number_of_solved_faces = 0;
  std::vector<int> m_faces_left; // after lower(): the most distorted ones first
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_PEAK_SEARCH_H
