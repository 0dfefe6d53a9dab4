// What a map is that was handed out, in exact arithmetic and independently of the library.

#ifndef HELD_MAP_H
#define HELD_MAP_H

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace test {

// Flips and symmetric Dirichlet energies of the UVs that a halfedge map holds.
struct Held_map
{
  int flips = 0; // triangles that are not strictly counterclockwise
  double average = 0, maximum = 0;

  template <typename Mesh, typename HalfedgeUVMap>
  Held_map(const Mesh& mesh, HalfedgeUVMap uv)
  {
    double sum = 0, area = 0;
    for(auto f : faces(mesh))
    {
      std::vector<std::array<Number, 2> > image;
      std::vector<std::array<Number, 3> > surface;
      for(auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      {
        const auto& u = get(uv, h);
        const auto& p = mesh.point(target(h, mesh));
        image.push_back({Number(CGAL::to_double(u.x())), Number(CGAL::to_double(u.y()))});
        surface.push_back({Number(p.x()), Number(p.y()), Number(p.z())});
      }
      flips += !is_counterclockwise(image);
      add(surface, image, sum, area);
    }
    average = sum / area;
  }

private:
  using Number = CGAL::Exact_rational;

  static bool is_counterclockwise(const std::vector<std::array<Number, 2> >& u)
  {
    return (u[1][0] - u[0][0]) * (u[2][1] - u[0][1]) > (u[1][1] - u[0][1]) * (u[2][0] - u[0][0]);
  }

  template <typename Point>
  static Number dot(const Point& origin, const Point& a, const Point& b)
  {
    Number sum = 0;
    for(std::size_t i = 0; i < origin.size(); ++i)
      sum += (a[i] - origin[i]) * (b[i] - origin[i]);
    return sum;
  }

  // The square of twice the area.
  template <typename Point>
  static Number squared_area(const std::vector<Point>& p)
  {
    const Number d = dot(p[0], p[1], p[2]);
    return dot(p[0], p[1], p[1]) * dot(p[0], p[2], p[2]) - d * d;
  }

  // The squared norm of the affine map, from the cotangents of the angles [PP93].
  template <typename From, typename To>
  static double squared_norm(const std::vector<From>& from, const std::vector<To>& to)
  {
    Number sum = 0;
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      sum += dot(from[i], from[j], from[k]) * dot(to[j], to[k], to[k]);
    }
    return CGAL::to_double(Number(sum / squared_area(from)));
  }

  // Faces without area have no energy.
  void add(const std::vector<std::array<Number, 3> >& surface, const std::vector<std::array<Number, 2> >& image,
           double& sum, double& area)
  {
    if(squared_area(surface) == 0)
      return;
    const double energy
      = squared_area(image) == 0 ? HUGE_VAL : squared_norm(surface, image) + squared_norm(image, surface);
    const double face_area = 0.5 * std::sqrt(CGAL::to_double(squared_area(surface)));
    sum += face_area * energy;
    area += face_area;
    maximum = (std::max)(maximum, energy);
  }
};

} // namespace test

#endif // HELD_MAP_H
