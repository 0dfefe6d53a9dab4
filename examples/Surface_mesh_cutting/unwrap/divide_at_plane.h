// The halves of symmetric parts.

#ifndef UNWRAP_DIVIDE_AT_PLANE_H
#define UNWRAP_DIVIDE_AT_PLANE_H

#include "Mesh.h"

#include <CGAL/Surface_mesh_cutting/Reflection_plane.h>
#include <CGAL/Surface_mesh_cutting/Symmetry.h>

#include <optional>
#include <vector>

struct Division
{
  CGAL::Surface_mesh_cutting::Reflection_plane plane;
  std::vector<char> is_divided; // per edge
  std::vector<int> reflection;  // of each halfedge, its mirror image, backward; -1 without one
};

// The first plane of symmetry that runs along edges, if there is one.
std::optional<Division> divide_at_plane(const Mesh& mesh, CGAL::Surface_mesh_cutting::Symmetry choice);

#endif // UNWRAP_DIVIDE_AT_PLANE_H
