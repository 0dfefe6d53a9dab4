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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_LAYERS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_LAYERS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/Rigid_motion.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Neck_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Winding_rows.h>

#include <Eigen/Core>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// How much of the border of a disk lies in several layers once a flap has moved. The layers of the flap alone and of the
// rest alone are known from the start.
class Flap_layers
{
  using Vector2d = Eigen::Vector2d;
  using Segments = std::vector<Winding_rows::Segment>;

public:
  // With a default neck, there is no flap. The border is kept as a reference.
  Flap_layers(const Chart_border& border, const Neck& neck)
    : m_border(border), m_neck(neck), m_flap_size(border.distance(neck.from, neck.to)), m_rest(segments(false)),
      m_flap(segments(true))
  {
    constexpr double share = 0.01; // of the length: slightly to the left of the middle
    for(int i = 0; i < border.size(); ++i)
    {
      const Vector2d &p = border.points[i], &q = border.points[border.next(i)], along = q - p;
      m_points.push_back(0.5 * (p + q) + share * Vector2d(-along.y(), along.x()));
      m_layers.push_back((is_in_flap(i) ? m_flap : m_rest)(m_points.back()));
      m_least_overlap += own_overlap(i);
    }
  }

  // The length of the border where the flap covers itself, or the rest does, times the layers but the first; without the seam
  // first..last and its mates. Not its cost: what lies in several layers lacks room, however cheap its border is.
  double least_overlap(int first, int last) const
  {
    double result = m_least_overlap;
    for_seam(first, last, [&](int i) { result -= own_overlap(i); });
    return result;
  }

  // The same, and where these cover each other. If that is not less than `enough`, something between.
  double overlap(const Rigid_motion& motion, int first, int last, double enough) const
  {
    std::vector<char> is_seam(m_border.size(), 0);
    for_seam(first, last, [&](int i) { is_seam[i] = 1; });
    double result = 0;
    for(int i = 0; i < m_border.size() && result < enough; ++i)
      if(!is_seam[i])
      {
        const int layers = m_layers[i] + (is_in_flap(i) ? m_rest(motion(m_points[i])) : m_flap(motion.undone(m_points[i])));
        result += m_border.lengths[i] * (std::max)(0, layers - 1);
      }
    return result;
  }

private:
  bool is_in_flap(int i) const { return m_border.distance(m_neck.from, i) < m_flap_size; }

  double own_overlap(int i) const { return m_border.lengths[i] * (std::max)(0, m_layers[i] - 1); }

  // Calls f for both sides.
  template <typename Function>
  void for_seam(int first, int last, const Function& f) const
  {
    for(int i = first; i >= 0; i = i == last ? -1 : m_border.next(i))
    {
      f(i);
      f(m_border.mates[i]);
    }
  }

  Segments segments(bool of_flap) const
  {
    Segments result;
    for(int i = 0; i < m_border.size(); ++i)
      if(is_in_flap(i) == of_flap)
        result.push_back({m_border.points[i], m_border.points[m_border.next(i)]});
    if(m_flap_size > 0)
    {
      const Vector2d &from = m_border.points[m_neck.from], &to = m_border.points[m_neck.to];
      result.push_back(of_flap ? Winding_rows::Segment{to, from} : Winding_rows::Segment{from, to});
    }
    return result;
  }

  const Chart_border& m_border;
  const Neck m_neck;
  const int m_flap_size; // halfedges of the border
  const Winding_rows m_rest, m_flap;
  std::vector<Vector2d> m_points; // of each halfedge of the border, inside of what it bounds
  std::vector<int> m_layers;      // there, of the flap or of the rest alone
  double m_least_overlap = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_LAYERS_H
