// A surface and the plane layout of its polygons and triangles, as the writers need them.

#ifndef UNWRAP_LAYOUT_H
#define UNWRAP_LAYOUT_H

#include "Polygon_soup.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

struct Layout
{
  using Triangle = std::array<int, 3>;
  using Edge = std::array<int, 2>;

  std::vector<std::array<double, 3> > points;
  // All polygons as the file lists them: the points of their corners, where those of each one end, and the UV vertices.
  std::vector<int> corners;
  std::vector<std::size_t> polygon_ends;
  std::vector<int> corner_uvs;
  std::vector<int> corner_vertices; // of the surface: there are several at a point where it touches itself

  // What the file says besides, see `Polygon_soup`.
  std::vector<std::array<double, 3> > colors; // valid ones
  std::vector<std::array<double, 3> > face_colors;
  std::vector<std::array<double, 3> > normals;
  std::vector<int> corner_normals;
  Obj_statements obj_statements;
  std::shared_ptr<const Ply_source> ply_source;
  std::shared_ptr<const Gltf_source> gltf_source;
  Data_kinds kinds;

  // The polygons of the surface in triangles that face up.
  std::vector<Triangle> triangles;
  std::vector<Triangle> triangle_corners; // per triangle, which corners of all polygons it has

  // One point per UV vertex: corners share it unless a cut edge lies between them.
  std::vector<std::array<double, 2> > uv_points;
  std::vector<Triangle> uv_triangles;
  // The page of each polygon, if there are several, which lie side by side in the plane; for files in which they lie on top of
  // each other, also the corner of the page of each UV vertex.
  std::vector<int> polygon_pages;
  std::vector<std::array<double, 2> > page_corners;
  bool has_mirrored = false; // copies of charts, whose triangles are clockwise
  std::vector<Edge> chart_borders; // between UV vertices, each border once

  std::vector<Edge> cut; // between vertices
  std::vector<int> feature_points; // vertices
  double bounding_box_diagonal = 0;
  double uv_scale = 1; // UV units per unit of length
  int uv_set = 0;      // which to write
  std::vector<std::optional<std::array<double, 2> > > former_uvs; // per corner, where they were read

  // As files have it.
  std::array<double, 2> written_uv(std::size_t uv_vertex) const
  {
    std::array<double, 2> uv = uv_points[uv_vertex];
    for(std::size_t i = 0; i < 2 && !page_corners.empty(); ++i)
      uv[i] -= page_corners[uv_vertex][i]; // exact
    return uv;
  }
};

#endif // UNWRAP_LAYOUT_H
