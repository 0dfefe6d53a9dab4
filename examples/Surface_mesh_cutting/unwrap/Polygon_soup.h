// Points and polygons as a file lists them, before anything is known about their connectivity.

#ifndef UNWRAP_POLYGON_SOUP_H
#define UNWRAP_POLYGON_SOUP_H

#include "Data_kinds.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct Gltf_source;
struct Ply_source;

// What an OBJ file says besides geometry and looks, to be written again. What glTF says about groups and materials is
// told in the same words.
struct Obj_statements
{
  struct Line
  {
    int polygon; // before which it stands; -1 before all points
    std::string text;
  };

  std::vector<Line> lines; // all that bring neither a point nor a polygon, and comments
  std::vector<std::string> point_ends; // per point, what follows the coordinates; empty if nothing does
};

struct Polygon_soup
{
  using Point = std::array<double, 3>;
  using Texture_point = std::array<double, 2>;

  std::vector<Point> points;
  std::vector<int> corners; // point indices of all polygons, one polygon after the other
  std::vector<std::size_t> polygon_ends; // per polygon, where its corners end

  // What was asked for besides; empty if the file does not have it.
  std::vector<std::array<double, 3> > colors; // per point: red, green and blue, valid ones from 0 to 1
  std::vector<std::optional<Texture_point> > corner_uvs; // per corner
  std::vector<std::array<double, 3> > face_colors; // per polygon, from 0 to 1
  std::vector<std::array<double, 3> > normals;
  std::vector<int> corner_normals; // per corner, -1 for none
  Obj_statements obj_statements;
  std::shared_ptr<const Ply_source> ply_source;
  std::shared_ptr<const Gltf_source> gltf_source;
  // Of glTF, whose points are welded within a mesh by the reader, per point: its mesh at a place of the scene, and the point
  // that it repeats with another color, or itself.
  std::vector<int> point_parts, originals;
  Data_kinds kinds; // that the file holds, also those that are not kept
  std::vector<std::string> warnings; // about the file

  // Makes a polygon of the corners added since the last call.
  void close_polygon() { polygon_ends.push_back(corners.size()); }

  int number_of_points() const { return int(points.size()); }
  int number_of_polygons() const { return int(polygon_ends.size()); }

  std::size_t first_corner(int polygon) const
  {
    return polygon == 0 ? 0 : polygon_ends[std::size_t(polygon) - 1];
  }
  int number_of_corners(int polygon) const
  {
    return int(polygon_ends[std::size_t(polygon)] - first_corner(polygon));
  }
  int corner(int polygon, int k) const { return corners[first_corner(polygon) + std::size_t(k)]; }
};

#endif // UNWRAP_POLYGON_SOUP_H
