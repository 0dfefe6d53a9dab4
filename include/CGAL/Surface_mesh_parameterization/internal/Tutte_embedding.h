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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_TUTTE_EMBEDDING_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_TUTTE_EMBEDDING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Places the vertices of a closed border loop on the unit circle, spaced as on the surface.
// `lengths` holds the length of each border edge.
inline void map_border_to_circle(const Corner_table& chart, const std::vector<int>& loop,
                                 const std::vector<double>& lengths, std::vector<Eigen::Vector2d>& uv)
{
  double total = 0;
  for(double l : lengths)
    total += l;
  // Coincident points on the circle would flip triangles: no edge gets less than a small share.
  const double minimal = 1e-6 * total / double(loop.size());
  total += minimal * double(loop.size());
  double position = 0;
  for(std::size_t i = 0; i < loop.size(); ++i)
  {
    const double angle = 2 * EIGEN_PI * position / total;
    uv[chart.source(loop[i])] = Eigen::Vector2d(std::cos(angle), std::sin(angle));
    position += lengths[i] + minimal;
  }
}

// Tutte's embedding [Tut63, Flo03] with uniform weights: every inner vertex at the mean of its
// neighbors, the border as given in `uv`. In exact arithmetic the map is free of flips for a convex
// border; rounding can spoil it, so the caller checks. All other border loops are closed by a
// virtual vertex each. False if the system cannot be solved. Cost: one sparse factorization.
inline bool tutte_embedding(const Corner_table& chart, const std::vector<std::vector<int> >& loops,
                            std::size_t outer_loop, const Solvers& linear_solvers,
                            std::vector<Eigen::Vector2d>& uv)
{
  const int n = chart.number_of_vertices();
  std::vector<char> is_fixed(n, 0);
  for(int h : loops[outer_loop])
    is_fixed[chart.source(h)] = 1;

  std::vector<int> unknowns(n + loops.size(), -1);
  int size = 0;
  for(const Triangle& t : chart.triangles())
    for(int v : t)
      if(!is_fixed[v] && unknowns[v] < 0)
        unknowns[v] = size++;
  for(std::size_t l = 0; l < loops.size(); ++l)
    if(l != outer_loop)
      unknowns[n + l] = size++;

  std::vector<Eigen::Triplet<double> > entries;
  entries.reserve(6 * chart.triangles().size());
  Eigen::VectorXd right[2] = {Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)}; // of each coordinate
  const auto spring = [&](int v, int w)
  {
    for(int turn = 0; turn < 2; ++turn, std::swap(v, w))
    {
      if(unknowns[v] < 0)
        continue;
      entries.emplace_back(unknowns[v], unknowns[v], 1.);
      if(unknowns[w] < 0)
        for(int i = 0; i < 2; ++i)
          right[i][unknowns[v]] += uv[w][i];
      else if(unknowns[v] > unknowns[w])
        entries.emplace_back(unknowns[v], unknowns[w], -1.);
    }
  };
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    if(chart.opposite(h) < h)
      spring(chart.source(h), chart.target(h));
  for(std::size_t l = 0; l < loops.size(); ++l)
    if(l != outer_loop)
      for(int h : loops[l])
        spring(chart.source(h), n + int(l));
  if(size == 0)
    return true;

  Sparse_matrix laplacian(size, size); // the lower triangle
  laplacian.setFromTriplets(entries.begin(), entries.end());
  Symmetric_solver solver(linear_solvers);
  if(!solver.factorize(laplacian))
    return false;
  const Eigen::VectorXd solution[2] = {solver.solve(right[0]), solver.solve(right[1])};
  for(int v = 0; v < n; ++v)
    if(unknowns[v] >= 0)
      uv[v] = Eigen::Vector2d(solution[0][unknowns[v]], solution[1][unknowns[v]]);
  return std::all_of(uv.begin(), uv.end(), [](const Eigen::Vector2d& p) { return is_finite(p); });
}

// Tutte's embedding of a chart whose longest border loop becomes a circle, scaled to the surface's
// area. `points` holds the position of each chart vertex on the surface. False if rounding left a
// triangle that is not positive, or so small against the whole that its coordinates have lost their
// digits, or if the chart has no border of at least three edges.
inline bool tutte_map(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points, double area,
                      const Solvers& linear_solvers, std::vector<Eigen::Vector2d>& uv)
{
  const std::vector<std::vector<int> > loops = chart.border_loops();
  std::vector<double> lengths, outer_lengths;
  std::size_t outer = 0;
  double longest = -1;
  for(std::size_t l = 0; l < loops.size(); ++l)
  {
    double sum = 0;
    lengths.clear();
    for(int h : loops[l])
    {
      lengths.push_back((points[chart.target(h)] - points[chart.source(h)]).norm());
      sum += lengths.back();
    }
    if(loops[l].size() >= 3 && sum > longest)
    {
      longest = sum;
      outer = l;
      outer_lengths = lengths;
    }
  }
  if(longest < 0)
    return false;
  uv.assign(chart.number_of_vertices(), Eigen::Vector2d::Zero());
  map_border_to_circle(chart, loops[outer], outer_lengths, uv);
  if(!tutte_embedding(chart, loops, outer, linear_solvers, uv))
    return false;
  scale_to_area(chart.triangles(), area, uv);
  constexpr double smallest_share = 1e-28;
  return smallest_area(chart.triangles(), uv) > smallest_share * area &&
         count_flips(chart.triangles(), uv) == 0;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_TUTTE_EMBEDDING_H
