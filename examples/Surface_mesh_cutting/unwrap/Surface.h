// The surface as which a soup is read.

#ifndef UNWRAP_SURFACE_H
#define UNWRAP_SURFACE_H

#include "Mesh.h"
#include "Polygon_soup.h"

#include <CGAL/Surface_mesh_cutting/internal/soup/Welding.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// What in the soup is not a plain surface. Edges are given by pairs of vertices.
struct Interpretation
{
  std::string what;
  std::vector<int> elements;
  std::vector<std::pair<int, int> > edges;

  std::size_t count() const { return elements.size() + edges.size(); }
};

// A manifold mesh, whose faces are polygons of the soup in their order. Where the soup is one, vertices and faces have
// the same numbers in both.
struct Surface
{
  Mesh mesh;
  std::vector<int> vertices;      // per vertex of the mesh, that of the soup
  std::vector<int> polygons;      // per face of the mesh, the one that it is, or is a loop of
  std::vector<int> corners;       // per halfedge, the corner of the soup at its target; -1 on a border
  std::vector<Halfedge> halfedges; // per corner of the soup, the one to the corner whose UV it has
  std::vector<Interpretation> interpreted;
  std::vector<std::string> warnings; // of what the user should know

  // Whether vertices and faces have the same numbers in both.
  bool is_like_soup(const Polygon_soup& soup) const
  {
    const auto counts = [](const std::vector<int>& numbers, std::size_t size)
    {
      for(std::size_t i = 0; i < numbers.size(); ++i)
        if(numbers[i] != int(i))
          return false;
      return numbers.size() == size;
    };
    return counts(soup.originals, soup.originals.size()) && counts(vertices, soup.points.size()) &&
           counts(polygons, soup.polygon_ends.size());
  }
};

// Indices are in range, and points that polygons use finite. Throws a `Failure` with `Exit_code::UNSUPPORTED` if no polygon is
// part of a surface.
Surface read_surface(const Polygon_soup& soup, const CGAL::Surface_mesh_cutting::internal::Welding& welding);

#endif // UNWRAP_SURFACE_H
