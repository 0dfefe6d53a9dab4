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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_ENERGY_STATISTICS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_ENERGY_STATISTICS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Energies of the faces of a chart; the average is over the area.
struct Chart_energy
{
  double average = 0, maximum = 0;
};

// Pairs of a share of the area, and the least energy that the faces of so much area do not exceed. O(n log n).
inline std::vector<std::array<double, 2> > energy_quantiles(const std::vector<double>& energies, const std::vector<double>& areas)
{
  std::vector<int> faces;
  double all = 0;
  for(std::size_t f = 0; f < energies.size(); ++f)
    if(areas[f] > 0)
    {
      faces.push_back(int(f));
      all += areas[f];
    }
  std::stable_sort(faces.begin(), faces.end(), [&](int f, int g) { return energies[f] < energies[g]; });
  std::vector<std::array<double, 2> > quantiles;
  double area = 0;
  std::size_t next = 0;
  for(const double share : {0.5, 0.9, 0.99, 0.999, 1.})
  {
    while(next < faces.size() && (area < share * all || share == 1))
      area += areas[faces[next++]];
    if(next > 0)
      quantiles.push_back({share, energies[faces[next - 1]]});
  }
  return quantiles;
}

// `chart_of_face` is less than the number of charts, each of which has a face. O(n).
inline std::vector<Chart_energy> chart_energies(const std::vector<double>& energies, const std::vector<double>& areas,
                                                const std::vector<int>& chart_of_face)
{
  std::vector<Chart_energy> charts;
  std::vector<double> sums;
  for(std::size_t f = 0; f < energies.size(); ++f)
  {
    const std::size_t c = std::size_t(chart_of_face[f]);
    if(c >= charts.size())
    {
      charts.resize(c + 1);
      sums.resize(c + 1, 0);
    }
    if(!(areas[f] > 0))
      continue;
    charts[c].average += areas[f] * energies[f];
    charts[c].maximum = (std::max)(charts[c].maximum, energies[f]);
    sums[c] += areas[f];
  }
  for(std::size_t c = 0; c < charts.size(); ++c)
    charts[c].average = sums[c] > 0 ? charts[c].average / sums[c] : 0;
  return charts;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_ENERGY_STATISTICS_H
