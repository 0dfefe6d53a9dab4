// The glTF file from which a soup was read, to be written again with other texture coordinates.

#ifndef UNWRAP_GLTF_SOURCE_H
#define UNWRAP_GLTF_SOURCE_H

#include "Gltf_document.h"

#include <cstddef>
#include <vector>

struct Gltf_source
{
  // Triangles of a mesh.
  struct Primitive
  {
    std::size_t mesh, index;
    std::size_t number_of_vertices;
    std::size_t first_corner;  // of the soup
    std::vector<int> vertices; // of the primitive, per corner of the soup from there on
  };

  gltf::Document document;
  std::vector<Primitive> primitives; // of each mesh once, in the order of their corners
};

#endif // UNWRAP_GLTF_SOURCE_H
