#include "make_layout.h"

#include "outcome.h"
#include "vertex_colors.h"

#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

namespace SMC = CGAL::Surface_mesh_cutting;
using Point_map = Mesh::Property_map<Vertex, Kernel::Point_3>;

// Numbers the UV vertices in the order in which the polygons meet them.
class Layout_builder
{
public:
  Layout_builder(const Surface& surface, Cut_map is_cut, const Polygon_soup& soup)
    : m_surface(surface), m_mesh(surface.mesh), m_is_cut(is_cut), m_soup(soup),
      m_uv_vertices(m_mesh.num_halfedges(), -1), m_layout(layout_without_uvs(soup))
  {}

  Layout build()
  {
    m_layout.corner_uvs.reserve(m_surface.halfedges.size());
    m_layout.corner_vertices.reserve(m_surface.halfedges.size());
    for(const Halfedge h : m_surface.halfedges)
    {
      if(m_uv_vertices[h] < 0)
        add_uv_vertex(h);
      m_layout.corner_uvs.push_back(m_uv_vertices[h]);
      m_layout.corner_vertices.push_back(int(m_mesh.target(h)));
    }
    add_triangles();
    for(const Halfedge h : m_mesh.halfedges())
      if(!m_mesh.is_border(h) && is_separated(h))
        m_layout.chart_borders.push_back({{m_uv_vertices[m_mesh.prev(h)], m_uv_vertices[h]}});
    for(const Edge e : m_mesh.edges())
      if(get(m_is_cut, e))
        m_layout.cut.push_back({{m_surface.vertices[m_mesh.vertex(e, 0)], m_surface.vertices[m_mesh.vertex(e, 1)]}});
    return std::move(m_layout);
  }

private:
  bool is_separated(Halfedge h) const
  {
    return m_mesh.is_border(m_mesh.edge(h)) || get(m_is_cut, m_mesh.edge(h));
  }

  // Triangles as the library makes them, which are those for which it proves the map.
  void add_triangles()
  {
    if(CGAL::is_triangle_mesh(m_mesh))
    {
      for(std::vector<Layout::Triangle>* triangles :
          {&m_layout.triangles, &m_layout.triangle_corners, &m_layout.uv_triangles})
        triangles->reserve(m_mesh.number_of_faces());
      for(const Face f : m_mesh.faces())
        add_triangle(halfedges_from_file(f));
      return;
    }
    const SMC::internal::Mesh_adapter<Mesh, Point_map> adapter(m_mesh, m_mesh.points());
    for(int t = 0; t < adapter.mesh().number_of_faces(); ++t)
      add_triangle({{adapter.to_halfedge_at_source(3 * t), adapter.to_halfedge_at_source(3 * t + 1),
                     adapter.to_halfedge_at_source(3 * t + 2)}});
  }

  // The halfedges to the corners of a triangle, from the one that the file lists first.
  std::array<Halfedge, 3> halfedges_from_file(Face f) const
  {
    const Halfedge h = m_mesh.halfedge(f);
    std::array<Halfedge, 3> result = {{h, m_mesh.next(h), m_mesh.prev(h)}};
    const auto is_before = [&](Halfedge a, Halfedge b) { return m_surface.corners[a] < m_surface.corners[b]; };
    std::rotate(result.begin(), std::min_element(result.begin(), result.end(), is_before), result.end());
    return result;
  }

  void add_triangle(const std::array<Halfedge, 3>& to_corners)
  {
    Layout::Triangle triangle, corners, uv_triangle;
    for(std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = m_surface.corners[to_corners[k]];
      triangle[k] = m_soup.corners[std::size_t(corners[k])];
      uv_triangle[k] = m_uv_vertices[to_corners[k]];
    }
    m_layout.triangles.push_back(triangle);
    m_layout.triangle_corners.push_back(corners);
    m_layout.uv_triangles.push_back(uv_triangle);
  }

  // Gives one UV vertex to all corners around the target of `start` that no cut separates.
  void add_uv_vertex(Halfedge start)
  {
    const int number = m_number_of_uv_vertices++;
    const auto assign = [&](Halfedge h) { m_uv_vertices[h] = number; };
    assign(start);
    Halfedge h = start; // turn one way, and if that does not close, the other one
    while(!is_separated(h) && m_mesh.prev(m_mesh.opposite(h)) != start)
      assign(h = m_mesh.prev(m_mesh.opposite(h)));
    if(is_separated(h))
      for(h = start; !is_separated(m_mesh.next(h));)
        assign(h = m_mesh.opposite(m_mesh.next(h)));
  }

  const Surface& m_surface;
  const Mesh& m_mesh;
  Cut_map m_is_cut;
  const Polygon_soup& m_soup;
  std::vector<int> m_uv_vertices; // per halfedge: of the corner at its target
  int m_number_of_uv_vertices = 0;
  Layout m_layout;
};

} // namespace

Layout layout_without_uvs(const Polygon_soup& soup)
{
  Layout layout;
  layout.points = soup.points;
  layout.corners = soup.corners;
  layout.polygon_ends = soup.polygon_ends;
  if(!find_wrong_color(soup))
    layout.colors = soup.colors;
  layout.face_colors = soup.face_colors;
  layout.normals = soup.normals;
  layout.corner_normals = soup.corner_normals;
  layout.obj_statements = soup.obj_statements;
  layout.ply_source = soup.ply_source;
  layout.gltf_source = soup.gltf_source;
  layout.kinds = soup.kinds;
  layout.former_uvs = soup.corner_uvs;
  return layout;
}

Layout make_layout(const Surface& surface, Cut_map is_cut, const Polygon_soup& soup)
{
  return Layout_builder(surface, is_cut, soup).build();
}

void place_uv_vertices(const Surface& surface, UV_map uvs, Layout& layout)
{
  for(std::size_t corner = 0; corner < layout.corner_uvs.size(); ++corner)
  {
    const Kernel::Point_2& uv = get(uvs, surface.halfedges[corner]);
    const std::array<double, 2> point = {{uv.x(), uv.y()}};
    const std::size_t number = std::size_t(layout.corner_uvs[corner]); // in the order in which the corners meet them
    if(number == layout.uv_points.size())
    {
      if(!std::isfinite(uv.x()) || !std::isfinite(uv.y()))
        throw Failure(Exit_code::FAILED, "a texture coordinate is not finite");
      layout.uv_points.push_back(point);
    }
    else if(layout.uv_points[number] != point)
      throw Failure(Exit_code::FAILED, "texture coordinates differ where there is no cut");
  }
}
