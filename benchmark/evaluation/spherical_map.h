#ifndef EVALUATION_SPHERICAL_MAP_H
#define EVALUATION_SPHERICAL_MAP_H

#include "mean_value_map.h"
#include "Surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

// Maps to the unit sphere that are about conformal: a vertex and the triangles at it are left out, the
// rest is mapped to a disk and projected to the sphere, where the vertex becomes the pole.
class Spherical_map
{
public:
  explicit Spherical_map(const Surface& surface) : m_mesh(surface.mesh), m_shapes(surface.shapes) {}

  // The images of the vertices; empty if there is no map of the plane.
  std::vector<Internal::Point> operator()() const
  {
    const int pole = largest_star();
    std::vector<Eigen::Vector2d> uv;
    std::vector<int> vertices;
    if(!planar_map(pole, uv, vertices))
      return {};
    center(uv, vertices);
    std::vector<Internal::Point> image(m_mesh.number_of_vertices(), Internal::Point(0, 0, 1));
    for(std::size_t i = 0; i < uv.size(); ++i)
    {
      const double r = uv[i].squaredNorm();
      // Mirrored, so that triangles stay counterclockwise as seen from outside.
      image[vertices[i]] = Internal::Point(uv[i].x(), -uv[i].y(), (r - 1) / 2) * (2 / (1 + r));
    }
    balance(image);
    smooth_flips(image);
    return image;
  }

  // Without flips, which is decided exactly, the map covers the sphere a whole number of times.
  bool is_bijective(const std::vector<Internal::Point>& image) const
  {
    if(!flips(image).empty())
      return false;
    double solid_angle = 0;
    for(const Internal::Triangle& t : m_mesh.triangles())
    {
      const Internal::Point &a = image[t[0]], &b = image[t[1]], &c = image[t[2]];
      solid_angle += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    return std::abs(solid_angle - 4 * EIGEN_PI) < EIGEN_PI;
  }

private:
  std::vector<int> flips(const std::vector<Internal::Point>& image) const
  {
    typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;
    const auto point = [&](int v) { return Point_3(image[v].x(), image[v].y(), image[v].z()); };
    std::vector<int> result;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      const Internal::Triangle& t = m_mesh.triangles()[f];
      if(CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), Point_3(0, 0, 0)) != CGAL::NEGATIVE)
        result.push_back(f);
    }
    return result;
  }

  // Moves the corners of flipped triangles, and all next to them, between their neighbors.
  void smooth_flips(std::vector<Internal::Point>& image) const
  {
    constexpr int maximum_number_of_rounds = 200;
    const auto& offsets = m_mesh.graph().offsets;
    const auto& arcs = m_mesh.graph().arcs;
    for(int round = 0; round < maximum_number_of_rounds; ++round)
    {
      const std::vector<int> flipped = flips(image);
      if(flipped.empty())
        return;
      std::vector<int> vertices;
      for(int f : flipped)
        for(int v : m_mesh.triangles()[f])
          for(int a = offsets[v]; a < offsets[v + 1]; ++a)
            vertices.insert(vertices.end(), {v, arcs[a].target});
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      for(int v : vertices)
      {
        Internal::Point sum = Internal::Point::Zero();
        for(int a = offsets[v]; a < offsets[v + 1]; ++a)
          sum += image[arcs[a].target];
        image[v] = sum.normalized();
      }
    }
  }

  // Largest triangles leave most room around the pole.
  int largest_star() const
  {
    std::vector<double> areas(m_mesh.number_of_vertices(), 0);
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      for(int v : m_mesh.triangles()[f])
        areas[v] += m_shapes[f].area;
    return int(std::max_element(areas.begin(), areas.end()) - areas.begin());
  }

  bool planar_map(int pole, std::vector<Eigen::Vector2d>& uv, std::vector<int>& vertices) const
  {
    std::vector<int> faces, new_vertex(m_mesh.number_of_vertices(), -1), new_halfedge(m_mesh.number_of_halfedges(), -1);
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      const Internal::Triangle& t = m_mesh.triangles()[f];
      if(std::find(t.begin(), t.end(), pole) == t.end())
        faces.push_back(f);
    }
    const Internal::Indexed_component rest = Internal::make_component(m_mesh, faces, new_vertex, new_halfedge);
    vertices = rest.vertices;
    return mean_value_map(rest.mesh, Internal::make_chart(rest.mesh, Internal::Cut(rest.mesh.number_of_edges(), 0)), uv);
  }

  std::vector<double> vertex_areas() const
  {
    std::vector<double> areas(m_mesh.number_of_vertices(), 0);
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      for(int v : m_mesh.triangles()[f])
        areas[v] += m_shapes[f].area / 3;
    return areas;
  }

  // Moves the weighted median to the origin, and half of the area into the unit circle.
  void center(std::vector<Eigen::Vector2d>& uv, const std::vector<int>& vertices) const
  {
    const std::vector<double> areas = vertex_areas();
    const auto median = [&](auto value)
    {
      std::vector<std::pair<double, double> > values;
      double half = 0;
      for(std::size_t i = 0; i < uv.size(); ++i)
      {
        values.emplace_back(value(uv[i]), areas[vertices[i]]);
        half += 0.5 * areas[vertices[i]];
      }
      std::sort(values.begin(), values.end());
      std::size_t i = 0;
      for(; i + 1 < values.size() && (half -= values[i].second) > 0;)
        ++i;
      return values[i].first;
    };
    const Eigen::Vector2d middle(median([](const auto& p) { return p.x(); }),
                                 median([](const auto& p) { return p.y(); }));
    const double radius = median([&](const auto& p) { return (p - middle).norm(); });
    for(Eigen::Vector2d& p : uv)
      p = (p - middle) / radius;
  }

  // Moebius transformations that bring the center of mass to that of the sphere.
  void balance(std::vector<Internal::Point>& image) const
  {
    constexpr int maximum_number_of_steps = 100;
    const std::vector<double> areas = vertex_areas();
    double total = 0;
    for(double a : areas)
      total += a;
    for(int step = 0; step < maximum_number_of_steps; ++step)
    {
      Internal::Point mass = Internal::Point::Zero();
      for(std::size_t v = 0; v < image.size(); ++v)
        mass += areas[v] / total * image[v];
      if(mass.norm() < 1e-6)
        return;
      const Internal::Point c = -0.5 * mass;
      for(Internal::Point& p : image)
        p = ((1 - c.squaredNorm()) * (p + c) / (p + c).squaredNorm() + c).normalized();
    }
  }

  const Internal::Indexed_mesh& m_mesh;
  const std::vector<SMP::Rest_shape>& m_shapes;
};

#endif // EVALUATION_SPHERICAL_MAP_H
