// A PLY file, to be written again with other texture coordinates.

#ifndef UNWRAP_PLY_SOURCE_H
#define UNWRAP_PLY_SOURCE_H

#include "Ply_header.h"

#include <cstddef>
#include <string>
#include <vector>

// All bytes stay as they are but for some places, in the order of the file.
struct Ply_source
{
  enum class Content
  {
    IMAGE,               // the comment that names the file of the texture, if there is a new one
    FORMER_IMAGE,        // nothing, if there is a new one
    POINT_UV,            // nothing: texture coordinates of points would contradict those of corners
    PROPERTY,            // the line of the header that announces texture coordinates of corners
    TEXTURE_COORDINATES  // of the corners of the next polygon
  };

  struct Place
  {
    std::size_t begin, end; // in `bytes`
    Content content;
  };

  std::string bytes;
  Ply_header::Format format;
  std::string line_end;
  std::vector<Place> places;
};

#endif // UNWRAP_PLY_SOURCE_H
