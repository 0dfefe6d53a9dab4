#include "Stacking.h"

#include "halfedge_arrays.h"
#include "make_mesh.h"
#include "outcome.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace {

using CGAL::Surface_mesh_cutting::internal::Halfedge_arrays;
using CGAL::Surface_mesh_cutting::internal::Soup_surface;

// The sides of the divided edges are borders.
Halfedge_arrays divided_arrays(const Mesh& mesh, const std::vector<char>& is_divided)
{
  Halfedge_arrays arrays = halfedge_arrays(mesh);
  for(const Halfedge h : mesh.halfedges())
    if(!is_divided.empty() && is_divided[std::size_t(mesh.edge(h))] != 0)
      arrays.opposite[h] = -1;
  return arrays;
}

// The side from which the mesh of a soup begins a face.
Halfedge first_side(const Mesh& mesh, Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return mesh.next(mesh.next(mesh.next(h))) == h ? mesh.next(h) : h;
}

// Copies the faces for which `is_kept`, in their order, and tells the numbers of their halfedges. Vertices at which they touch
// themselves, once they are divided, are copied as often.
class Part_copier
{
public:
  Part_copier(const Surface& surface, const Halfedge_arrays& arrays, const std::vector<char>& is_kept)
    : m_surface(surface), m_arrays(arrays), m_is_kept(is_kept), m_side(arrays.next.size(), -1), m_vertex(arrays.next.size(), -1)
  {}

  void copy(Surface& part, std::vector<Halfedge>& halfedges)
  {
    add_vertices(part);
    add_polygons(part);
    const std::vector<Halfedge> of_sides = number_halfedges(m_copy);
    part.mesh = make_mesh(m_copy, of_sides);
    part.corners.assign(part.mesh.num_halfedges(), -1);
    halfedges.assign(m_side.size(), Mesh::null_halfedge());
    for(std::size_t h = 0; h < m_side.size(); ++h)
      if(m_side[h] >= 0)
      {
        halfedges[h] = of_sides[std::size_t(m_side[h])];
        part.corners[halfedges[h]] = m_surface.corners[h];
      }
  }

private:
  // One for all kept faces around a vertex that are connected.
  void add_vertices(Surface& part)
  {
    const Mesh& mesh = m_surface.mesh;
    for(const Vertex v : mesh.vertices())
    {
      if(mesh.halfedge(v) == Mesh::null_halfedge())
        continue;
      for(const Halfedge to_vertex : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
      {
        if(!m_is_kept[to_vertex] || m_vertex[to_vertex] >= 0)
          continue;
        std::vector<int> stack(1, int(to_vertex));
        m_vertex[to_vertex] = int(m_copy.points.size());
        while(!stack.empty())
        {
          const int h = stack.back(), out = m_arrays.opposite[m_arrays.next[h]], back = m_arrays.opposite[h];
          stack.pop_back();
          for(const int g : {out, back < 0 ? -1 : m_arrays.previous[back]})
            if(g >= 0 && m_vertex[g] < 0)
            {
              m_vertex[g] = m_vertex[h];
              stack.push_back(g);
            }
        }
        part.vertices.push_back(m_surface.vertices[v]);
        m_copy.points.push_back(m_arrays.points[v]);
      }
    }
  }

  void add_polygons(Surface& part)
  {
    const Mesh& mesh = m_surface.mesh;
    for(const Face f : mesh.faces())
    {
      if(!m_is_kept[mesh.halfedge(f)])
        continue;
      const Halfedge first = first_side(mesh, f);
      Halfedge h = first;
      do
      {
        m_side[h] = m_copy.polygons.number_of_corners();
        m_copy.polygons.vertices.push_back(m_vertex[mesh.prev(h)]);
      }
      while((h = mesh.next(h)) != first);
      m_copy.polygons.close();
      part.polygons.push_back(m_surface.polygons[f]);
    }
    m_copy.opposites.assign(m_copy.polygons.vertices.size(), -1);
    for(std::size_t h = 0; h < m_side.size(); ++h)
      if(m_side[h] >= 0 && m_arrays.opposite[h] >= 0)
        m_copy.opposites[std::size_t(m_side[h])] = m_side[m_arrays.opposite[h]];
  }

  const Surface& m_surface;
  const Halfedge_arrays& m_arrays;
  const std::vector<char>& m_is_kept; // per halfedge
  std::vector<int> m_side, m_vertex;  // of the copy: per halfedge, and per halfedge that leads there
  Soup_surface m_copy;
};

} // namespace

Stacking::Stacking(const Surface& surface, double tolerance, const std::optional<Division>& division)
  : m_surface(surface), m_is_divided(division ? division->is_divided : std::vector<char>()),
    m_arrays(divided_arrays(surface.mesh, m_is_divided)),
    m_components(m_arrays, tolerance, division ? division->reflection : std::vector<int>())
{
  std::vector<char> is_original(surface.mesh.num_halfedges(), 0);
  for(int i = 0; i < m_components.number(); ++i)
  {
    if(m_components.original(i) != i)
      ++m_copies;
    else
      for(const int h : m_components.halfedges(i))
        is_original[std::size_t(h)] = 1;
  }
  Part_copier(surface, m_arrays, is_original).copy(m_originals, m_halfedges);
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
    if(is_divided(from) && (of_all.must_not_be_cut[from] || (of_all.weights && std::isinf((*of_all.weights)[from]))))
      throw Failure(Exit_code::UNSUPPORTED, "--stack: the plane of symmetry runs along edges that are not to be cut");
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
    {
      const Edge e = mesh.edge(h);
      to[e] = is_divided(e) || from[m_originals.mesh.edge(edge_of_original(h))];
    }
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
