// Edges to cut that need no file: the input tells where they are.

#ifndef UNWRAP_KNOWN_EDGES_H
#define UNWRAP_KNOWN_EDGES_H

#include "Polygon_soup.h"
#include "Surface.h"

#include <string>
#include <vector>

// Whether a word stands for such edges: uv, angle:DEGREES, materials, groups. Throws a usage error if the angle is none
// between 0 and 180. A file of this name is ./NAME.
bool is_word_for_edges(const std::string& word);

// Marks the edges that a word stands for: the seams of the texture coordinates; the edges where the surface bends by at least
// the angle; those between faces of different materials, or of different groups or objects. A warning says where there are none.
// `surface` is read from the soup. Throws a `Failure` with `Exit_code::UNSUPPORTED` if the input has nothing of the kind.
void mark_known_edges(const std::string& option, const std::string& word, const Polygon_soup& soup, Surface& surface,
                      Mesh::Property_map<Edge, bool> is_marked, std::vector<std::string>& warnings);

// Marks the edges where the surface bends by at least the angle, in degrees.
void mark_hard_edges(const Mesh& mesh, double angle, Mesh::Property_map<Edge, bool> is_marked);

#endif // UNWRAP_KNOWN_EDGES_H
