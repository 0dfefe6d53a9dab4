// Closed surfaces that are symmetric, or nearly so, made by code.

#ifndef SYMMETRIC_FIGURES_H
#define SYMMETRIC_FIGURES_H

#include "soups.h"

#include <CGAL/Random.h>
#include <CGAL/algorithm.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace test {

enum class Diagonals { MIRRORED, PARALLEL, NONE }; // of the quadrangles

// A ball with a body axis z and limbs to the sides, ahead and up, that y -> -y maps to itself.
inline Soup figure(int rings, int half_around, Diagonals diagonals, bool is_symmetric = true)
{
  using Vector = Eigen::Vector3d;
  struct Limb { Vector direction; double length, width; };
  std::vector<Limb> limbs = {{Vector(0.2, 1, 0.3), 1.6, 0.25}, {Vector(0.2, -1, 0.3), 1.6, 0.25},
                             {Vector(0, 0.5, -1), 1.8, 0.25}, {Vector(0, -0.5, -1), 1.8, 0.25},
                             {Vector(0.3, 0, 1), 0.8, 0.35}, {Vector(1, 0, 0), 0.5, 0.2}};
  if(!is_symmetric)
  {
    limbs[0].direction = Vector(-0.6, 0.8, 0.9);
    limbs[3].length = 0.6;
  }
  const auto place = [&](double polar, double around)
  {
    const Vector d(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar));
    double radius = 1;
    for(const Limb& limb : limbs)
    {
      const double angle = std::acos((std::min)(1., d.dot(limb.direction.normalized())));
      radius += limb.length * std::exp(-angle * angle / (limb.width * limb.width));
    }
    return Vector(radius * d);
  };
  const int around = 2 * half_around;
  Soup soup;
  const auto add = [&](double polar, int j)
  {
    // Exactly mirrored: the second half copies the first one.
    const bool is_copied = is_symmetric && j > half_around;
    Vector p = place(polar, CGAL_PI * (is_copied ? around - j : j) / half_around);
    if(is_copied)
      p.y() = -p.y();
    if(is_symmetric && (j == 0 || j == half_around))
      p.y() = 0;
    soup.points.push_back({p.x(), p.y(), p.z()});
  };
  add(0, 0);
  for(int i = 1; i < rings; ++i)
    for(int j = 0; j < around; ++j)
      add(CGAL_PI * i / rings, j);
  add(CGAL_PI, 0);
  const auto vertex = [&](int i, int j) { return std::size_t(1 + (i - 1) * around + j % around); };
  const std::size_t last = soup.points.size() - 1;
  for(int j = 0; j < around; ++j)
  {
    soup.faces.push_back({0, vertex(1, j), vertex(1, j + 1)});
    soup.faces.push_back({last, vertex(rings - 1, j + 1), vertex(rings - 1, j)});
    for(int i = 1; i + 1 < rings; ++i)
    {
      const std::size_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      if(diagonals == Diagonals::NONE)
        soup.faces.push_back({a, b, c, d});
      else if(diagonals == Diagonals::PARALLEL || j < half_around)
      {
        soup.faces.push_back({a, b, c});
        soup.faces.push_back({a, c, d});
      }
      else
      {
        soup.faces.push_back({a, b, d});
        soup.faces.push_back({b, c, d});
      }
    }
  }
  return soup;
}

// Turns, scales and shifts.
inline void move(const Eigen::Matrix3d& rotation, double scale, const Eigen::Vector3d& shift, Soup& soup)
{
  for(std::array<double, 3>& p : soup.points)
  {
    const Eigen::Vector3d q = scale * (rotation * Eigen::Vector3d(p[0], p[1], p[2])) + shift;
    p = {q.x(), q.y(), q.z()};
  }
}

// Numbers vertices and faces in another order, and begins faces with other corners.
inline void renumber(CGAL::Random& random, Soup& soup)
{
  std::vector<std::size_t> order(soup.points.size());
  std::iota(order.begin(), order.end(), 0);
  CGAL::cpp98::random_shuffle(order.begin(), order.end(), random);
  Soup other = soup;
  for(std::size_t v = 0; v < order.size(); ++v)
    other.points[order[v]] = soup.points[v];
  for(auto& face : other.faces)
  {
    for(auto& v : face)
      v = order[v];
    std::rotate(face.begin(), face.begin() + random.get_int(0, int(face.size())), face.end());
  }
  CGAL::cpp98::random_shuffle(other.faces.begin(), other.faces.end(), random);
  soup = std::move(other);
}

inline void add_noise(double size, CGAL::Random& random, Soup& soup)
{
  if(size == 0)
    return;
  for(std::array<double, 3>& p : soup.points)
    for(double& x : p)
      x += random.get_double(-size, size);
}

} // namespace test

#endif // SYMMETRIC_FIGURES_H
