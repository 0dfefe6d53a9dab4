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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CONGRUENT_COMPONENTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CONGRUENT_COMPONENTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Halfedge_arrays.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Finds components that a motion takes to others, or a motion and a reflection: vertex by vertex up to a tolerance, with
// the same faces.
//
// A halfedge of one component and its image decide where all others go. The longest one of a component is compared with
// those of about its length in the other one. Each attempt ends at the first difference, so that it takes long only where
// a component nearly has symmetries.
class Congruent_components
{
public:
  // `tolerance`: of the diagonal of a component's bounding box. `reflection`: the image of each halfedge by a reflection that is
  // tried first, backward; -1 without one, and empty if there is none.
  Congruent_components(const Halfedge_arrays& mesh, double tolerance, const std::vector<int>& reflection = {})
    : m_mesh(mesh), m_image(mesh.next.size(), -1), m_corner(m_image), m_pair(m_image), m_vertex_image(mesh.points.size(), -1)
  {
    find_components();
    m_is_mirrored.assign(m_components.size(), 0);
    std::map<std::array<std::size_t, 3>, std::vector<int> > originals; // with the same numbers of elements
    for(int i = 0; i < number(); ++i)
    {
      const Component& component = m_components[i];
      std::vector<int>& candidates = originals[{component.halfedges.size(), component.vertices.size(), component.borders}];
      const auto original = std::find_if(candidates.begin(), candidates.end(),
                                         [&](int j) { return match(j, i, tolerance, reflection); });
      m_original.push_back(original == candidates.end() ? i : *original);
      if(original == candidates.end())
        candidates.push_back(i);
    }
  }

  // In the order of their first halfedges.
  int number() const { return int(m_components.size()); }
  const std::vector<int>& halfedges(int i) const { return m_components[i].halfedges; }

  // The first component to which one is congruent: itself, or one that is its own original.
  int original(int i) const { return m_original[i]; }

  bool is_mirrored(int i) const { return m_is_mirrored[i]; }

  // The halfedge of the original on the same edge, and the one that leads to the same corner; itself in an original.
  int halfedge_of_original(int h) const { return m_image[h] < 0 ? h : m_image[h]; }
  int corner_of_original(int h) const { return m_image[h] < 0 ? h : m_corner[h]; }

private:
  struct Component
  {
    std::vector<int> halfedges, vertices;
    std::size_t borders = 0; // halfedges without an opposite one
    double size = 0;         // diagonal of the bounding box
    double length = 0;       // of all halfedges
    int anchor = -1;         // the longest halfedge
  };

  using Pair = std::pair<int, int>; // of a copy, and of its original

  void find_components()
  {
    std::vector<char> is_met(m_mesh.next.size(), 0);
    std::vector<int> last_component(m_mesh.points.size(), -1); // that has the vertex: several have it where they are divided
    for(int first = 0; first < m_mesh.number_of_halfedges(); ++first)
    {
      if(is_met[first] || m_mesh.next[first] < 0)
        continue;
      Component component;
      std::vector<int> stack(1, first);
      is_met[first] = 1;
      while(!stack.empty())
      {
        const int h = stack.back();
        stack.pop_back();
        component.halfedges.push_back(h);
        component.borders += m_mesh.opposite[h] < 0;
        if(std::exchange(last_component[m_mesh.target[h]], number()) != number())
          component.vertices.push_back(m_mesh.target[h]);
        for(const int g : {m_mesh.next[h], m_mesh.opposite[h]})
          if(g >= 0 && !std::exchange(is_met[g], char(1)))
            stack.push_back(g);
      }
      std::sort(component.halfedges.begin(), component.halfedges.end());
      measure(component);
      m_components.push_back(std::move(component));
    }
  }

  void measure(Component& component) const
  {
    Eigen::AlignedBox3d box;
    for(const int v : component.vertices)
      box.extend(m_mesh.points[v]);
    component.size = box.diagonal().norm();
    for(const int h : component.halfedges)
      component.length += m_mesh.length(h);
    component.anchor = *std::max_element(component.halfedges.begin(), component.halfedges.end(),
                                         [&](int g, int h) { return m_mesh.length(g) < m_mesh.length(h); });
  }

  // Whether the second component is a copy of the first one; then its halfedges get their images there.
  bool match(int original, int copy, double tolerance, const std::vector<int>& reflection)
  {
    const Component& first = m_components[original];
    const Component& second = m_components[copy];
    const double difference = tolerance * first.size;
    if(std::abs(first.length - second.length) > 2 * difference * double(first.halfedges.size()))
      return false;
    constexpr std::size_t most_visits = 100; // of each halfedge on average
    std::size_t visits = 0;
    if(!reflection.empty() && std::binary_search(first.halfedges.begin(), first.halfedges.end(), reflection[second.anchor])
       && match_by(copy, reflection[second.anchor], true, difference, visits))
      return true;
    for(const bool is_mirrored : {false, true})
      for(const int h : first.halfedges)
      {
        if(match_by(copy, h, is_mirrored, difference, visits))
          return true;
        if(visits > most_visits * first.halfedges.size())
          return false;
      }
    return false;
  }

  // The same with a given image of the copy's anchor.
  bool match_by(int copy, int image_of_anchor, bool is_mirrored, double difference, std::size_t& visits)
  {
    const Component& component = m_components[copy];
    std::vector<Pair> pairs;
    const bool is_found = extend(component.anchor, image_of_anchor, is_mirrored, 2 * difference, pairs)
                          && is_motion(pairs, component, is_mirrored, difference);
    visits += pairs.size() + 1;
    if(is_found)
    {
      for(const auto& [g, image] : pairs) // mirrored, the target of one corresponds to the source of the other one
      {
        m_image[g] = image;
        m_corner[g] = is_mirrored ? m_mesh.previous[image] : image;
      }
      m_is_mirrored[copy] = is_mirrored;
    }
    forget(pairs);
    return is_found;
  }

  // Follows both components from two halfedges on, as long as lengths and the borders agree. A reflection turns halfedges
  // around.
  bool extend(int anchor, int image, bool is_mirrored, double difference, std::vector<Pair>& pairs)
  {
    if(!put(anchor, image, is_mirrored, difference, pairs))
      return false;
    for(std::size_t i = 0; i < pairs.size(); ++i)
    {
      const auto [g, h] = pairs[i];
      const int opposite = m_mesh.opposite[g], other = m_mesh.opposite[h];
      if((opposite < 0) != (other < 0) || !put(m_mesh.next[g], is_mirrored ? m_mesh.previous[h] : m_mesh.next[h],
                                               is_mirrored, difference, pairs))
        return false;
      if(opposite >= 0 && !put(opposite, other, is_mirrored, difference, pairs))
        return false;
    }
    return true;
  }

  bool put(int g, int h, bool is_mirrored, double difference, std::vector<Pair>& pairs)
  {
    if(m_pair[g] >= 0)
      return m_pair[g] == h;
    if(!(std::abs(m_mesh.length(g) - m_mesh.length(h)) <= difference))
      return false;
    const int vertex = m_mesh.target[g], image = is_mirrored ? m_mesh.source(h) : m_mesh.target[h];
    if(m_vertex_image[vertex] >= 0 && m_vertex_image[vertex] != image)
      return false;
    m_vertex_image[vertex] = image;
    m_pair[g] = h;
    pairs.emplace_back(g, h);
    return true;
  }

  void forget(const std::vector<Pair>& pairs)
  {
    for(const auto& [g, h] : pairs)
    {
      m_pair[g] = -1;
      m_vertex_image[m_mesh.target[g]] = -1;
    }
  }

  // Whether one motion takes each vertex near its image: the best one by least squares does.
  bool is_motion(const std::vector<Pair>& pairs, const Component& component, bool is_mirrored, double difference) const
  {
    if(pairs.size() != component.halfedges.size())
      return false;
    const Eigen::Index number = Eigen::Index(component.vertices.size());
    Eigen::Matrix3Xd from(3, number), to(3, number);
    for(Eigen::Index i = 0; i < number; ++i)
    {
      const int v = component.vertices[std::size_t(i)];
      from.col(i) = m_mesh.points[v] - m_mesh.points[component.vertices.front()];
      to.col(i) = m_mesh.points[m_vertex_image[v]] - m_mesh.points[m_vertex_image[component.vertices.front()]];
    }
    if(is_mirrored)
      from.row(0) *= -1;
    const Eigen::Matrix4d motion = Eigen::umeyama(from, to, false);
    const Eigen::Matrix3Xd moved = (motion.topLeftCorner<3, 3>() * from).colwise() + Eigen::Vector3d(motion.topRightCorner<3, 1>());
    return (moved - to).colwise().norm().maxCoeff() <= difference;
  }

  const Halfedge_arrays& m_mesh;
  std::vector<Component> m_components;
  std::vector<int> m_original;
  std::vector<char> m_is_mirrored;
  std::vector<int> m_image, m_corner;     // of halfedges of copies: on the same edge, and to the same corner
  std::vector<int> m_pair, m_vertex_image; // of halfedges and vertices, in the present attempt
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CONGRUENT_COMPONENTS_H
