// The parts of a mesh that differ in object, group or material.

#ifndef UNWRAP_MESH_PARTS_H
#define UNWRAP_MESH_PARTS_H

#include "Polygon_soup.h"

#include <string>
#include <vector>

struct Mesh_parts
{
  struct Part
  {
    std::string name; // of object and group; empty if it has none
    std::string material;
  };

  std::vector<Part> parts;        // those with polygons, in the order of their names
  std::vector<int> polygon_parts; // per polygon
};

// By the statements of OBJ; those of glTF are in its words.
Mesh_parts find_parts(const Obj_statements& statements, int number_of_polygons);

#endif // UNWRAP_MESH_PARTS_H
