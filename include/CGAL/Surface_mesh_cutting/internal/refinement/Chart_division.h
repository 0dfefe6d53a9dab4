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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_DIVISION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_DIVISION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Open_chart.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_bisection.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_seams.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <Eigen/Core>

#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Divides a disk whose flip-free map overlaps itself into disks whose maps do not: each keeps the map that it has. This
// is what remains where the plane has no room, as for a ramp that winds around several times. First, parts that overlap
// themselves are bisected until none does; then those that do not overlap each other are joined again, across the most
// expensive seams first.
class Chart_division
{
public:
  // The references to the problem and to the chart are kept.
  Chart_division(const Problem& problem, const Context& context, const Open_chart& overlapping)
    : m_problem(problem), m_overlapping(overlapping), m_cut(overlapping.cut)
  {
    m_is_complete = bisect_all(context.control);
    if(m_is_complete)
      join();
  }

  // False if edges that must not be cut leave no way to divide the disk, or if the run was stopped.
  bool is_complete() const { return m_is_complete; }

  // The cut with the seams between the parts.
  const Cut& cut() const { return m_cut; }
  // Along which parts were bisected; what separates two parts is among them.
  const std::vector<std::vector<int> >& paths() const { return m_paths; }

private:
  // Each path ends on the border of the part that it divides, so that all parts are disks.
  bool bisect_all(Run_control& control)
  {
    std::vector<Indexed_component> parts = split_along(m_problem.mesh, m_cut);
    while(!parts.empty())
    {
      const Indexed_component part = std::move(parts.back());
      parts.pop_back();
      if(!control.go_further())
        return false;
      const Chart_bisection bisection(part.mesh, costs_of(part), uv_of(part));
      if(!bisection.is_needed())
        continue;
      if(bisection.path().empty())
        return false;
      std::vector<int> path;
      for(int e : bisection.path())
        path.push_back(part.edges[e]);
      for(int e : path)
        m_cut[e] = 1;
      m_paths.push_back(std::move(path));
      for(Indexed_component& half : split_along(part.mesh, make_cut(part.mesh, bisection.path())))
        parts.push_back(in_whole(std::move(half), part));
    }
    return true;
  }

  static Indexed_component in_whole(Indexed_component half, const Indexed_component& part)
  {
    for(int& f : half.faces)
      f = part.faces[f];
    for(int& e : half.edges)
      e = part.edges[e];
    return half;
  }

  std::vector<double> costs_of(const Indexed_component& part) const
  {
    std::vector<double> costs;
    for(int e : part.edges)
      costs.push_back(m_problem.constraints.weights[e]);
    return costs;
  }

  std::vector<Eigen::Vector2d> uv_of(const Indexed_component& part) const
  {
    std::vector<Eigen::Vector2d> uv(part.mesh.number_of_vertices());
    for(int h = 0; h < part.mesh.number_of_halfedges(); ++h)
      uv[part.mesh.source(h)] = m_overlapping.uv[m_overlapping.chart.source(3 * part.faces[h / 3] + h % 3)];
    return uv;
  }

  // Two disks become one along a seam; others between them either surround further parts, or end where these two met.
  // Parts that do not overlap in pairs do not overlap together.
  void join()
  {
    const Corner_table chart = make_chart(m_problem.mesh, m_cut);
    const Connected_parts parts(chart.opposites());
    std::vector<std::set<int> > overlapped = overlapping_parts(chart, parts);
    CGAL::internal::Graph_kernel::Disjoint_sets groups(parts.number);
    std::vector<Chart_seam> seams = seams_along(m_paths, m_problem, m_cut, parts);
    CGAL::internal::Graph_kernel::sort_by_key(seams, [](const Chart_seam& seam) { return -seam.cost; });
    for(const Chart_seam& seam : seams)
    {
      const int a = groups.find(seam.parts.first), b = groups.find(seam.parts.second);
      if(a == b || overlapped[a].count(b) > 0)
        continue;
      groups.unite(a, b);
      const int joined = groups.find(a), other = joined == a ? b : a;
      for(int part : overlapped[other])
      {
        overlapped[part].erase(other);
        overlapped[part].insert(joined);
        overlapped[joined].insert(part);
      }
      for(int e : seam.edges)
        m_cut[e] = 0;
    }
    close_dead_ends(m_paths, m_problem.mesh, m_cut);
  }

  // For each part, those that it overlaps.
  std::vector<std::set<int> > overlapping_parts(const Corner_table& chart, const Connected_parts& parts) const
  {
    const std::vector<Eigen::Vector2d> uv = vertex_uvs(chart, corner_uvs(m_overlapping.chart, m_overlapping.uv));
    const Surface_mesh_parameterization::internal::Border_overlaps overlaps(chart, parts, uv);
    std::vector<std::set<int> > result(parts.number);
    const auto add = [&](int a, int b)
    {
      result[a].insert(b);
      result[b].insert(a);
    };
    for(const auto& [g, h] : overlaps.crossings())
      add(parts.part[g / 3], parts.part[h / 3]);
    for(const auto& [inner, outer] : overlaps.containments())
      add(inner, outer);
    return result;
  }

  const Problem& m_problem;
  const Open_chart& m_overlapping;
  Cut m_cut;
  std::vector<std::vector<int> > m_paths;
  bool m_is_complete = false;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_DIVISION_H
