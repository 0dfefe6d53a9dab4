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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_TRIANGLE_GROUPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_TRIANGLE_GROUPS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <algorithm>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Groups of triangles without common vertices, so that threads add to the vertices without meeting; the triangles
// between groups come after them. A group is what lies within a range of positions: in a nested dissection, that is
// most. The same groups for any number of threads.
class Triangle_groups
{
public:
  Triangle_groups() = default;

  // `positions`: per vertex, below `number_of_positions`, or negative where nothing is added.
  Triangle_groups(const std::vector<Triangle>& triangles, const std::vector<int>& positions, int number_of_positions)
  {
    constexpr int most_groups = 32, smallest_group = 2048; // positions: of smaller ones, too many are at the edge
    const int size = (std::max)(smallest_group, number_of_positions / most_groups + 1);
    const int n = (number_of_positions + size - 1) / size;
    const auto group = [&](const Triangle& t)
    {
      int result = -1;
      for(int v : t)
        if(positions[v] >= 0)
        {
          const int g = positions[v] / size;
          if(result >= 0 && result != g)
            return n;
          result = g;
        }
      return result < 0 ? n : result;
    };
    m_groups = Buckets<int>(n + 1, [&](const auto& visit)
    {
      for(int f = 0; f < int(triangles.size()); ++f)
        visit(group(triangles[f]), f);
    });
  }

  // Calls `add(f, terms(f))` for each triangle and adds up what it returns. `terms` only looks, and may be called for
  // several triangles at the same time whatever their vertices are.
  template <typename Terms, typename Add>
  double sum(Execution execution, const Terms& terms, const Add& add) const
  {
    const int n = m_groups.number_of_buckets() - 1;
    std::vector<double> sums(n, 0);
    execute(execution, n, [&](int g)
    {
      for(int f : m_groups[g])
        sums[g] += add(f, terms(f));
    });
    double total = 0;
    for(double s : sums)
      total += s;
    return total + sum_between(execution, terms, add);
  }

private:
  // The triangles between groups share vertices: their terms are computed in parallel, for some triangles at a time, and
  // added by one thread.
  template <typename Terms, typename Add>
  double sum_between(Execution execution, const Terms& terms, const Add& add) const
  {
    constexpr int number_of_parts = 16, part_size = 128; // triangles; what is worked out for all parts stays in the cache
    const auto triangles = m_groups[m_groups.number_of_buckets() - 1];
    double sum = 0;
    if(execution == Execution::SEQUENTIAL || int(triangles.size()) < part_size)
    {
      for(int f : triangles)
        sum += add(f, terms(f));
      return sum;
    }
    const int* const first = triangles.begin();
    const int number = int(triangles.size());
    constexpr int most = number_of_parts * part_size;
    std::vector<decltype(terms(0))> worked_out((std::min)(most, number));
    for(int begin = 0; begin < number; begin += most)
    {
      const int size = (std::min)(most, number - begin);
      execute(execution, (size + part_size - 1) / part_size, [&](int part)
      {
        for(int i = part * part_size; i < (std::min)(size, (part + 1) * part_size); ++i)
          worked_out[i] = terms(first[begin + i]);
      });
      for(int i = 0; i < size; ++i)
        sum += add(first[begin + i], worked_out[i]);
    }
    return sum;
  }

  Buckets<int> m_groups; // of triangles; the last one holds those between the others
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_TRIANGLE_GROUPS_H
