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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_SYMMETRIC_CUTTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_SYMMETRIC_CUTTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Mesh_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Mesh_cutter.h>
#include <CGAL/Surface_mesh_cutting/internal/straightening/straightened.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>
#include <CGAL/Surface_mesh_cutting/internal/halves/Half_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/halves/Quotient_tree.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Cuts a surface that a reflection maps to itself such that it does so with the cut. The method runs on one half, with the plane as
// its border; then on the whole, where the cut of the half and its mirror image are given, and only edges of the plane may be cut
// besides: it finds out how much of the plane has to be.
class Symmetric_cutter
{
public:
  // The references are kept. The half is one: `Half_mesh::is_divided()`.
  Symmetric_cutter(const Indexed_mesh& mesh, Round round, const Cutting_constraints& constraints, const Context& context,
                   const Half_mesh& half)
    : m_mesh(mesh), m_round(std::move(round)), m_constraints(folded(constraints, half)), m_context(context), m_half(half)
  {}

  // Without a result if the run on one of them has none. Where a bound is missed since the halves are held together, they are held
  // together by less, or cut more, and at last cut apart.
  Mesh_result run(Output_kind output)
  {
    constexpr double excesses[] = {1, 0.8}; // of what the bound allows above the ideal
    constexpr double ideal = Symmetric_Dirichlet_energy::ideal;
    const double bound = m_context.parameters.maximum_average_distortion;
    Mesh_result best, first;
    const auto is_enough = [&] { return (best.has_result && !is_missed(best)) || m_context.control.is_stopped(); };
    for(const double excess : excesses)
    {
      const Mesh_result of_half = run_on_half(output, ideal + excess * (bound - ideal));
      if(!of_half.has_result)
        continue;
      const Cut connected = quotient_tree(m_mesh, m_constraints.edges, m_half, of_half, m_context);
      for(const Cut& cut : {connected, of_half.cut})
        if(!cut.empty() && !is_enough())
          take_better(run_on_whole(straight(cut), false, output), of_half, best);
      if(is_enough())
        return best;
      if(!first.has_result)
        first = of_half;
    }
    if(first.has_result)
      take_better(run_on_whole(first.cut, true, output), first, best);
    return best;
  }

private:
  static constexpr double share_of_run = 0.3; // of the time

  // Whether only the bound is not kept.
  static bool is_missed(const Mesh_result& result)
  {
    return result.has_result && result.status.finding.code == Status_code::BOUND_NOT_REACHED;
  }

  // Takes, if both cuts miss the bound, that with the lower energy.
  void take_better(Mesh_result result, const Mesh_result& of_half, Mesh_result& best) const
  {
    CGAL::internal::Graph_kernel::add_unique(m_half.unfolded(of_half.features), result.features);
    result.number_of_candidates += of_half.number_of_candidates + best.number_of_candidates;
    result.is_optimal = false;
    result.lower_bound = 0;
    if(!best.has_result || (result.has_result && (!is_missed(result) || result.average_energy < best.average_energy)))
      best = std::move(result);
  }

  // Constraints of one side hold on both. Edges without an image are not cut.
  static Cutting_constraints folded(Cutting_constraints constraints, const Half_mesh& half)
  {
    const Cutting_constraints given = constraints;
    for(std::size_t e = 0; e < given.edges.weights.size(); ++e)
      if(const int image = half.image(int(e)); image >= 0)
      {
        constraints.edges.weights[e] = 0.5 * (given.edges.weights[e] + given.edges.weights[image]);
        constraints.edges.mandatory[e] = given.edges.mandatory[e] || given.edges.mandatory[image];
        constraints.initial[e] = given.initial[e] || given.initial[image];
      }
      else
      {
        constraints.edges.weights[e] = std::numeric_limits<double>::infinity();
        constraints.initial[e] = 0;
      }
    for(const int v : given.terminals)
      constraints.terminals.push_back(half.vertex_image(v));
    CGAL::internal::Graph_kernel::sort_unique(constraints.terminals);
    return constraints;
  }

  Mesh_result run_on_half(Output_kind output, double bound)
  {
    const Indexed_component& half = m_half.half();
    Cutting_constraints constraints;
    constraints.edges = restriction(m_constraints.edges, half);
    constraints.initial = half.restriction(m_constraints.initial);
    for(int e = 0; e < half.mesh.number_of_edges(); ++e)
      if(half.mesh.is_border_edge(e))
        constraints.edges.mandatory[e] = constraints.initial[e] = 0;
    constraints.terminals = terminals_of_half();
    Cutting_parameters parameters = m_context.parameters;
    parameters.seam_smoothness = 0; // later, for both
    parameters.maximum_average_distortion = bound;
    // Each edge of a cut of the half is cut twice.
    if(std::find(m_half.plane().begin(), m_half.plane().end(), char(1)) != m_half.plane().end())
      parameters.decrease_per_cost *= 2 * bounding_box_diagonal(half.mesh) / bounding_box_diagonal(m_mesh);
    Run_control control(m_context.control, share_of_run);
    const bool needs_room = output == Output_kind::MAP && parameters.do_bijective;
    return Mesh_cutter(half.mesh, [](const Eigen::Vector2d& uv) { return uv; }, constraints,
                       Context{parameters, control, m_context.clock, m_context.execution})
      .run(needs_room ? Output_kind::MAP : Output_kind::CUT);
  }

  // A straightened cut of the half.
  Cut straight(const Cut& cut) const
  {
    const Edge_constraints constraints = restriction(m_constraints.edges, m_half.half());
    return straightened(m_half.half().mesh, constraints, cut, kept_vertices(constraints.mandatory),
                        0.01 * m_context.parameters.smoothness());
  }

  // Cuts what is given on the half, its mirror image, and the plane or as much of it as it takes.
  Mesh_result run_on_whole(const Cut& of_half, bool along_plane, Output_kind output)
  {
    const Cut given = m_half.unfolded(of_half);
    Cutting_constraints constraints = m_constraints;
    constraints.initial.assign(m_mesh.number_of_edges(), 0);
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      if(given[e] || (along_plane && m_half.plane()[e] && !constraints.edges.is_forbidden(e)))
        constraints.edges.mandatory[e] = 1;
      else if(!m_half.plane()[e] && !constraints.edges.mandatory[e])
        constraints.edges.weights[e] = std::numeric_limits<double>::infinity();
    Cutting_parameters parameters = m_context.parameters;
    if(!parameters.use_published_method)
      parameters.effort = Effort::FAST; // nearly all is decided
    Run_control control(m_context.control, share_of_run);
    return Mesh_cutter(m_mesh, m_round, constraints, Context{parameters, control, m_context.clock, m_context.execution})
      .run(output);
  }

  std::vector<int> terminals_of_half() const
  {
    const std::vector<int>& given = m_constraints.terminals;
    std::vector<int> terminals;
    for(int v = 0; v < int(m_half.half().vertices.size()); ++v)
      if(std::binary_search(given.begin(), given.end(), m_half.half().vertices[v]))
        terminals.push_back(v);
    return terminals;
  }

  // Marks the vertices of the half where the caller wants a cut.
  std::vector<char> kept_vertices(const Cut& mandatory) const
  {
    const Indexed_component& half = m_half.half();
    std::vector<char> is_kept(half.mesh.number_of_vertices(), 0);
    for(const int v : terminals_of_half())
      is_kept[v] = 1;
    for(int e = 0; e < half.mesh.number_of_edges(); ++e)
      if(mandatory[e])
        is_kept[half.mesh.source(half.mesh.halfedge(e))] = is_kept[half.mesh.target(half.mesh.halfedge(e))] = 1;
    return is_kept;
  }

  const Indexed_mesh& m_mesh;
  const Round m_round;
  const Cutting_constraints m_constraints; // the same on both sides
  const Context m_context;
  const Half_mesh& m_half;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_SYMMETRIC_CUTTER_H
