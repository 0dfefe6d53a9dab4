#include "named_elements.h"

#include "outcome.h"

#include <algorithm>

Named_elements::Named_elements(const Polygon_soup& soup, const Surface& surface)
  : m_surface(surface), m_number_of_vertices(soup.number_of_points())
{
  if(surface.is_like_soup(soup))
    return;
  for(const Vertex v : surface.mesh.vertices())
    m_copies.emplace_back(surface.vertices[v], v);
  for(const Halfedge h : surface.mesh.halfedges())
    if(surface.corners[h] >= 0)
      m_copies.emplace_back(soup.corners[std::size_t(surface.corners[h])], surface.mesh.target(h));
  std::sort(m_copies.begin(), m_copies.end());
  m_copies.erase(std::unique(m_copies.begin(), m_copies.end()), m_copies.end());
}

std::vector<Vertex> Named_elements::find_vertices(const std::string& path, int index) const
{
  if(index >= m_number_of_vertices)
    throw Failure(Exit_code::UNREADABLE,
                  path + ": refers to vertex " + std::to_string(index) + ", but there are only "
                    + std::to_string(m_number_of_vertices) + " (all counted from 0)");
  if(m_copies.empty())
    return {Vertex(Mesh::size_type(index))};
  std::vector<Vertex> vertices;
  for(auto copy = std::lower_bound(m_copies.begin(), m_copies.end(), std::make_pair(index, Vertex(0)));
      copy != m_copies.end() && copy->first == index; ++copy)
    vertices.push_back(copy->second);
  return vertices;
}

std::vector<Edge> Named_elements::find_edges(const std::string& path, Vertex_pair pair) const
{
  std::vector<Edge> edges;
  for(const Vertex v : find_vertices(path, pair.source))
    for(const Vertex w : find_vertices(path, pair.target))
      if(const Halfedge h = m_surface.mesh.halfedge(v, w); h != Mesh::null_halfedge())
        edges.push_back(m_surface.mesh.edge(h));
  if(edges.empty())
    throw Failure(Exit_code::UNSUPPORTED,
                  path + ": there is no edge between vertices " + std::to_string(pair.source) + " and "
                    + std::to_string(pair.target),
                  {Witness::Kind::EDGES, {pair.source, pair.target}});
  return edges;
}
