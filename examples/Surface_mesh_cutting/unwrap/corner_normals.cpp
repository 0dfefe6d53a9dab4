#include "corner_normals.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace {

using Vector = Eigen::Vector3d;

Vector to_vector(const std::array<double, 3>& p) { return Vector(p[0], p[1], p[2]); }

// False for a vector without a direction.
bool normalize(Vector& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  if(!v.allFinite() || !(largest > 0))
    return false;
  v = (v / largest).normalized();
  return true;
}

// Per vertex of the surface.
std::vector<Vector> vertex_normals(const Layout& layout)
{
  const auto last = std::max_element(layout.corner_vertices.begin(), layout.corner_vertices.end());
  std::vector<Vector> normals(last == layout.corner_vertices.end() ? 0 : std::size_t(*last) + 1, Vector::Zero());
  for(std::size_t t = 0; t < layout.triangles.size(); ++t)
  {
    const auto point = [&](std::size_t k) { return to_vector(layout.points[std::size_t(layout.triangles[t][k])]); };
    const Vector area = (point(1) - point(0)).cross(point(2) - point(0));
    for(const int corner : layout.triangle_corners[t])
      normals[std::size_t(layout.corner_vertices[std::size_t(corner)])] += area;
  }
  for(Vector& normal : normals)
    if(!normalize(normal))
      normal = Vector::UnitZ(); // any: there is no side
  return normals;
}

} // namespace

std::vector<Unit_normal> corner_normals(const Layout& layout)
{
  const std::vector<Vector> computed = vertex_normals(layout);
  std::vector<Unit_normal> result;
  result.reserve(layout.corners.size());
  for(std::size_t corner = 0; corner < layout.corners.size(); ++corner)
  {
    const int given = layout.corner_normals.empty() ? -1 : layout.corner_normals[corner];
    Vector normal = given < 0 ? Vector::Zero() : to_vector(layout.normals[std::size_t(given)]);
    if(!normalize(normal))
      normal = computed[std::size_t(layout.corner_vertices[corner])];
    result.push_back({{float(normal.x()), float(normal.y()), float(normal.z())}});
  }
  return result;
}
