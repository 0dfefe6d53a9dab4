// Triangles given by the vertices of a strip.

#ifndef UNWRAP_TRIANGLE_STRIP_H
#define UNWRAP_TRIANGLE_STRIP_H

#include <cstddef>
#include <vector>

// Three corners of each triangle, counterclockwise if those of the first one are: every other one is turned.
inline std::vector<int> triangles_of_strip(const std::vector<int>& vertices)
{
  std::vector<int> corners;
  for(std::size_t i = 2; i < vertices.size(); ++i)
  {
    const bool is_odd = i % 2 == 1;
    corners.insert(corners.end(), {vertices[is_odd ? i - 1 : i - 2], vertices[is_odd ? i - 2 : i - 1], vertices[i]});
  }
  return corners;
}

#endif // UNWRAP_TRIANGLE_STRIP_H
