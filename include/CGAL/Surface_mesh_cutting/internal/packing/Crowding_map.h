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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CROWDING_MAP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CROWDING_MAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_random.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Rigid_chart.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// How well a chart would lie somewhere.
struct Rated_place
{
  double energy;
  Rigid_motion motion;
};

// Finds places for a chart among the others. A grid holds how deep each of its cells is in other charts, so that trying a
// place costs one look per point of the chart, however many charts there are. Depths are rough: places have to be rated
// again.
class Crowding_map
{
  static constexpr int size = 128; // cells along the side

public:
  static constexpr int number_of_cells = size * size;

  explicit Crowding_map(const std::vector<Rigid_chart>& charts)
    : m_charts(charts), m_depths(charts.size()), m_points(charts.size()), m_energies(number_of_cells)
  {
    for(std::size_t i = 0; i < charts.size(); ++i)
      m_points[i] = scattered_points(charts[i]);
  }

  // All charts in a square of `side`, where points closer to a chart than `reach` are too close.
  void put_all(const std::vector<Rigid_motion>& motions, double side, double reach)
  {
    m_cell = side / size;
    m_reach = reach;
    for(std::size_t i = 0; i < m_charts.size(); ++i)
      put(int(i), motions[i]);
  }

  void put(int i, const Rigid_motion& at)
  {
    m_depths[i].clear();
    const double radius = m_charts[i].radius + m_reach;
    const auto [left, right] = cells_around(at.translation().x(), radius);
    const auto [low, high] = cells_around(at.translation().y(), radius);
    const Eigen::Vector2d to_next = at.turned_back(Eigen::Vector2d(m_cell, 0));
    for(int y = low; y <= high; ++y)
    {
      Eigen::Vector2d center = at.turned_back(m_cell * Eigen::Vector2d(left + 0.5, y + 0.5) - at.translation());
      for(int x = left; x <= right; ++x, center += to_next)
      {
        const double depth = m_reach - m_charts[i].field.rough_distance(center);
        if(depth > 0)
          m_depths[i].push_back({y * size + x, float(depth * depth)});
      }
    }
  }

  // Prepares the search for places for chart `i`; `weight(j)` is that of a contact with chart `j`.
  template <typename Weight>
  void look_from(int i, Weight weight)
  {
    std::fill(m_energies.begin(), m_energies.end(), 0.f);
    for(int j = 0; j < int(m_depths.size()); ++j)
      if(j != i)
      {
        const float factor = float(weight(j));
        for(const Cell_depth& depth : m_depths[j])
          m_energies[depth.cell] += factor * depth.squared;
      }
  }

  // Tries chart `i`, turned by `angle`, at some random places in the square. The best of these and of `best`, which is
  // sorted, replace the places in `best`, up to a number.
  void try_places(int i, double angle, Packing_random& random, std::vector<Rated_place>& best)
  {
    constexpr int number_of_places = 60;
    constexpr std::size_t number_of_best = 2;
    if(!turn(i, angle))
      return;
    for(int k = 0; k < number_of_places; ++k)
    {
      const int x = m_first.x + random.below(m_last.x - m_first.x + 1), y = m_first.y + random.below(m_last.y - m_first.y + 1);
      const bool is_full = best.size() == number_of_best;
      const float limit = is_full ? float(best.back().energy) : std::numeric_limits<float>::infinity();
      const float energy = energy_at(y * size + x, limit);
      if(energy >= limit)
        continue;
      if(is_full)
        best.pop_back();
      const Rated_place place = {energy, Rigid_motion(angle, m_cell * Eigen::Vector2d(x, y))};
      best.insert(std::upper_bound(best.begin(), best.end(), place,
                                   [](const Rated_place& a, const Rated_place& b) { return a.energy < b.energy; }), place);
    }
  }

private:
  struct Column_and_row { int x, y; };
  struct Cell_depth { int cell; float squared; };

  // Of the outline and of a lattice inside, in an order that tells soon where a place is bad.
  static std::vector<Eigen::Vector2d> scattered_points(const Rigid_chart& chart)
  {
    constexpr int lattice = 4; // points along the radius
    std::vector<Eigen::Vector2d> points = chart.samples;
    for(int y = -lattice; y <= lattice; ++y)
      for(int x = -lattice; x <= lattice; ++x)
        if(const Eigen::Vector2d p = chart.radius / lattice * Eigen::Vector2d(x, y); chart.field(p).distance < 0)
          points.push_back(p);
    Packing_random random(0);
    for(int i = int(points.size()) - 1; i > 0; --i)
      std::swap(points[i], points[random.below(i + 1)]);
    return points;
  }

  std::pair<int, int> cells_around(double center, double radius) const
  {
    return {int((std::max)(0., (center - radius) / m_cell)), int((std::min)(size - 1., (center + radius) / m_cell))};
  }

  // Where the points of the turned chart lie relative to it; whether there is room for them.
  bool turn(int i, double angle)
  {
    const Rigid_motion turned(angle, Eigen::Vector2d::Zero());
    Column_and_row low = {0, 0}, high = {0, 0};
    m_offsets.clear();
    for(const Eigen::Vector2d& point : m_points[i])
    {
      const Eigen::Vector2d p = turned(point) / m_cell;
      const Column_and_row cell = {int(std::floor(p.x())), int(std::floor(p.y()))};
      low = {(std::min)(low.x, cell.x), (std::min)(low.y, cell.y)};
      high = {(std::max)(high.x, cell.x), (std::max)(high.y, cell.y)};
      m_offsets.push_back(cell.y * size + cell.x);
    }
    m_first = {-low.x, -low.y};
    m_last = {size - 1 - high.x, size - 1 - high.y};
    return m_first.x <= m_last.x && m_first.y <= m_last.y;
  }

  float energy_at(int place, float limit) const
  {
    float energy = 0;
    for(const int offset : m_offsets)
    {
      energy += m_energies[place + offset];
      if(energy >= limit)
        break;
    }
    return energy;
  }

  const std::vector<Rigid_chart>& m_charts;
  double m_cell = 0, m_reach = 0;
  std::vector<std::vector<Cell_depth> > m_depths;       // of the cells that charts cover
  std::vector<std::vector<Eigen::Vector2d> > m_points;  // of charts
  std::vector<float> m_energies;                        // of points in cells, for the chart that looks for a place
  std::vector<int> m_offsets;                           // of the cells of its points
  Column_and_row m_first, m_last;                       // where its origin can be
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CROWDING_MAP_H
