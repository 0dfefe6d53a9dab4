#include "tangents.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <unordered_map>

namespace {

using Vector = Eigen::Vector3d;
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

// Corners with the same key have the same tangent.
using Tangent_key = std::tuple<int, std::array<double, 3>, bool>;

Tangent_key key_of(const Tangent_corner& corner, bool is_clockwise)
{
  return {corner.uv_vertex, {{corner.normal.x(), corner.normal.y(), corner.normal.z()}}, is_clockwise};
}

CGAL::Orientation orientation_of(const Tangent_corner* triangle)
{
  const auto point = [&](std::size_t k) { return Exact::Point_2(triangle[k].uv.x(), triangle[k].uv.y()); };
  return CGAL::orientation(point(0), point(1), point(2));
}

// The derivative of the points by u, times the area.
Vector direction_of_u(const Tangent_corner* triangle)
{
  const double v1 = triangle[1].uv.y() - triangle[0].uv.y(), v2 = triangle[2].uv.y() - triangle[0].uv.y();
  const Vector p1 = triangle[1].point - triangle[0].point, p2 = triangle[2].point - triangle[0].point;
  return v2 * p1 - v1 * p2;
}

// The part of `v` across the normal, of unit length or zero.
Vector across(const Vector& normal, const Vector& v)
{
  const Vector part = v - v.dot(normal) * normal;
  return part.norm() > 1e-12 * v.norm() ? part.stableNormalized() : Vector(Vector::Zero());
}

// The part of the sum that a triangle adds at its corner `k`.
Vector weighted_direction(const Tangent_corner* triangle, std::size_t k, const Vector& direction)
{
  const Vector normal = triangle[k].normal.stableNormalized();
  const auto side = [&](std::size_t other) { return across(normal, triangle[other % 3].point - triangle[k].point); };
  const double cosine = side(k + 1).dot(side(k + 2));
  return std::acos(std::clamp(cosine, -1., 1.)) * across(normal, direction);
}

Tangent tangent_along(const Vector& direction, bool is_clockwise)
{
  return {{float(direction.x()), float(direction.y()), float(direction.z()), is_clockwise ? -1.f : 1.f}};
}

} // namespace

std::vector<Tangent> corner_tangents(const std::vector<Tangent_corner>& corners)
{
  std::unordered_map<Tangent_key, Vector, boost::hash<Tangent_key> > sums;
  std::vector<CGAL::Orientation> orientations; // per triangle
  for(std::size_t first = 0; first + 2 < corners.size(); first += 3)
  {
    const Tangent_corner* const triangle = &corners[first];
    const CGAL::Orientation orientation = orientation_of(triangle);
    orientations.push_back(orientation);
    const Vector direction = int(orientation) * direction_of_u(triangle);
    if(orientation != CGAL::COLLINEAR)
      for(std::size_t k = 0; k < 3; ++k)
        sums.try_emplace(key_of(triangle[k], orientation == CGAL::CLOCKWISE), Vector::Zero()).first->second
          += weighted_direction(triangle, k, direction);
  }

  std::vector<Tangent> tangents;
  tangents.reserve(corners.size());
  for(std::size_t c = 0; c < corners.size(); ++c)
  {
    const bool is_clockwise = orientations[c / 3] == CGAL::CLOCKWISE;
    const auto sum = sums.find(key_of(corners[c], is_clockwise));
    const Vector direction = sum == sums.end() ? Vector(Vector::Zero()) : Vector(sum->second.stableNormalized());
    tangents.push_back(direction.norm() > 0.5 ? tangent_along(direction, is_clockwise) : any_tangent(corners[c].normal));
  }
  return tangents;
}

Tangent any_tangent(const Vector& normal)
{
  return tangent_along(normal.norm() > 0 ? Vector(normal.stableNormalized().unitOrthogonal()) : Vector(Vector::UnitX()), false);
}
