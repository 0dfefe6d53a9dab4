// Meshes of all types against their indexed copies, and what is refused.

#include <CGAL/Surface_mesh_cutting/internal/base.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/input/mesh_checks.h>

#include "../BGL/check.h"
#include "test_meshes.h"

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace mesh_adapter_test {

using CGAL::Surface_mesh_cutting::Result_status;
using CGAL::Surface_mesh_cutting::Status_code;
using namespace CGAL::Surface_mesh_cutting::internal;
using test::Soup;
using test::Surface_mesh;

template <typename Mesh>
using Adapter = Mesh_adapter<Mesh, typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type>;

template <typename Mesh>
Adapter<Mesh> adapt(const Mesh& mesh) { return Adapter<Mesh>(mesh, get(CGAL::vertex_point, mesh)); }

// Whether the mesh is refused, and what the warnings are if it is not.
template <typename Mesh>
Result_status<Mesh> check(const Mesh& mesh)
{
  const Adapter<Mesh> adapter = adapt(mesh);
  Indexed_status status = adapter.status();
  CHECK(status.warnings.empty());
  if(status)
    status.warnings = adapter.warnings();
  return adapter.translate(status);
}

// Cuts and UVs to the caller's maps and back.
template <typename Mesh>
void test_maps(const Mesh& mesh, const Adapter<Mesh>& adapter)
{
  using Graph_traits = boost::graph_traits<Mesh>;
  const Indexed_mesh& flat = adapter.mesh();
  CGAL::Random random(2);
  auto cut_map = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  for(auto e : edges(mesh))
    put(cut_map, e, random.get_bool());
  Cut cut = adapter.read_cut(cut_map);
  for(int e = 0; e < flat.number_of_edges(); ++e)
  {
    CHECK(bool(cut[e]) == (get(cut_map, adapter.to_edge(e)) && !is_border(adapter.to_edge(e), mesh)));
    cut[e] = !cut[e] && !flat.is_border_edge(e);
  }
  adapter.write_cut(cut, cut_map);
  CHECK(adapter.read_cut(cut_map) == cut);
  for(auto e : edges(mesh))
    CHECK(!(is_border(e, mesh) && get(cut_map, e)));

  const Corner_table chart = make_chart(flat, cut);
  std::vector<Eigen::Vector2d> uv;
  for(int v = 0; v < chart.number_of_vertices(); ++v)
    uv.emplace_back(random.get_double(), random.get_double());
  std::map<typename Graph_traits::halfedge_descriptor, test::Inexact_kernel::Point_2> uvs;
  auto uv_map = boost::make_assoc_property_map(uvs);
  adapter.write_uvs(chart, uv, uv_map);
  CHECK(int(uvs.size()) == flat.number_of_halfedges());
  for(const auto& entry : uvs)
    CHECK(!is_border(entry.first, mesh));
  const std::vector<Eigen::Vector2d> corners = adapter.read_uvs(uv_map);
  for(int h = 0; h < flat.number_of_halfedges(); ++h)
    for(int k = 0; k < 2; ++k)
      CHECK(corners[h][k] == adapter.to_original_scale(uv[chart.source(h)][k]));
}

// The indexed mesh has the elements of the mesh, in its order, and its connectivity and geometry.
template <typename Mesh>
void test_copy(const Mesh& mesh)
{
  using Graph_traits = boost::graph_traits<Mesh>;
  const Adapter<Mesh> adapter = adapt(mesh);
  CHECK(adapter.status());
  const Indexed_mesh& flat = adapter.mesh();

  std::map<typename Graph_traits::vertex_descriptor, int> vertex_index;
  for(auto v : vertices(mesh))
  {
    const int i = int(vertex_index.size());
    vertex_index[v] = i;
    CHECK(adapter.to_vertex(i) == v);
    const auto p = get(CGAL::vertex_point, mesh, v);
    for(int k = 0; k < 3; ++k)
      CHECK(adapter.to_original_scale(flat.point(i)[k]) == CGAL::to_double(p[k]));
  }
  CHECK(flat.number_of_vertices() == int(vertex_index.size()));

  int f = 0;
  std::map<typename Graph_traits::halfedge_descriptor, int> halfedge_index;
  for(auto face : faces(mesh))
  {
    CHECK(adapter.to_face(f) == face);
    auto h = halfedge(face, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh))
    {
      CHECK(adapter.to_halfedge(3 * f + k) == h);
      CHECK(flat.source(3 * f + k) == vertex_index.at(source(h, mesh)));
      CHECK(flat.target(3 * f + k) == vertex_index.at(target(h, mesh)));
      halfedge_index[h] = 3 * f + k;
    }
    ++f;
  }
  CHECK(flat.number_of_faces() == f);

  std::set<int> edges_seen;
  for(auto e : edges(mesh))
    for(auto h : {halfedge(e, mesh), opposite(halfedge(e, mesh), mesh)})
    {
      if(is_border(h, mesh))
        continue;
      const int i = halfedge_index.at(h);
      const auto o = opposite(h, mesh);
      CHECK(flat.opposite(i) == (is_border(o, mesh) ? -1 : halfedge_index.at(o)));
      CHECK(adapter.to_edge(flat.edge(i)) == e);
      edges_seen.insert(flat.edge(i));
      const auto p = get(CGAL::vertex_point, mesh, source(e, mesh)), q = get(CGAL::vertex_point, mesh, target(e, mesh));
      const double length = std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
      CHECK(std::abs(adapter.to_original_scale(flat.length(flat.edge(i))) - length) <= 1e-15 * length);
    }
  CHECK(int(edges_seen.size()) == flat.number_of_edges());

  // The graph has the edges, by the same numbers.
  const Csr_graph& graph = flat.graph();
  CHECK(graph.number_of_vertices() == flat.number_of_vertices() && graph.number_of_edges() == flat.number_of_edges());
  for(int e = 0; e < flat.number_of_edges(); ++e)
  {
    CHECK(graph.edges[e].source == flat.source(flat.halfedge(e)));
    CHECK(graph.edges[e].target == flat.target(flat.halfedge(e)));
    CHECK(graph.edges[e].weight == flat.length(e));
  }

  CHECK(!adapter.has_diagonals());
  test_maps(mesh, adapter);
}

// One face with four corners: the indexed mesh has its two triangles, and the maps know nothing of its diagonal.
template <typename Mesh>
void test_quad(const Mesh& mesh)
{
  const Adapter<Mesh> adapter = adapt(mesh);
  const Indexed_mesh& flat = adapter.mesh();
  CHECK(adapter.has_diagonals() && flat.number_of_faces() == int(num_faces(mesh)) + 1);
  CHECK(adapter.to_face(flat.number_of_faces() - 1) == adapter.to_face(flat.number_of_faces() - 2));
  int diagonals = 0;
  for(int e = 0; e < flat.number_of_edges(); ++e)
    diagonals += adapter.is_diagonal(e);
  CHECK(diagonals == 1 && flat.number_of_edges() == int(edges(mesh).size()) + 1);

  std::map<typename boost::graph_traits<Mesh>::edge_descriptor, bool> cut_edges;
  const Cut all(flat.number_of_edges(), 1);
  auto cut_map = boost::make_assoc_property_map(cut_edges);
  adapter.write_cut(all, cut_map);
  CHECK(cut_edges.size() == edges(mesh).size());
  const Cut cut = adapter.read_cut(cut_map);
  CHECK(std::count(cut.begin(), cut.end(), 1) == flat.number_of_edges() - 1);
}

template <typename Mesh>
void test_type()
{
  for(Soup soup : {test::torus(5, 4), test::sphere(5, 3), test::tube(4, 2), test::patch(3, 2)})
  {
    const Mesh mesh = test::make_mesh<Mesh>(soup);
    test_copy(mesh);
    const Adapter<Mesh> adapter = adapt(mesh);
    for(int exponent : {-660, 660})
    {
      // Only the scale is different.
      soup.scale(std::ldexp(1., exponent));
      const Mesh scaled_mesh = test::make_mesh<Mesh>(soup);
      const Adapter<Mesh> scaled = adapt(scaled_mesh);
      const Result_status<Mesh> status = check(scaled_mesh);
      CHECK(status && status.warnings.size() == 1 && status.message.empty()); // extreme coordinates
      CHECK(scaled.mesh().points() == adapter.mesh().points());
      CHECK(scaled.to_original_scale(1) == std::ldexp(adapter.to_original_scale(1), exponent));
      soup.scale(std::ldexp(1., -exponent));
    }
  }

  CHECK(check(Mesh()).code == Status_code::EMPTY_MESH);

  Soup soup = test::sphere(5, 3);
  soup.faces.erase(soup.faces.begin(), soup.faces.begin() + 2);
  soup.faces.push_back({1, 0, 4, 5}); // the two triangles as one face
  const Mesh quad = test::make_mesh<Mesh>(soup);
  Result_status<Mesh> status = check(quad);
  CHECK(status);
  test_quad(quad);

  for(double x : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    if(std::is_same<Mesh, test::Polyhedron>::value)
      continue; // exact numbers are always finite
    soup = test::sphere(5, 3);
    soup.points[3][1] = x;
    const Mesh mesh = test::make_mesh<Mesh>(soup);
    status = check(mesh);
    CHECK(status.code == Status_code::INVALID_POINT && status.vertices.size() == 1);
    CHECK(status.vertices.front() == *std::next(vertices(mesh).begin(), 3));
    CHECK(status.message.find(": vertex 3") != std::string::npos);
  }
}

void test_refused()
{
  // Two fans at one vertex, without a common edge.
  Surface_mesh mesh;
  std::vector<Surface_mesh::Vertex_index> v;
  for(int i = 0; i < 5; ++i)
    v.push_back(mesh.add_vertex(Surface_mesh::Point(i, i * i, 0)));
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[0], v[3], v[4]);
  Result_status<Surface_mesh> status = check(mesh);
  CHECK(status.code == Status_code::NON_MANIFOLD && status.vertices == std::vector<Surface_mesh::Vertex_index>{v[0]});

  // A pillow is legal.
  mesh.clear();
  v.clear();
  for(int i = 0; i < 3; ++i)
    v.push_back(mesh.add_vertex(Surface_mesh::Point(i, i * i, 0)));
  const Surface_mesh::Face_index f = mesh.add_face(v[0], v[1], v[2]);
  CHECK(mesh.add_face(v[0], v[2], v[1]) != Surface_mesh::null_face());
  status = check(mesh);
  CHECK(status && status.warnings.empty());

  // A face whose halfedge belongs to another one.
  mesh.set_halfedge(Surface_mesh::Face_index(1), mesh.halfedge(f));
  CHECK(check(mesh).code == Status_code::NOT_TRIANGULATED);

  // A face that uses a vertex twice, and one whose neighbor disagrees about the vertices.
  mesh = test::make_mesh<Surface_mesh>(test::patch(1, 1));
  Surface_mesh::Halfedge_index diagonal;
  for(Surface_mesh::Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(mesh.edge(h)))
      diagonal = h;
  const Surface_mesh::Vertex_index former = mesh.target(diagonal);
  mesh.set_target(diagonal, mesh.source(diagonal));
  CHECK(check(mesh).code == Status_code::NOT_TRIANGULATED);
  mesh.set_target(diagonal, mesh.add_vertex(Surface_mesh::Point(7, 7, 7)));
  CHECK(check(mesh).code == Status_code::NON_MANIFOLD);
  mesh.set_target(diagonal, former);
  CHECK(check(mesh));
}

// Faces given twice need parallel edges, which only index arrays make easily.
void test_faces_given_twice()
{
  std::vector<Point> points;
  std::vector<Triangle> triangles = {{0, 1, 2}, {0, 1, 2}};
  std::vector<int> opposites = {-1, -1, -1, -1, -1, -1};
  const Indexed_mesh twice({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, triangles, opposites);
  CHECK(faces_given_twice(twice) == std::vector<int>({0, 1}));
  triangles[1] = {1, 2, 0};
  CHECK(faces_given_twice(Indexed_mesh(twice.points(), triangles, opposites)) == std::vector<int>({0, 1}));
  triangles[1] = {0, 2, 1};
  CHECK(faces_given_twice(Indexed_mesh(twice.points(), triangles, opposites)).empty());
  CHECK(faces_given_twice(Indexed_mesh(twice.points(), triangles, {5, 4, 3, 2, 1, 0})).empty());
}

void test_warnings()
{
  Soup soup = test::patch(3, 3);
  soup.points[6] = soup.points[5];
  Surface_mesh mesh = test::make_mesh<Surface_mesh>(soup);
  const Surface_mesh::Vertex_index isolated = mesh.add_vertex(Surface_mesh::Point(1e300, 0, 0));
  const Result_status<Surface_mesh> status = check(mesh);
  CHECK(status && status.message.empty());
  CHECK(status.warnings.size() == 4);
  CHECK(status.warnings[0].vertices == std::vector<Surface_mesh::Vertex_index>{isolated});
  CHECK(status.warnings[1].edges.size() == 1);
  const Surface_mesh::Edge_index e = status.warnings[1].edges.front();
  CHECK(mesh.point(mesh.vertex(e, 0)) == mesh.point(mesh.vertex(e, 1)));
  CHECK(status.warnings[1].message.find("5-6") != std::string::npos ||
        status.warnings[1].message.find("6-5") != std::string::npos);
  CHECK(status.warnings[2].faces.size() == 2);
  CHECK(status.warnings[3].vertices.size() == 2);

  // Many elements are counted, not listed.
  mesh = test::make_mesh<Surface_mesh>(test::patch(3, 3));
  for(int i = 0; i < 8; ++i)
    mesh.add_vertex(Surface_mesh::Point(0, 0, 0));
  const Result_status<Surface_mesh> many = check(mesh);
  CHECK(many.warnings.size() == 1 && many.warnings[0].vertices.size() == 8);
  CHECK(many.warnings[0].message.find("16, 17, 18, 19, 20 and 3 more") != std::string::npos);

  // An open seam.
  soup = test::patch(2, 2);
  for(int j = 0; j < 3; ++j)
    soup.points[6 + j] = {0., double(j), 5.};
  for(int j = 0; j < 3; ++j)
    soup.points[j] = {0., double(j), 5.};
  const Result_status<Surface_mesh> seam = check(test::make_mesh<Surface_mesh>(soup));
  CHECK(seam && seam.warnings.size() == 1 && seam.warnings[0].vertices.size() == 6);
}

void test_components()
{
  // Each with its topology; the mesh also has an isolated vertex.
  const std::vector<Soup> soups = {test::torus(4, 5), test::patch(2, 3), test::sphere(4, 2), test::tube(5, 1)};
  const std::vector<std::array<int, 3> > expected = {{0, 0, 1}, {1, 1, 0}, {2, 0, 0}, {0, 2, 0}};
  Soup all;
  for(const Soup& soup : soups)
    all.add(soup);
  Surface_mesh mesh = test::make_mesh<Surface_mesh>(all);
  mesh.add_vertex(Surface_mesh::Point(0, 0, 0));
  const Indexed_mesh whole = adapt(mesh).mesh();
  const std::vector<Indexed_component> components = split_into_components(whole);
  CHECK(components.size() == soups.size());
  int vertices = 0, edges = 0, faces = 0;
  Cut cut(whole.number_of_edges(), 0);
  for(std::size_t i = 0; i < components.size(); ++i)
  {
    const Indexed_component& c = components[i];
    CHECK(c.topology.euler_characteristic == expected[i][0]);
    CHECK(c.topology.border_loops == expected[i][1]);
    CHECK(c.topology.genus() == expected[i][2]);
    const Indexed_mesh& m = c.mesh;
    CHECK(m.number_of_vertices() - m.number_of_edges() + m.number_of_faces() == expected[i][0]);
    vertices += m.number_of_vertices();
    edges += m.number_of_edges();
    faces += m.number_of_faces();
    for(int h = 0; h < m.number_of_halfedges(); ++h)
    {
      const int in_whole = 3 * c.faces[h / 3] + h % 3;
      CHECK(whole.source(in_whole) == c.vertices[m.source(h)]);
      CHECK(whole.edge(in_whole) == c.edges[m.edge(h)]);
      CHECK(m.is_border(h) ? whole.is_border(in_whole)
                           : whole.opposite(in_whole) == 3 * c.faces[m.opposite(h) / 3] + m.opposite(h) % 3);
      CHECK(m.point(m.source(h)) == whole.point(whole.source(in_whole)));
    }
    const Cut all_edges(m.number_of_edges(), 1);
    c.add_to(all_edges, cut);
    CHECK(c.restriction(cut) == all_edges);
    const Indexed_status status = c.in_whole(Indexed_status(Status_code::NOT_CERTIFIED, "", Element_kind::FACE, {0}));
    CHECK(status.finding.indices == std::vector<int>{c.faces[0]});
  }
  CHECK(std::count(cut.begin(), cut.end(), 0) == 0);
  CHECK(vertices == whole.number_of_vertices() - 1 && edges == whole.number_of_edges() && faces == whole.number_of_faces());

  // A single component is the mesh itself.
  const Indexed_mesh sphere = adapt(test::make_mesh<Surface_mesh>(test::sphere(4, 2))).mesh();
  const std::vector<Indexed_component> one = split_into_components(sphere);
  CHECK(one.size() == 1 && one[0].mesh.triangles() == sphere.triangles() && one[0].topology.euler_characteristic == 2);
  CHECK(one[0].vertices.size() == sphere.points().size() && one[0].edges.back() == sphere.number_of_edges() - 1);
}

} // namespace mesh_adapter_test

int main()
{
  using namespace mesh_adapter_test;
  test_type<Surface_mesh>();
  test_type<test::Polyhedron>();
  test_type<test::Linear_cell_complex>();
  for(const Soup& soup : {test::torus(5, 4), test::tube(4, 2)})
  {
    const Surface_mesh mesh = test::make_mesh_with_garbage(soup);
    CHECK(mesh.has_garbage());
    test_copy(mesh);
    CHECK(adapt(mesh).mesh().number_of_faces() == int(soup.faces.size()));
  }
  test_refused();
  test_faces_given_twice();
  test_warnings();
  test_components();
  return test::exit_status();
}
