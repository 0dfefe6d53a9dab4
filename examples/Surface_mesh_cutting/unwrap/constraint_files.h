// Files that name vertices and edges of the input, counted from 0.

#ifndef UNWRAP_CONSTRAINT_FILES_H
#define UNWRAP_CONSTRAINT_FILES_H

#include <string>
#include <vector>

struct Vertex_pair
{
  int source, target;
};

// CGAL's `.selection.txt`: a line of vertices, a line of faces, a line of edges as pairs of vertices.
// What is missing at the end is empty.
struct Selection
{
  std::vector<int> vertices, faces;
  std::vector<Vertex_pair> edges;
};

struct Edge_weight
{
  Vertex_pair edge;
  double weight; // not negative, may be infinite
};

struct Vertex_value
{
  int vertex;
  double value; // finite and not negative
};

struct Vertex_values
{
  bool is_for_all = false; // whether the lines have no vertices, and there must be one for each
  std::vector<Vertex_value> values;
};

// All throw a `Failure` with `Exit_code::UNREADABLE` that names the file and the line.
Selection read_selection(const std::string& path);
// A line for each edge: its two vertices and its weight.
std::vector<Edge_weight> read_edge_weights(const std::string& path);
// Either a number in each line, for the vertices in their order, or a vertex and a number in each line.
Vertex_values read_vertex_values(const std::string& path);

#endif // UNWRAP_CONSTRAINT_FILES_H
