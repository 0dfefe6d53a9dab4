// What the options say about the edges and vertices of the mesh.

#ifndef UNWRAP_CONSTRAINTS_H
#define UNWRAP_CONSTRAINTS_H

#include "Polygon_soup.h"
#include "Surface.h"
#include "options.h"

#include <optional>
#include <string>
#include <vector>

struct Constraints
{
  Mesh::Property_map<Edge, bool> must_be_cut, must_not_be_cut, is_initially_cut;
  Mesh::Property_map<Vertex, bool> is_terminal;
  std::optional<Mesh::Property_map<Edge, double> > weights; // without: the lengths
  std::vector<std::string> warnings;
};

// `surface` is read from the soup. Throws a `Failure`: `Exit_code::UNREADABLE` if a file cannot be read or
// has an index out of range, `Exit_code::UNSUPPORTED` if it names an edge that the mesh does not have, or if the
// input has no texture coordinates or colors that are asked for.
Constraints read_constraints(const Options& options, const Polygon_soup& soup, Surface& surface);

#endif // UNWRAP_CONSTRAINTS_H
