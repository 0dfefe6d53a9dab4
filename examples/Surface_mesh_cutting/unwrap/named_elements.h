// The elements of the mesh that a file of constraints names by vertices of the input.

#ifndef UNWRAP_NAMED_ELEMENTS_H
#define UNWRAP_NAMED_ELEMENTS_H

#include "Surface.h"
#include "constraint_files.h"

#include <string>
#include <utility>
#include <vector>

// Where the surface splits or joins vertices of the soup, a name stands for all elements of the mesh at the vertices.
class Named_elements
{
public:
  Named_elements(const Polygon_soup& soup, const Surface& surface);

  const Surface& surface() const { return m_surface; }
  int number_of_vertices() const { return m_number_of_vertices; }

  // Both throw a `Failure` that names the file: `Exit_code::UNREADABLE` if an index is out of range,
  // `Exit_code::UNSUPPORTED` if there is no such edge.
  std::vector<Vertex> find_vertices(const std::string& path, int index) const;
  std::vector<Edge> find_edges(const std::string& path, Vertex_pair pair) const;

private:
  const Surface& m_surface;
  const int m_number_of_vertices;
  std::vector<std::pair<int, Vertex> > m_copies; // of the vertices of the soup; empty if each is its own
};

#endif // UNWRAP_NAMED_ELEMENTS_H
