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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_JOINING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_JOINING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Open_chart.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_division.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_seams.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;
using Surface_mesh_parameterization::internal::Rest_shape;

// Joins the parts of a divided chart again where a map of both without overlaps adds little energy for the seam that it
// saves: parts that lie on each other may find room beside each other once they bend a little.
class Chart_joining
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  // `overlapping`: what was divided. The references, and those of the context, are kept. Maps without overlaps that come to an
  // energy of `hopeless` on the way are given up.
  Chart_joining(const Problem& problem, const Context& context, const Open_chart& overlapping, const Chart_division& division,
                double hopeless)
    : m_problem(problem), m_context(context), m_overlapping(overlapping), m_paths(division.paths()), m_hopeless(hopeless),
      m_cut(division.cut()), m_corners(corner_uvs(overlapping.chart, overlapping.uv)),
      m_energies(face_energies(problem.shapes, overlapping.chart, overlapping.uv)),
      m_area(surface_area(problem.shapes))
  {}

  // Joins parts across the seams that save most for the energy, none of which adds more than `energy_per_cost`, as long as the
  // energy of all is at most `goal`. What a joint adds grows with its parts: what it was before is where to look first, and what
  // was too much remains so.
  void join(double goal, double energy_per_cost)
  {
    const Connected_parts parts = current_parts();
    std::vector<Joint> joints = first_joints(parts);
    execute(m_context.parameters.linear_solvers->execution, int(joints.size()), [&](int i) { try_joint(joints[i]); });
    for(const Joint& joint : joints)
      m_number_of_solved_faces += joint.number_of_solved_faces;
    const auto pays = [&](const Joint& joint)
    {
      return energy() + joint.loss <= goal && joint.loss_per_cost() <= energy_per_cost && joint.loss_per_cost() < infinity;
    };
    while(!joints.empty() && m_context.control.go_further())
    {
      Joint& best = *std::min_element(joints.begin(), joints.end(), [](const Joint& a, const Joint& b)
                                      { return a.loss_per_cost() < b.loss_per_cost(); });
      if(best.loss == infinity)
        return;
      if(!best.is_current && has_time())
      {
        try_joint(best);
        m_number_of_solved_faces += best.number_of_solved_faces;
      }
      else if(best.is_current && pays(best))
        joints = joined(best, std::move(joints));
      else
        best.loss = infinity;
    }
  }

  const Cut& cut() const { return m_cut; }

  // Of all parts, area-averaged.
  double energy() const { return std::accumulate(m_energies.begin(), m_energies.end(), 0.) / m_area; }

  // The map on the chart that the cut leaves; parts lie anywhere.
  std::vector<Eigen::Vector2d> uv(const Corner_table& chart) const { return vertex_uvs(chart, m_corners); }

private:
  using Energy = Surface_mesh_parameterization::internal::Symmetric_Dirichlet_energy;

  // Two parts, and their map as one.
  struct Joint
  {
    Chart_seam seam;
    double loss = -infinity; // what it adds to the energy of all; not known at first, infinite if it is not possible
    bool is_current = false; // parts are what they were when the loss was found
    double number_of_solved_faces = 0;
    std::vector<int> closed;              // edges: the seam, and what ends at it
    double saved_cost = 0;                // of these
    std::vector<int> faces;
    std::vector<Eigen::Vector2d> corners; // three for each of the faces
    std::vector<double> energies;         // of each of them, times its area

    double loss_per_cost() const { return saved_cost > 0 ? loss / saved_cost : loss > 0 ? infinity : -infinity; }
  };

  // Times areas.
  static std::vector<double> face_energies(const std::vector<Rest_shape>& shapes, const Corner_table& chart,
                                           const std::vector<Eigen::Vector2d>& uv)
  {
    std::vector<double> energies
      = Surface_mesh_parameterization::internal::face_energies<Energy>(shapes, chart.triangles(), uv);
    for(std::size_t f = 0; f < energies.size(); ++f)
      energies[f] *= shapes[f].area;
    return energies;
  }

  // For further trials; joints that are known to be possible take none.
  bool has_time() const { return m_number_of_solved_faces <= work_of_stage; }

  Connected_parts current_parts() const { return Connected_parts(make_chart(m_problem.mesh, m_cut).opposites()); }

  // Those that are tried at first, together: with the most expensive seams, so many as do not take too long. The others follow
  // one by one, as long as there is time, once two parts have been joined.
  std::vector<Joint> first_joints(const Connected_parts& parts) const
  {
    constexpr double solves_of_trial = 5, enough_faces = work_of_stage / solves_of_trial; // of all their parts
    std::vector<int> sizes(parts.number, 0);
    for(int part : parts.part)
      ++sizes[part];
    std::vector<Joint> joints = joints_of(parts, {}), result;
    CGAL::internal::Graph_kernel::sort_by_key(joints, [](const Joint& joint) { return -joint.seam.cost; });
    double number_of_faces = 0;
    for(Joint& joint : joints)
    {
      const int size = sizes[joint.seam.parts.first] + sizes[joint.seam.parts.second];
      if(number_of_faces + size > enough_faces)
        continue;
      number_of_faces += size;
      result.push_back(std::move(joint));
    }
    return result;
  }

  // One for each seam between two parts; what is known from `former` ones of the same seam is kept.
  std::vector<Joint> joints_of(const Connected_parts& parts, std::vector<Joint> former) const
  {
    std::vector<Joint> joints;
    for(Chart_seam& seam : seams_along(m_paths, m_problem, m_cut, parts))
    {
      const auto same = std::find_if(former.begin(), former.end(),
                                     [&](const Joint& joint) { return joint.seam.edges == seam.edges; });
      joints.push_back(same == former.end() ? Joint() : std::move(*same));
      joints.back().seam = std::move(seam);
    }
    return joints;
  }

  // Takes the map of one, and returns what may follow.
  std::vector<Joint> joined(const Joint& joint, std::vector<Joint> joints)
  {
    const auto [a, b] = joint.seam.parts;
    for(int e : joint.closed)
      m_cut[e] = 0;
    for(std::size_t i = 0; i < joint.faces.size(); ++i)
    {
      m_energies[joint.faces[i]] = joint.energies[i];
      std::copy_n(joint.corners.begin() + 3 * i, 3, m_corners.begin() + 3 * joint.faces[i]);
    }
    for(Joint& other : joints)
      for(int part : {other.seam.parts.first, other.seam.parts.second})
        other.is_current = other.is_current && part != a && part != b;
    return joints_of(current_parts(), std::move(joints));
  }

  // The sides of what were seams are free, so that the energy may become less than it was.
  void try_joint(Joint& joint) const
  {
    joint.is_current = true;
    joint.loss = infinity;
    joint.number_of_solved_faces = 0;
    if(!m_context.control.go_further())
      return;
    Cut cut = m_cut;
    for(int e : joint.seam.edges)
      cut[e] = 0;
    close_dead_ends(m_paths, m_problem.mesh, cut);
    joint.closed.clear();
    joint.saved_cost = 0;
    for(int e = 0; e < m_problem.mesh.number_of_edges(); ++e)
      if(m_cut[e] && !cut[e])
      {
        joint.closed.push_back(e);
        joint.saved_cost += m_problem.constraints.weights[e];
      }
    const Corner_table whole = make_chart(m_problem.mesh, cut);
    const Connected_parts parts(whole.opposites());
    const int part = parts.part[m_problem.mesh.halfedge(joint.seam.edges.front()) / 3];
    joint.faces.clear();
    for(int f = 0; f < m_problem.mesh.number_of_faces(); ++f)
      if(parts.part[f] == part)
        joint.faces.push_back(f);
    const Corner_table chart = whole.part(joint.faces);
    if(chart.border_loops().size() == 1)
      map(chart, joint);
  }

  void map(const Corner_table& chart, Joint& joint) const
  {
    const std::vector<Rest_shape> shapes = m_problem.shapes_of(joint.faces);
    std::vector<Eigen::Vector2d> uv(chart.number_of_vertices());
    double former_energy = 0;
    for(std::size_t i = 0; i < joint.faces.size(); ++i)
    {
      const int f = joint.faces[i];
      former_energy += m_energies[f];
      for(int k = 0; k < 3; ++k)
        uv[chart.source(3 * int(i) + k)] = m_overlapping.uv[m_overlapping.chart.source(3 * f + k)];
    }
    Newton_result start;
    start.outcome = Newton_outcome::CONVERGED;
    start.energy = Energy::ideal;
    const Newton_result newton = Surface_mesh_parameterization::internal::make_bijective(
      chart, chart_points(m_problem.mesh, chart), shapes, *m_context.parameters.linear_solvers, uv, start,
      final_options(m_context), m_hopeless);
    constexpr int iterations_before = 10; // about, for the map to start from
    joint.number_of_solved_faces = double(newton.iterations + iterations_before) * double(joint.faces.size());
    if(newton.outcome == Newton_outcome::FAILED)
      return;
    joint.energies = face_energies(shapes, chart, uv);
    joint.loss = (std::accumulate(joint.energies.begin(), joint.energies.end(), 0.) - former_energy) / m_area;
    joint.corners = corner_uvs(chart, uv);
  }

  const Problem& m_problem;
  const Context m_context;
  const Open_chart& m_overlapping;
  const std::vector<std::vector<int> >& m_paths;
  const double m_hopeless;
  Cut m_cut;
  std::vector<Eigen::Vector2d> m_corners; // of each halfedge: where its source lies
  std::vector<double> m_energies;         // of each face, times its area
  const double m_area;
  double m_number_of_solved_faces = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_JOINING_H
