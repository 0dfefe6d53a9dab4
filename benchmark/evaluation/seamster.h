#ifndef EVALUATION_SEAMSTER_H
#define EVALUATION_SEAMSTER_H

#include "Surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

// Seamster [SH02] takes the vertices of high Gaussian curvature, at several scales: the curvature of
// a region of n rings is the angle that the fan from its center to its border lacks.
class Seamster
{
  static constexpr double threshold = EIGEN_PI / 2;
  static constexpr int largest_region = 16; // rings; doubled from one scale to the next

public:
  explicit Seamster(const Surface& surface)
    : m_mesh(surface.mesh), m_ring(surface.mesh.number_of_vertices(), -1)
  {}

  // From fine to coarse; a region that holds a feature of a finer scale needs no other.
  Detection operator()()
  {
    std::vector<char> is_feature(m_mesh.number_of_vertices(), 0);
    for(int rings = 1; rings <= largest_region; rings *= 2)
    {
      std::vector<double> curvatures(m_mesh.number_of_vertices());
      for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
        curvatures[v] = std::abs(curvature(v, rings));
      for(int v : Internal::local_maximizers(m_mesh, curvatures))
        if(curvatures[v] > threshold && !holds_feature(v, rings, is_feature))
          is_feature[v] = 1;
    }
    Detection detection;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(is_feature[v])
        detection.features.push_back(v);
    return detection;
  }

private:
  double curvature(int center, int rings)
  {
    collect(center, rings);
    double angle = 2 * EIGEN_PI;
    for(int v : m_region)
      for(int a = m_mesh.graph().offsets[v]; a < m_mesh.graph().offsets[v + 1]; ++a)
      {
        const auto& arc = m_mesh.graph().arcs[a];
        const int h = m_mesh.halfedge(arc.edge);
        if(v < arc.target && is_inside(h / 3) != is_inside(m_mesh.opposite(h) / 3))
          angle -= angle_at(center, v, arc.target);
      }
    release();
    return angle;
  }

  bool holds_feature(int center, int rings, const std::vector<char>& is_feature)
  {
    collect(center, rings);
    const bool result = std::any_of(m_region.begin(), m_region.end(), [&](int v) { return is_feature[v]; });
    release();
    return result;
  }

  // The vertices within `rings` edges of the center.
  void collect(int center, int rings)
  {
    m_region.assign(1, center);
    m_ring[center] = 0;
    for(std::size_t i = 0; i < m_region.size(); ++i)
      for(int a = m_mesh.graph().offsets[m_region[i]]; a < m_mesh.graph().offsets[m_region[i] + 1]; ++a)
      {
        const int w = m_mesh.graph().arcs[a].target;
        if(m_ring[m_region[i]] < rings && m_ring[w] < 0)
        {
          m_ring[w] = m_ring[m_region[i]] + 1;
          m_region.push_back(w);
        }
      }
  }

  void release()
  {
    for(int v : m_region)
      m_ring[v] = -1;
  }

  bool is_inside(int f) const
  {
    const Internal::Triangle& t = m_mesh.triangles()[f];
    return m_ring[t[0]] >= 0 && m_ring[t[1]] >= 0 && m_ring[t[2]] >= 0;
  }

  double angle_at(int center, int v, int w) const
  {
    const Internal::Point a = m_mesh.point(v) - m_mesh.point(center), b = m_mesh.point(w) - m_mesh.point(center);
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  const Internal::Indexed_mesh& m_mesh;
  std::vector<int> m_ring; // of the region in work; -1 outside
  std::vector<int> m_region;
};

#endif // EVALUATION_SEAMSTER_H
