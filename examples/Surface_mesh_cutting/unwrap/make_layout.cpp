#include "make_layout.h"

#include "outcome.h"

#include <cmath>

namespace {

// Numbers the UV vertices in the order in which the faces meet them.
class Layout_builder
{
public:
  Layout_builder(const Mesh& mesh, Cut_map is_cut, UV_map uvs, const Polygon_soup& soup)
    : m_mesh(mesh), m_is_cut(is_cut), m_uvs(uvs), m_soup(soup),
      m_uv_vertices(mesh.num_halfedges(), -1)
  {}

  Layout build()
  {
    m_layout.points = m_soup.points;
    for(const Face f : m_mesh.faces())
      add_face(f);
    for(const Halfedge h : m_mesh.halfedges())
      if(!m_mesh.is_border(h) && is_separated(h))
        m_layout.chart_borders.push_back({{m_uv_vertices[m_mesh.prev(h)], m_uv_vertices[h]}});
    for(const Edge e : m_mesh.edges())
      if(get(m_is_cut, e))
        m_layout.cut.push_back({{int(m_mesh.vertex(e, 0)), int(m_mesh.vertex(e, 1))}});
    return std::move(m_layout);
  }

private:
  bool is_separated(Halfedge h) const
  {
    return m_mesh.is_border(m_mesh.edge(h)) || get(m_is_cut, m_mesh.edge(h));
  }

  void add_face(Face f)
  {
    Layout::Triangle triangle, uv_triangle;
    Halfedge h = m_mesh.halfedge(f);
    while(int(m_mesh.target(h)) != m_soup.corner(int(f), 0)) // where the file begins the face
      h = m_mesh.next(h);
    for(std::size_t k = 0; k < 3; ++k, h = m_mesh.next(h))
    {
      if(m_uv_vertices[h] < 0)
        add_uv_vertex(h);
      triangle[k] = int(m_mesh.target(h));
      uv_triangle[k] = m_uv_vertices[h];
    }
    m_layout.triangles.push_back(triangle);
    m_layout.uv_triangles.push_back(uv_triangle);
  }

  // Gives one UV vertex to all corners around the target of `start` that no cut separates.
  void add_uv_vertex(Halfedge start)
  {
    const Kernel::Point_2& uv = get(m_uvs, start);
    if(!std::isfinite(uv.x()) || !std::isfinite(uv.y()))
      throw Failure(Exit_code::FAILED, "a texture coordinate is not finite");
    const auto assign = [&](Halfedge h)
    {
      if(get(m_uvs, h) != uv)
        throw Failure(Exit_code::FAILED, "texture coordinates differ where there is no cut");
      m_uv_vertices[h] = int(m_layout.uv_points.size());
    };
    assign(start);
    Halfedge h = start; // turn one way, and if that does not close, the other one
    while(!is_separated(h) && m_mesh.prev(m_mesh.opposite(h)) != start)
      assign(h = m_mesh.prev(m_mesh.opposite(h)));
    if(is_separated(h))
      for(h = start; !is_separated(m_mesh.next(h));)
        assign(h = m_mesh.opposite(m_mesh.next(h)));
    m_layout.uv_points.push_back({{uv.x(), uv.y()}});
  }

  const Mesh& m_mesh;
  Cut_map m_is_cut;
  UV_map m_uvs;
  const Polygon_soup& m_soup;
  std::vector<int> m_uv_vertices; // per halfedge: of the corner at its target
  Layout m_layout;
};

} // namespace

Layout make_layout(const Mesh& mesh, Cut_map is_cut, UV_map uvs, const Polygon_soup& soup)
{
  return Layout_builder(mesh, is_cut, uvs, soup).build();
}
