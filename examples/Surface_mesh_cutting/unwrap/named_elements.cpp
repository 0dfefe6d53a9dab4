#include "named_elements.h"

#include "outcome.h"

Vertex find_vertex(const std::string& path, int index, const Mesh& mesh)
{
  if(index >= int(mesh.number_of_vertices()))
    throw Failure(Exit_code::UNREADABLE,
                  path + ": refers to vertex " + std::to_string(index) + ", but there are only "
                    + std::to_string(mesh.number_of_vertices()) + " (all counted from 0)");
  return Vertex(Mesh::size_type(index));
}

Edge find_edge(const std::string& path, Vertex_pair pair, const Mesh& mesh)
{
  const Halfedge h = mesh.halfedge(find_vertex(path, pair.source, mesh), find_vertex(path, pair.target, mesh));
  if(h == Mesh::null_halfedge())
    throw Failure(Exit_code::UNSUPPORTED,
                  path + ": there is no edge between vertices " + std::to_string(pair.source) + " and "
                    + std::to_string(pair.target),
                  {Witness::Kind::EDGES, {pair.source, pair.target}});
  return mesh.edge(h);
}
