#ifndef EVALUATION_SPHERE_CLUSTERING_H
#define EVALUATION_SPHERE_CLUSTERING_H

#include "spherical_map.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

// Sphere-based detection [CFH*18]: the distortion of a spherical map tells where the surface sticks
// out. The triangles that are distorted most are taken again and again, and the worst of each
// connected region of them gives a feature.
class Sphere_clustering
{
  static constexpr std::size_t smallest_region = 10; // triangles; smaller ones are noise
  static constexpr double high_distortion = 2;

public:
  explicit Sphere_clustering(const Surface& surface)
    : m_mesh(surface.mesh), m_shapes(surface.shapes), m_map(surface)
  {}

  Detection operator()()
  {
    Detection detection;
    const std::vector<Internal::Point> image = m_map();
    if(image.empty() || !m_map.is_bijective(image))
    {
      detection.failure = image.empty() ? "no spherical map" : "spherical map is not bijective";
      return detection;
    }
    measure(image);
    std::vector<int> faces;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      faces.push_back(f);
    cluster(faces, high_distortion);
    for(int f : m_worst)
      detection.features.push_back(worst_corner(f));
    std::sort(detection.features.begin(), detection.features.end());
    detection.features.erase(std::unique(detection.features.begin(), detection.features.end()),
                             detection.features.end());
    return detection;
  }

private:
  // Half conformal, half area distortion; 1 is none.
  void measure(const std::vector<Internal::Point>& image)
  {
    double area = 0;
    for(const SMP::Rest_shape& s : m_shapes)
      area += s.area;
    const double radius = std::sqrt(area / (4 * EIGEN_PI));
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      const Internal::Triangle& t = m_mesh.triangles()[f];
      const Internal::Point b = radius * (image[t[1]] - image[t[0]]), c = radius * (image[t[2]] - image[t[0]]);
      const double x = b.dot(c) / b.norm(), y = b.cross(c).norm() / b.norm();
      const auto d = SMP::wirtinger_derivatives(m_shapes[f], Eigen::Vector2d(0, 0), Eigen::Vector2d(b.norm(), 0),
                                                Eigen::Vector2d(x, y));
      const double determinant = d.x() - d.y();
      const double conformal = (d.x() + d.y()) / determinant, areal = (determinant + 1 / determinant) / 2;
      m_distortion.push_back((conformal + areal) / 2);
    }
  }

  void cluster(const std::vector<int>& faces, double threshold)
  {
    for(const std::vector<int>& region : connected_regions(faces))
    {
      m_worst.insert(*std::max_element(region.begin(), region.end(), [this](int f, int g)
                                       { return m_distortion[f] < m_distortion[g]; }));
      std::vector<int> high;
      const double limit = threshold > 0 ? threshold : median(region);
      for(int f : region)
        if(m_distortion[f] > limit)
          high.push_back(f);
      if(high.size() > smallest_region)
        cluster(high, 0);
    }
  }

  double median(const std::vector<int>& region) const
  {
    std::vector<double> values;
    for(int f : region)
      values.push_back(m_distortion[f]);
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
  }

  std::vector<std::vector<int> > connected_regions(const std::vector<int>& faces) const
  {
    std::vector<char> is_left(m_mesh.number_of_faces(), 0);
    for(int f : faces)
      is_left[f] = 1;
    std::vector<std::vector<int> > regions;
    for(int f : faces)
    {
      if(!is_left[f])
        continue;
      std::vector<int> region(1, f);
      is_left[f] = 0;
      for(std::size_t i = 0; i < region.size(); ++i)
        for(int k = 0; k < 3; ++k)
        {
          const int g = m_mesh.opposite(3 * region[i] + k) / 3;
          if(is_left[g])
          {
            is_left[g] = 0;
            region.push_back(g);
          }
        }
      if(region.size() > smallest_region)
        regions.push_back(std::move(region));
    }
    return regions;
  }

  int worst_corner(int f) const
  {
    const std::vector<double> values
      = SMP::vertex_averages(m_shapes, m_mesh.triangles(), m_distortion, m_mesh.number_of_vertices());
    const Internal::Triangle& t = m_mesh.triangles()[f];
    return *std::max_element(t.begin(), t.end(), [&](int v, int w) { return values[v] < values[w]; });
  }

  const Internal::Indexed_mesh& m_mesh;
  const std::vector<SMP::Rest_shape>& m_shapes;
  const Spherical_map m_map;
  std::vector<double> m_distortion;
  std::set<int> m_worst;
};

#endif // EVALUATION_SPHERE_CLUSTERING_H
