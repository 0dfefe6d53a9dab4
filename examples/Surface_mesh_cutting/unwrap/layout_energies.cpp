#include "layout_energies.h"

#include <CGAL/Surface_mesh_parameterization/distortion_measures.h>

#include <array>
#include <cstddef>

std::vector<double> layout_energies(const Layout& layout)
{
  namespace internal = CGAL::Surface_mesh_parameterization::internal;
  using internal::Symmetric_Dirichlet_energy;
  internal::Corners corners;
  for(std::size_t t = 0; t < layout.triangles.size(); ++t)
  {
    const int first = int(3 * t);
    corners.triangles.push_back({{first, first + 1, first + 2}});
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::array<double, 3>& p = layout.points[std::size_t(layout.triangles[t][k])];
      const std::array<double, 2>& uv = layout.uv_points[std::size_t(layout.uv_triangles[t][k])];
      corners.points.emplace_back(p[0], p[1], p[2]);
      corners.uv.emplace_back(uv[0] / layout.uv_scale, uv[1] / layout.uv_scale);
    }
    const Eigen::Vector2d *const uv = &corners.uv[std::size_t(first)], a = uv[1] - uv[0], b = uv[2] - uv[0];
    if(layout.has_mirrored && a.x() * b.y() < a.y() * b.x()) // as its original
      for(int k = 0; k < 3; ++k)
        corners.uv[std::size_t(first + k)].x() *= -1;
  }
  corners.normalize();
  return internal::face_energies<Symmetric_Dirichlet_energy>(corners.shapes(), corners.triangles, corners.uv);
}
