// The surface as which a soup is read.

#ifndef UNWRAP_SURFACE_H
#define UNWRAP_SURFACE_H

#include "Mesh.h"
#include "Polygon_soup.h"

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
  std::vector<int> polygons;      // per face of the mesh
  std::vector<int> corners;       // per halfedge, the corner of the soup at its target; -1 on a border
  std::vector<Halfedge> halfedges; // per corner of the soup, the one to the corner whose UV it has
  std::vector<Interpretation> interpreted;

  // Whether vertices and faces have the same numbers in both.
  bool is_like_soup(const Polygon_soup& soup) const
  {
    if(vertices.size() != soup.points.size() || polygons.size() != soup.polygon_ends.size())
      return false;
    for(std::size_t v = 0; v < vertices.size(); ++v)
      if(vertices[v] != int(v) || (!soup.originals.empty() && soup.originals[v] != int(v)))
        return false;
    return true;
  }
};

// `do_weld`: whether vertices at exactly the same point are one. Indices are in range and points finite. Throws a
// `Failure` with `Exit_code::UNSUPPORTED` if no polygon is part of a surface.
Surface read_surface(const Polygon_soup& soup, bool do_weld);

#endif // UNWRAP_SURFACE_H
