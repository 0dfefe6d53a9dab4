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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CANDIDATES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CANDIDATES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/first_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/local_maximizers.h>

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/Spectral_conformal_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/hierarchical_map.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Chart_parameterizer;
using Surface_mesh_parameterization::internal::Newton_options;
using Surface_mesh_parameterization::internal::Newton_outcome;
using Surface_mesh_parameterization::internal::Newton_result;
using Surface_mesh_parameterization::internal::Rest_shape;
using Surface_mesh_parameterization::internal::Solvers;
using Surface_mesh_parameterization::internal::Symmetric_Dirichlet_energy;

// A local maximizer of the distortion and its scope of influence (paper, Section 3.1.1).
struct Candidate
{
  int vertex;
  double influence_radius;
};

// An as-conformal-as-possible map without flips. False if none was found or the run was stopped.
inline bool conformal_map(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes, const Corner_table& chart,
                          const Cutting_parameters& parameters, Run_control& control,
                          std::vector<Eigen::Vector2d>& uv)
{
  using namespace Surface_mesh_parameterization::internal;
  const std::vector<Point> points = chart_points(mesh, chart);
  int flips = 0;
  const Solvers& linear_solvers = *parameters.linear_solvers;
  if(parameters.conformal_solver == Conformal_solver::SPECTRAL &&
     spectral_conformal_map(chart, shapes, linear_solvers, uv, &flips, control) &&
     (flips == 0 || remove_flips(chart, points, uv)))
    return control.go_further();
  if(!control.go_further())
    return false;
  Chart_parameterizer parameterizer(chart, points, shapes, linear_solvers);
  Newton_options options;
  if(!parameters.use_published_method)
    options.decrement = 1e-4; // where the map is distorted shows long before
  options.go_further = control;
  const First_map first_map = parameters.use_published_method ? First_map::TUTTE : First_map::HIERARCHY;
  return parameterizer.conformal_map(uv, options, first_map).outcome != Newton_outcome::FAILED && !control.is_stopped();
}

// The isometric distortion of an as-conformal-as-possible map of the surface opened along `cut`, per
// vertex (paper, Equation (3)). Empty if no flip-free map was found or the run was stopped.
inline std::vector<double> proxy_distortion(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes,
                                            const Cut& cut, const Cutting_parameters& parameters,
                                            Run_control& control)
{
  using namespace Surface_mesh_parameterization::internal;
  const Corner_table chart = make_chart(mesh, cut);
  std::vector<Eigen::Vector2d> uv;
  if(!conformal_map(mesh, shapes, chart, parameters, control, uv))
    return {};
  return vertex_averages(shapes, mesh.triangles(),
                         face_energies<Symmetric_Dirichlet_energy>(shapes, chart.triangles(), uv),
                         mesh.number_of_vertices());
}

// The distance to the closest vertex with a larger value, infinite for the maximum. The search ends
// as soon as it meets one.
inline std::vector<Candidate> scopes_of_influence(const Indexed_mesh& mesh, const std::vector<double>& values,
                                                  const std::vector<int>& maximizers)
{
  Shortest_paths paths(mesh.graph());
  std::vector<Candidate> candidates;
  for(int v : maximizers)
  {
    double influence_radius = std::numeric_limits<double>::infinity();
    paths.clear();
    paths.add_source(v);
    paths.run([&](int w)
              {
                if(!(values[w] > values[v]))
                  return true;
                influence_radius = paths.distance(w);
                return false;
              });
    candidates.push_back({v, influence_radius});
  }
  return candidates;
}

// The faces farther from `centers` than `radius`, their largest connected part by area. The return
// value is that area; all faces if none is near.
inline double largest_remote_part(const Indexed_mesh& mesh, const Shortest_paths& from_centers, double radius,
                                  std::vector<char>& is_in_part)
{
  const auto is_near = [&](int f)
  {
    const Triangle& t = mesh.triangles()[f];
    return std::all_of(t.begin(), t.end(), [&](int v) { return from_centers.distance(v) < radius; });
  };
  is_in_part.assign(mesh.number_of_faces(), 0);
  std::vector<char> is_visited(mesh.number_of_faces(), 0);
  std::vector<int> part, largest;
  double largest_area = -1;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
  {
    if(is_visited[f] || is_near(f))
      continue;
    double area = 0;
    part.assign(1, f);
    is_visited[f] = 1;
    for(std::size_t i = 0; i < part.size(); ++i)
    {
      area += mesh.face_area(part[i]);
      for(int k = 0; k < 3; ++k)
      {
        const int o = mesh.opposite(3 * part[i] + k);
        if(o >= 0 && !is_visited[o / 3] && !is_near(o / 3))
        {
          is_visited[o / 3] = 1;
          part.push_back(o / 3);
        }
      }
    }
    if(area > largest_area)
    {
      largest_area = area;
      largest.swap(part);
    }
  }
  for(int f : largest)
    is_in_part[f] = 1;
  return largest_area;
}

// A vertex of one of the marked faces, any of them depending on `random_number`.
inline int start_in_part(const Indexed_mesh& mesh, const std::vector<char>& is_in_part, int random_number)
{
  const auto number_of_faces = std::count(is_in_part.begin(), is_in_part.end(), char(1));
  auto face = std::find(is_in_part.begin(), is_in_part.end(), char(1));
  for(auto i = random_number % number_of_faces; i > 0; --i)
    face = std::find(face + 1, is_in_part.end(), char(1));
  return mesh.triangles()[face - is_in_part.begin()][0];
}

// The second cut (paper, Section 3.1.1, Steps 3 to 6): far from the first one and its maximizers. The
// forbidden region shrinks until the largest part outside holds `minimum_area_ratio` of the area
// and, unless the paper is followed, a path of useful length; at radius 0 the part is the whole surface.
// `start` serves as a random number. Empty if the run was stopped.
inline std::vector<int> second_cut(const Indexed_mesh& mesh, int start, const std::vector<int>& first_cut,
                                   const std::vector<int>& first_maximizers, const Cutting_parameters& parameters,
                                   Run_control& control)
{
  constexpr double shrinking = 0.9;        // of the radius, for the next attempt (paper)
  constexpr double smallest_radius = 0.01; // in average edges: what it excludes is next to nothing
  constexpr double useful_share = 0.1;     // of the first cut's length: a shorter path opens too little to flatten
  const double useful_length = parameters.use_published_method ? 0 : useful_share * total_length(mesh, first_cut);
  Shortest_paths from_centers(mesh.graph());
  double area = 0;
  for(int e : first_cut)
  {
    from_centers.add_source(mesh.source(mesh.halfedge(e)));
    from_centers.add_source(mesh.target(mesh.halfedge(e)));
  }
  for(int v : first_maximizers)
    from_centers.add_source(v);
  from_centers.run();
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    area += mesh.face_area(f);

  const double average = average_edge_length(mesh);
  std::vector<char> is_in_part;
  double radius = parameters.forbidden_radius * average;
  while(control.go_further())
  {
    const double remote_area = largest_remote_part(mesh, from_centers, radius, is_in_part);
    // Summed in another order, the whole area may seem less than itself.
    if(radius == 0 || remote_area >= parameters.minimum_area_ratio * area)
    {
      const std::vector<int> path
        = path_to_farthest_vertex(mesh, start_in_part(mesh, is_in_part, parameters.use_published_method ? start : 0),
                                  parameters.number_of_sweeps(), edges_of_faces(mesh, is_in_part));
      if(radius == 0 || total_length(mesh, path) >= useful_length)
        return path;
    }
    radius = radius > smallest_radius * average ? shrinking * radius : 0;
  }
  return {};
}

// The candidates of a surface that is a disk already, or is opened to one along `cut` in any case.
// What lies on its border is not a candidate.
inline std::vector<Candidate> find_candidates_of_disk(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes,
                                                      const Cut& cut, const Cutting_parameters& parameters,
                                                      Run_control& control)
{
  const std::vector<double> distortion = proxy_distortion(mesh, shapes, cut, parameters, control);
  control.report(Phase::CANDIDATES, 1);
  if(distortion.empty())
    return {};
  const std::vector<char> is_open = open_vertices(mesh, cut);
  std::vector<int> maximizers = local_maximizers(mesh, distortion);
  maximizers.erase(std::remove_if(maximizers.begin(), maximizers.end(), [&](int v) { return is_open[v]; }),
                   maximizers.end());
  return scopes_of_influence(mesh, distortion, maximizers);
}

// The redundant set of candidates by the dual cutting strategy (paper, Section 3.1.1). Empty if a
// map failed or the run was stopped.
inline std::vector<Candidate> find_candidates(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes,
                                              int start, const Cutting_parameters& parameters, Run_control& control)
{
  const std::vector<int> first = path_to_farthest_vertex(mesh, start, parameters.number_of_sweeps());
  const std::vector<double> first_distortion
    = proxy_distortion(mesh, shapes, make_cut(mesh, first), parameters, control);
  control.report(Phase::CANDIDATES, 0.5);
  if(first_distortion.empty())
    return {};
  const std::vector<int> second
    = second_cut(mesh, start, first, local_maximizers(mesh, first_distortion), parameters, control);
  if(control.is_stopped())
    return {};
  std::vector<double> distortion
    = proxy_distortion(mesh, shapes, make_cut(mesh, second), parameters, control);
  control.report(Phase::CANDIDATES, 1);
  if(control.is_stopped())
    return {};
  if(distortion.empty())
    distortion = first_distortion;
  return scopes_of_influence(mesh, distortion, local_maximizers(mesh, distortion));
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CANDIDATES_H
