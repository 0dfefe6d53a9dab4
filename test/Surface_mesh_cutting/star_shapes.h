// Random closed surfaces as the algorithms see them, and distances on them by brute force.

#ifndef STAR_SHAPES_H
#define STAR_SHAPES_H

#include "surface_meshes.h"

#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>

#include <CGAL/Random.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace test {

using CGAL::Surface_mesh_cutting::internal::Indexed_mesh;

inline Indexed_mesh random_star_shape(int n, CGAL::Random& random)
{
  Soup soup = sphere(2 * n, n);
  const double a = random.get_double(1, 4), b = random.get_double(1, 4), c = random.get_double(0.2, 0.6);
  for(std::array<double, 3>& p : soup.points)
  {
    const double polar = CGAL_PI * (p[2] + 1) / (n + 2), around = std::atan2(p[1], p[0]);
    const double radius = 1 + c * std::sin(a * polar) * std::cos(std::round(b) * around);
    p = {radius * std::sin(polar) * std::cos(around), radius * std::sin(polar) * std::sin(around),
         2 * radius * std::cos(polar)};
  }
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  const auto vpm = get(CGAL::vertex_point, mesh);
  return CGAL::Surface_mesh_cutting::internal::Mesh_adapter<Surface_mesh, decltype(vpm)>(mesh, vpm).mesh();
}

// Over the edges with `is_allowed` (empty: all).
inline std::vector<double> distances_by_relaxation(const Indexed_mesh& mesh, int source,
                                                   const std::vector<char>& is_allowed = {})
{
  std::vector<double> distances(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  distances[source] = 0;
  for(bool has_changed = true; has_changed;)
  {
    has_changed = false;
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const double d = distances[mesh.source(h)] + mesh.length(mesh.edge(h));
      if((is_allowed.empty() || is_allowed[mesh.edge(h)]) && d < distances[mesh.target(h)])
      {
        distances[mesh.target(h)] = d;
        has_changed = true;
      }
    }
  }
  return distances;
}

} // namespace test

#endif // STAR_SHAPES_H
