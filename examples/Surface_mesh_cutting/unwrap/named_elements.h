// The vertices and edges that a file of constraints names.

#ifndef UNWRAP_NAMED_ELEMENTS_H
#define UNWRAP_NAMED_ELEMENTS_H

#include "Mesh.h"
#include "constraint_files.h"

#include <string>

// Throws a `Failure` with `Exit_code::UNREADABLE` if there are fewer vertices.
Vertex find_vertex(const std::string& path, int index, const Mesh& mesh);

// The same, and `Exit_code::UNSUPPORTED` if the mesh has no such edge.
Edge find_edge(const std::string& path, Vertex_pair pair, const Mesh& mesh);

#endif // UNWRAP_NAMED_ELEMENTS_H
