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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CANDIDATE_DISKS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CANDIDATE_DISKS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/detection/candidates.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The forbidden region of the filtering (paper, Section 3.1.2): a disk of faces around each candidate
// that is still to be judged. Disks overlap, hence a count per face; releasing a disk never opens
// what another one covers.
class Candidate_disks
{
public:
  explicit Candidate_disks(const Indexed_mesh& mesh)
    : m_mesh(mesh), m_paths(mesh.graph()), m_counts(mesh.number_of_faces(), 0),
      m_disks(mesh.number_of_vertices())
  {}

  // Replaces all disks. Disks that would overlap get half the distance to the nearest center as radius,
  // the others `radius`.
  void set(const std::vector<int>& vertices, double radius)
  {
    std::fill(m_counts.begin(), m_counts.end(), 0);
    for(std::vector<int>& disk : m_disks)
      disk.clear();
    std::vector<char> is_center(m_mesh.number_of_vertices(), 0);
    for(int v : vertices)
      is_center[v] = 1;
    for(int v : vertices)
    {
      double own_radius = radius;
      m_paths.clear();
      m_paths.add_source(v);
      m_paths.run([&](int w)
                  {
                    if(w != v && is_center[w])
                      own_radius = (std::min)(radius, 0.5 * m_paths.distance(w));
                    return !(m_paths.distance(w) >= 2 * radius || (w != v && is_center[w]));
                  });
      m_disks[v] = faces_within(own_radius);
      cover(v);
    }
  }

  void release(int v)
  {
    for(int f : m_disks[v])
      --m_counts[f];
  }

  // Undoes `release()`.
  void cover(int v)
  {
    for(int f : m_disks[v])
      ++m_counts[f];
  }

  bool is_covered(int f) const { return m_counts[f] > 0; }

  // Whether a path of the candidate `v`, which still has its disk, may use each face: all but those in
  // disks of others.
  std::vector<char> faces_open_to(int v) const
  {
    std::vector<char> is_open(m_counts.size());
    for(std::size_t f = 0; f < is_open.size(); ++f)
      is_open[f] = m_counts[f] == 0;
    for(int f : m_disks[v])
      is_open[f] = m_counts[f] == 1;
    return is_open;
  }

private:
  // The faces whose three vertices are less than `radius` from the source of the latest search.
  std::vector<int> faces_within(double radius) const
  {
    const auto is_inside = [&](int v) { return m_paths.distance(v) < radius; };
    std::vector<int> faces;
    for(int v : m_paths.touched())
      if(is_inside(v))
        for(int a = m_mesh.graph().offsets[v]; a < m_mesh.graph().offsets[v + 1]; ++a)
        {
          const int h = m_mesh.halfedge(m_mesh.graph().arcs[a].edge);
          for(int side : {h, m_mesh.opposite(h)})
            if(side >= 0 && std::all_of(m_mesh.triangles()[side / 3].begin(),
                                        m_mesh.triangles()[side / 3].end(), is_inside))
              faces.push_back(side / 3);
        }
    CGAL::internal::Graph_kernel::sort_unique(faces);
    return faces;
  }

  const Indexed_mesh& m_mesh;
  Shortest_paths m_paths;
  std::vector<int> m_counts;               // per face
  std::vector<std::vector<int> > m_disks;  // per candidate vertex
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CANDIDATE_DISKS_H
