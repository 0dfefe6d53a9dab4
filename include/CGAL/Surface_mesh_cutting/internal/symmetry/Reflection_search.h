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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_REFLECTION_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_REFLECTION_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Reflection.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Surface_distance.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <CGAL/number_utils.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Finds planes at which a surface is symmetric, whatever its triangulation. Its axes of inertia, one of which is normal to a plane of
// symmetry, and directions from all sides are tried with a plane through the centroid; the best of them are moved such that the reflected vertices come as close to the surface as possible.
class Reflection_search
{
public:
  struct Matches
  {
    double share; // of the vertices, that lie on the surface then
    std::vector<int> nearest; // per vertex, the one that is there; -1 if none is
  };

  // The reference is kept. Vertices without faces play no part.
  Reflection_search(const Indexed_mesh& mesh, Execution execution)
    : m_mesh(mesh), m_execution(execution), m_distance(mesh), m_diagonal(bounding_box_diagonal(mesh))
  {
    double area = 0;
    m_centroid = Point::Zero();
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      const Triangle& t = mesh.triangles()[f];
      area += mesh.face_area(f);
      m_centroid += mesh.face_area(f) / 3 * (mesh.point(t[0]) + mesh.point(t[1]) + mesh.point(t[2]));
    }
    m_has_area = area > 0 && !m_distance.is_empty();
    if(!m_has_area)
      return;
    m_centroid /= area;
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(!mesh.is_isolated(v))
        m_vertices.push_back(v);
  }

  // As far from the surface, a reflected vertex still belongs to it.
  double tolerance() const
  {
    constexpr double share = 0.004; // of the diagonal: as much as scans and decimation displace, hardly visible
    return share * m_diagonal;
  }

  // The best planes of all directions, or the one with this normal. The first one may be no symmetry.
  std::vector<Reflection> planes() const
  {
    constexpr double hopeful = 0.5; // share of the samples that a symmetry matches at least once it is nearly in place
    constexpr int first_steps = 8;
    std::vector<std::pair<double, Reflection> > order;
    if(m_has_area)
      for(const Reflection& start : best_starts())
      {
        const Reflection moved = refined(start, true, few_samples, first_steps);
        order.emplace_back(-matched_share(moved, samples(few_samples)), moved);
      }
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Reflection> result;
    for(const auto& [share, start] : order)
      if(result.empty() || -share >= hopeful)
      {
        const Reflection moved = refined(start, true, many_samples, last_steps);
        if(std::none_of(result.begin(), result.end(), [&](const Reflection& other) { return is_same(moved, other); }))
          result.push_back(moved);
      }
    return result;
  }

  std::vector<Reflection> planes(const Eigen::Vector3d& normal) const
  {
    if(!m_has_area)
      return {};
    return {refined({normal, normal.dot(m_centroid)}, false, many_samples, last_steps)};
  }

  // Matches the reflected vertices with the surface.
  Matches matches(const Reflection& reflection) const
  {
    Matches result;
    result.nearest.assign(m_mesh.number_of_vertices(), -1);
    std::vector<char> is_matched(m_vertices.size());
    CGAL::internal::Graph_kernel::execute_blocks(m_execution, int(m_vertices.size()), [&](int begin, int end)
    {
      for(int i = begin; i < end; ++i)
      {
        const Point image = reflection(m_mesh.point(m_vertices[i]));
        const Surface_distance::Closest closest = m_distance.closest(image);
        is_matched[i] = (closest.point - image).norm() <= tolerance();
        if((m_mesh.point(closest.vertex) - image).norm() <= tolerance())
          result.nearest[m_vertices[i]] = closest.vertex;
      }
    });
    result.share = double(std::count(is_matched.begin(), is_matched.end(), char(1))) / double(m_vertices.size());
    return result;
  }

private:
  static constexpr std::size_t few_samples = 150, many_samples = 600;
  static constexpr int last_steps = 20;

  double matched_share(const Reflection& reflection, const std::vector<Point>& points) const
  {
    const auto number = std::count_if(points.begin(), points.end(),
                                      [&](const Point& p) { return distance_of(reflection, p) <= tolerance(); });
    return double(number) / double(points.size());
  }

  double distance_of(const Reflection& reflection, const Point& p) const
  {
    const Point image = reflection(p);
    return (m_distance.closest(image).point - image).norm();
  }

  // At most so many vertices, spread over their numbers.
  std::vector<Point> samples(std::size_t number) const
  {
    std::vector<Point> result;
    const std::size_t size = (std::min)(number, m_vertices.size());
    for(std::size_t i = 0; i < size; ++i)
      result.push_back(m_mesh.point(m_vertices[i * m_vertices.size() / size]));
    return result;
  }

  // The eigenvectors of the second moments of the area about the centroid, as columns.
  Eigen::Matrix3d axes_of_inertia() const
  {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      Eigen::Matrix3d corners; // the integral of x x^T over a triangle is A/12 (sum of c c^T + s s^T), with s the sum of corners c
      for(int k = 0; k < 3; ++k)
        corners.col(k) = m_mesh.point(m_mesh.triangles()[f][k]) - m_centroid;
      const Eigen::Vector3d total = corners.rowwise().sum();
      sum += m_mesh.face_area(f) * (corners * corners.transpose() + total * total.transpose());
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors();
  }

  // Axes of inertia, and all directions of a hemisphere, evenly.
  std::vector<Eigen::Vector3d> directions() const
  {
    constexpr int number = 400; // seven degrees apart: from half of that, the plane finds its place
    const Eigen::Matrix3d axes = axes_of_inertia();
    std::vector<Eigen::Vector3d> result = {axes.col(0), axes.col(1), axes.col(2)};
    const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
    for(int i = 0; i < number; ++i)
    {
      const double z = (i + 0.5) / number, r = std::sqrt(1 - z * z);
      result.emplace_back(r * std::cos(i * golden_angle), r * std::sin(i * golden_angle), z);
    }
    return result;
  }

  static double cosine(const Reflection& a, const Reflection& b) { return std::abs(a.normal.dot(b.normal)); }

  bool is_same(const Reflection& a, const Reflection& b) const
  {
    constexpr double near_by = 0.9998; // one degree
    return cosine(a, b) > near_by;
  }

  // Planes that differ, from good to bad.
  std::vector<Reflection> best_starts() const
  {
    constexpr std::size_t number_of_samples = 64, number_of_starts = 12;
    constexpr double apart = 0.985; // ten degrees: more than to the neighbors of a direction
    const std::vector<Point> points = samples(number_of_samples);
    const std::vector<Eigen::Vector3d> normals = directions();
    std::vector<std::pair<double, int> > order(normals.size());
    CGAL::internal::Graph_kernel::execute(m_execution, int(normals.size()), [&](int i)
    {
      const Reflection reflection{normals[i], normals[i].dot(m_centroid)};
      double sum = 0;
      for(const Point& p : points)
        sum += distance_of(reflection, p);
      order[i] = {sum, i};
    });
    std::sort(order.begin(), order.end());
    std::vector<Reflection> result;
    for(const auto& [sum, i] : order)
    {
      const Reflection reflection{normals[i], normals[i].dot(m_centroid)};
      if(result.size() < number_of_starts &&
         std::none_of(result.begin(), result.end(), [&](const Reflection& r) { return cosine(r, reflection) > apart; }))
        result.push_back(reflection);
    }
    return result;
  }

  // Moves the plane, in steps of Gauss and Newton for the distances of the reflected points from the surface. Points far from it
  // count little: they may have no counterpart.
  Reflection refined(Reflection reflection, bool turns, std::size_t number_of_samples, int number_of_steps) const
  {
    const std::vector<Point> points = samples(number_of_samples);
    for(int step = 0; step < number_of_steps; ++step)
      if(!improve(points, turns, reflection))
        break;
    return reflection.oriented();
  }

  // False where the plane stays in place.
  bool improve(const std::vector<Point>& points, bool turns, Reflection& reflection) const
  {
    constexpr double precision = 1e-12;
    std::vector<Eigen::Vector3d> gaps(points.size()); // from the surface to the images
    CGAL::internal::Graph_kernel::execute(m_execution, int(points.size()), [&](int i)
    {
      const Point image = reflection(points[i]);
      gaps[i] = image - m_distance.closest(image).point;
    });
    const double usual = usual_length(gaps);
    const Eigen::Vector3d first = reflection.normal.unitOrthogonal(), second = reflection.normal.cross(first);
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      const double gap = gaps[i].norm();
      if(!(gap > precision * m_diagonal))
        continue;
      const Eigen::Vector3d direction = gaps[i] / gap, p = points[i] - m_centroid;
      const double height = reflection.signed_distance(points[i]);
      const auto by_turn = [&](const Eigen::Vector3d& t)
      { return turns ? -2 * direction.dot(p.dot(t) * reflection.normal + height * t) : 0.; };
      const Eigen::Vector3d derivatives(by_turn(first), by_turn(second), 2 * direction.dot(reflection.normal));
      const double weight = 1 / (1 + (gap / usual) * (gap / usual));
      matrix += weight * derivatives * derivatives.transpose();
      right -= weight * gap * derivatives;
    }
    matrix.diagonal().array() += precision * (matrix.trace() + 1);
    const Eigen::Vector3d change = matrix.ldlt().solve(right);
    if(!change.allFinite())
      return false;
    const double height = reflection.normal.dot(m_centroid) - reflection.offset; // turns about the centroid
    reflection.normal = (reflection.normal + change[0] * first + change[1] * second).normalized();
    reflection.offset = reflection.normal.dot(m_centroid) - height + change[2];
    return change.norm() > precision;
  }

  // Twice the median, below which most lie.
  double usual_length(const std::vector<Eigen::Vector3d>& gaps) const
  {
    std::vector<double> lengths;
    for(const Eigen::Vector3d& gap : gaps)
      lengths.push_back(gap.norm());
    std::nth_element(lengths.begin(), lengths.begin() + std::ptrdiff_t(lengths.size() / 2), lengths.end());
    constexpr double least = 1e-9; // of the diagonal
    return (std::max)(2 * lengths[lengths.size() / 2], least * m_diagonal);
  }

  const Indexed_mesh& m_mesh;
  const Execution m_execution;
  const Surface_distance m_distance;
  const double m_diagonal;
  Point m_centroid;
  bool m_has_area = false;
  std::vector<int> m_vertices;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_REFLECTION_SEARCH_H
