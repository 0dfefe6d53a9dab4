#include "Stacking.h"

#include "halfedge_arrays.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace {

Halfedge halfedge_of(int h) { return Halfedge(Mesh::size_type(h)); }

// Copies the elements for which `is_kept`, in their order, and tells the numbers of the halfedges.
template <typename Is_kept>
void copy_part(const Surface& surface, Is_kept is_kept, Surface& part, std::vector<Halfedge>& halfedges)
{
  const Mesh& mesh = surface.mesh;
  std::vector<Vertex> vertices(mesh.num_vertices());
  std::vector<Face> faces(mesh.num_faces());
  halfedges.assign(mesh.num_halfedges(), Mesh::null_halfedge());
  Mesh::size_type number_of_halfedges = 0;
  for(const Vertex v : mesh.vertices())
    if(is_kept(mesh.halfedge(v)))
    {
      vertices[v] = Vertex(Mesh::size_type(part.vertices.size()));
      part.vertices.push_back(surface.vertices[v]);
    }
  for(const Face f : mesh.faces())
    if(is_kept(mesh.halfedge(f)))
    {
      faces[f] = Face(Mesh::size_type(part.polygons.size()));
      part.polygons.push_back(surface.polygons[f]);
    }
  for(const Halfedge h : mesh.halfedges())
    if(is_kept(h))
    {
      halfedges[h] = Halfedge(number_of_halfedges++);
      part.corners.push_back(surface.corners[h]);
    }
  part.mesh.resize(Mesh::size_type(part.vertices.size()), number_of_halfedges / 2, Mesh::size_type(part.polygons.size()));
  for(const Halfedge h : mesh.halfedges())
    if(is_kept(h))
    {
      part.mesh.set_target(halfedges[h], vertices[mesh.target(h)]);
      part.mesh.set_next(halfedges[h], halfedges[mesh.next(h)]);
      if(!mesh.is_border(h))
        part.mesh.set_face(halfedges[h], faces[mesh.face(h)]);
    }
  for(const Vertex v : mesh.vertices())
    if(is_kept(mesh.halfedge(v)))
    {
      part.mesh.point(vertices[v]) = mesh.point(v);
      part.mesh.set_halfedge(vertices[v], halfedges[mesh.halfedge(v)]);
    }
  for(const Face f : mesh.faces())
    if(is_kept(mesh.halfedge(f)))
      part.mesh.set_halfedge(faces[f], halfedges[mesh.halfedge(f)]);
}

} // namespace

Stacking::Stacking(const Surface& surface, double tolerance)
  : m_surface(surface), m_arrays(halfedge_arrays(surface.mesh)), m_components(m_arrays, tolerance)
{
  const Mesh& mesh = surface.mesh;
  std::vector<char> is_original(mesh.num_halfedges(), 0);
  for(int i = 0; i < m_components.number(); ++i)
  {
    if(m_components.original(i) != i)
      ++m_copies;
    else
      for(const int h : m_components.halfedges(i))
        is_original[std::size_t(h)] = is_original[std::size_t(mesh.opposite(halfedge_of(h)))] = 1;
  }
  copy_part(surface, [&](Halfedge h)
            { return h != Mesh::null_halfedge() && is_original[std::size_t(h)] != 0; }, m_originals, m_halfedges);
}

Halfedge Stacking::edge_of_original(Halfedge h) const
{
  return m_halfedges[std::size_t(m_components.halfedge_of_original(int(h)))];
}

Halfedge Stacking::corner_of_original(Halfedge h) const
{
  return m_halfedges[std::size_t(m_components.corner_of_original(int(h)))];
}

Constraints Stacking::constraints_of_originals(const Constraints& of_all)
{
  Mesh& mesh = m_originals.mesh;
  Constraints result;
  result.must_be_cut = mesh.add_property_map<Edge, bool>("e:must_be_cut", false).first;
  result.must_not_be_cut = mesh.add_property_map<Edge, bool>("e:must_not_be_cut", false).first;
  result.is_initially_cut = mesh.add_property_map<Edge, bool>("e:is_initially_cut", false).first;
  result.is_terminal = mesh.add_property_map<Vertex, bool>("v:is_terminal", false).first;
  if(of_all.weights)
    result.weights = mesh.add_property_map<Edge, double>("e:weight", 0).first;
  const Mesh& all = m_surface.mesh;
  for(const Halfedge h : all.halfedges())
  {
    if(all.is_border(h))
      continue;
    const Edge from = all.edge(h), to = mesh.edge(edge_of_original(h));
    result.must_be_cut[to] = result.must_be_cut[to] || of_all.must_be_cut[from];
    result.must_not_be_cut[to] = result.must_not_be_cut[to] || of_all.must_not_be_cut[from];
    result.is_initially_cut[to] = result.is_initially_cut[to] || of_all.is_initially_cut[from];
    const Vertex vertex = mesh.target(corner_of_original(h));
    result.is_terminal[vertex] = result.is_terminal[vertex] || of_all.is_terminal[all.target(h)];
    if(of_all.weights)
      (*result.weights)[to] = (std::max)((*result.weights)[to], (*of_all.weights)[from]);
  }
  return result;
}

void Stacking::copy_cut(Cut_map from, Cut_map to) const
{
  const Mesh& mesh = m_surface.mesh;
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      to[mesh.edge(h)] = from[m_originals.mesh.edge(edge_of_original(h))];
}

void Stacking::copy_uvs(UV_map from, UV_map to) const
{
  const Mesh& mesh = m_surface.mesh;
  for(const Halfedge h : mesh.halfedges())
    if(!mesh.is_border(h))
      to[h] = from[corner_of_original(h)];
}

bool Stacking::has_mirrored() const
{
  bool has_found = false;
  for(int i = 0; i < m_components.number(); ++i)
    has_found = has_found || m_components.is_mirrored(i);
  return has_found;
}

std::vector<std::vector<int> > Stacking::stacks() const
{
  std::vector<std::vector<int> > members(std::size_t(m_components.number())), result;
  for(int i = 0; i < m_components.number(); ++i)
    members[std::size_t(m_components.original(i))].push_back(i);
  std::copy_if(members.begin(), members.end(), std::back_inserter(result),
               [](const std::vector<int>& stack) { return stack.size() > 1; });
  return result;
}
