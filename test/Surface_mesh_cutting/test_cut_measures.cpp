// Seam meshes, lengths, disks and certificates through the public functions, on meshes of all types.

#include "../BGL/check.h"
#include "test_meshes.h" // `Seam_mesh` needs the mesh types to be known

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/cut_length.h>
#include <CGAL/Surface_mesh_cutting/is_cut_to_disks.h>
#include <CGAL/Surface_mesh_cutting/make_seam_mesh.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace cut_measures_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Result_status;
using SMC::Status_code;
using test::Soup;
using Point_2 = test::Inexact_kernel::Point_2;

template <typename Mesh>
class Test
{
  using Graph_traits = boost::graph_traits<Mesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using edge_descriptor = typename Graph_traits::edge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Cut_map = typename boost::property_map<Mesh, CGAL::dynamic_edge_property_t<bool> >::const_type;

  const Mesh& mesh;
  Cut_map cut;
  std::map<face_descriptor, int> component; // without what is cut
  int number_of_components = 0;

  void flood()
  {
    component.clear();
    number_of_components = 0;
    for(face_descriptor seed : faces(mesh))
    {
      if(component.count(seed))
        continue;
      std::vector<face_descriptor> stack(1, seed);
      component[seed] = number_of_components;
      while(!stack.empty())
      {
        const face_descriptor f = stack.back();
        stack.pop_back();
        for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
        {
          const face_descriptor g = face(opposite(h, mesh), mesh);
          if(g != Graph_traits::null_face() && !get(cut, edge(h, mesh)) &&
             component.emplace(g, number_of_components).second)
            stack.push_back(g);
        }
      }
      ++number_of_components;
    }
  }

  // The corners at a vertex fall into one fan per open edge, into one if there is at most one.
  std::size_t fans(vertex_descriptor v) const
  {
    std::size_t open = 0, outside = 0;
    for(halfedge_descriptor h : CGAL::halfedges_around_target(v, mesh))
    {
      open += get(cut, edge(h, mesh)) || is_border(edge(h, mesh), mesh);
      outside += is_border(h, mesh);
    }
    return (std::max)(std::size_t(1), open - outside);
  }

  void seam_mesh() const
  {
    std::set<vertex_descriptor> ends;
    std::size_t seams = 0, number_of_vertices = 0;
    for(edge_descriptor e : edges(mesh))
      if(get(cut, e) && !is_border(e, mesh))
      {
        ++seams;
        ends.insert(source(e, mesh));
        ends.insert(target(e, mesh));
      }
    for(vertex_descriptor v : vertices(mesh))
      number_of_vertices += fans(v);

    const auto check = [&](const auto& seam_mesh)
    {
      CHECK(seam_mesh.number_of_seam_edges() == seams);
      CHECK(seam_mesh.num_edges() == num_edges(mesh) + seams);
      CHECK(seam_mesh.num_halfedges() == num_halfedges(mesh) + 2 * seams);
      CHECK(std::size_t(std::distance(halfedges(seam_mesh).begin(), halfedges(seam_mesh).end()))
            == std::size_t(std::distance(halfedges(mesh).begin(), halfedges(mesh).end())) + 2 * seams);
      CHECK(seam_mesh.num_vertices() == number_of_vertices);
      for(edge_descriptor e : edges(mesh))
        CHECK(seam_mesh.has_on_seam(halfedge(e, mesh)) == (get(cut, e) && !is_border(e, mesh)));
      for(vertex_descriptor v : vertices(mesh))
        CHECK(seam_mesh.has_on_seam(v) == (ends.count(v) != 0));
    };
    check(SMC::make_seam_mesh(mesh, cut));
    // Maps that are filled already, and the same map twice.
    auto edge_map = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
    auto vertex_map = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
    for(edge_descriptor e : edges(mesh))
      put(edge_map, e, true);
    for(vertex_descriptor v : vertices(mesh))
      put(vertex_map, v, true);
    check(SMC::make_seam_mesh(mesh, cut, edge_map, vertex_map));
    for(edge_descriptor e : edges(mesh))
      put(edge_map, e, bool(get(cut, e)));
    check(SMC::make_seam_mesh(mesh, edge_map, edge_map, vertex_map));
  }

  void length() const
  {
    double expected = 0;
    for(edge_descriptor e : edges(mesh))
      if(get(cut, e) && !is_border(e, mesh))
        expected += std::sqrt(CGAL::to_double(CGAL::squared_distance(
          get(CGAL::vertex_point, mesh, source(e, mesh)), get(CGAL::vertex_point, mesh, target(e, mesh)))));
    CHECK(std::abs(SMC::cut_length(mesh, cut) - expected) <= 1e-12 * expected);
    // At another place and scale, where squares overflow.
    std::map<vertex_descriptor, test::Inexact_kernel::Point_3> points;
    for(vertex_descriptor v : vertices(mesh))
    {
      const auto p = get(CGAL::vertex_point, mesh, v);
      points[v] = test::Inexact_kernel::Point_3(1e200 * CGAL::to_double(p.x()), 1e200 * CGAL::to_double(p.y()),
                                                1e200 * CGAL::to_double(p.z()));
    }
    const double scaled = SMC::cut_length(mesh, cut, CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(points)));
    CHECK(std::abs(scaled - 1e200 * expected) <= 1e188 * expected);
  }

  // Euler characteristic of each part by counting.
  void disks()
  {
    std::vector<int> characteristic(number_of_components, 0);
    // On a border there are as many vertices as edges, so only the inner ones count.
    for(face_descriptor f : faces(mesh))
      ++characteristic[component.at(f)];
    for(edge_descriptor e : edges(mesh))
      if(!get(cut, e) && !is_border(e, mesh))
        --characteristic[component.at(face(halfedge(e, mesh), mesh))];
    for(vertex_descriptor v : vertices(mesh))
    {
      bool is_inner = true;
      for(halfedge_descriptor h : CGAL::halfedges_around_target(v, mesh))
        is_inner = is_inner && !get(cut, edge(h, mesh)) && !is_border(edge(h, mesh), mesh);
      if(is_inner)
        ++characteristic[component.at(face(halfedge(v, mesh), mesh))];
    }
    const bool expected = std::all_of(characteristic.begin(), characteristic.end(), [](int c) { return c == 1; });
    const Result_status<Mesh> status = SMC::certify_cut(mesh, cut);
    CHECK(SMC::is_cut_to_disks(mesh, cut) == bool(status));
    CHECK(bool(status) == expected);
    if(expected)
      return;
    CHECK(status.code == Status_code::NOT_CUT_TO_DISKS && !status.message.empty());
    const int part = component.at(status.faces.front());
    CHECK(characteristic[part] != 1);
    std::size_t size = 0;
    for(const auto& entry : component)
      size += entry.second == part;
    CHECK(status.faces.size() == size);
    for(face_descriptor f : status.faces)
      CHECK(component.at(f) == part);
  }

public:
  explicit Test(const Mesh& mesh) : mesh(mesh), cut(get(CGAL::dynamic_edge_property_t<bool>(), mesh)) {}

  void random_cuts(CGAL::Random& random)
  {
    for(int i = 0; i < 30; ++i)
    {
      // From few edges to all.
      const double density = i == 29 ? 1 : random.get_double();
      for(edge_descriptor e : edges(mesh))
        put(cut, e, random.get_double() < density);
      flood();
      seam_mesh();
      length();
      disks();
    }
  }

  // Each triangle is a chart of its own, side by side.
  void certificate()
  {
    for(edge_descriptor e : edges(mesh))
      put(cut, e, true);
    std::map<halfedge_descriptor, Point_2> uv;
    auto uv_map = boost::make_assoc_property_map(uv);
    double x = 0;
    for(face_descriptor f : faces(mesh))
    {
      const halfedge_descriptor h = halfedge(f, mesh);
      uv[h] = Point_2(x, 0);
      uv[next(h, mesh)] = Point_2(x + 1, 0);
      uv[prev(h, mesh)] = Point_2(x, 1);
      x += 1;
    }
    const auto bijective = CGAL::parameters::do_bijective(true);
    CHECK(SMC::certify_unwrap(mesh, cut, uv_map, bijective));
    CHECK(SMC::certify_unwrap(mesh, cut, uv_map, CGAL::parameters::do_bijective(false)));

    // One step of double precision to the left.
    const face_descriptor last = *std::prev(faces(mesh).end());
    const halfedge_descriptor h = halfedge(last, mesh);
    const Point_2 former = uv[h];
    uv[h] = Point_2(std::nextafter(former.x(), 0.), 0);
    CHECK(SMC::certify_unwrap(mesh, cut, uv_map));
    Result_status<Mesh> status = SMC::certify_unwrap(mesh, cut, uv_map, bijective);
    CHECK(status.code == Status_code::NOT_CERTIFIED && status.faces.size() == 2 && status.faces.back() == last);

    uv[h] = Point_2(former.x(), 1);
    status = SMC::certify_unwrap(mesh, cut, uv_map);
    CHECK(status.code == Status_code::NOT_CERTIFIED && status.faces == std::vector<face_descriptor>{last});
    uv[h] = Point_2(std::numeric_limits<double>::quiet_NaN(), 1);
    status = SMC::certify_unwrap(mesh, cut, uv_map, bijective);
    CHECK(status.code == Status_code::NOT_CERTIFIED && status.faces == std::vector<face_descriptor>{last});
    uv[h] = former;

    // Where no edge is cut, neighbors have to agree.
    for(edge_descriptor e : edges(mesh))
      if(!is_border(e, mesh))
      {
        put(cut, e, false);
        status = SMC::certify_unwrap(mesh, cut, uv_map);
        CHECK(status.code == Status_code::NOT_CERTIFIED && status.faces.size() <= 2);
        break;
      }
    for(edge_descriptor e : edges(mesh))
      put(cut, e, false);
    status = SMC::certify_unwrap(mesh, cut, uv_map);
    CHECK(status.code == Status_code::NOT_CUT_TO_DISKS);
  }
};

template <typename Mesh>
void test_type(CGAL::Random& random)
{
  for(const Soup& soup : {test::torus(4, 5), test::sphere(4, 2), test::tube(5, 2)})
  {
    const Mesh mesh = test::make_mesh<Mesh>(soup);
    Test<Mesh> t(mesh);
    t.random_cuts(random);
    t.certificate();
  }
  // What is refused is refused everywhere.
  const Mesh empty;
  auto cut = get(CGAL::dynamic_edge_property_t<bool>(), empty);
  auto uv = get(CGAL::dynamic_halfedge_property_t<Point_2>(), empty);
  CHECK(SMC::certify_cut(empty, cut).code == Status_code::EMPTY_MESH);
  CHECK(SMC::certify_unwrap(empty, cut, uv).code == Status_code::EMPTY_MESH);
  CHECK(SMC::cut_length(empty, cut) == 0);
}

} // namespace cut_measures_test

int main()
{
  using namespace cut_measures_test;
  CGAL::Random random(4);
  test_type<test::Surface_mesh>(random);
  test_type<test::Polyhedron>(random);
  test_type<test::Linear_cell_complex>(random);

  Soup two = test::torus(4, 5);
  two.add(test::patch(3, 3));
  const test::Surface_mesh mesh = test::make_mesh_with_garbage(two);
  CHECK(mesh.has_garbage());
  Test<test::Surface_mesh> t(mesh);
  t.random_cuts(random);
  return test::exit_status();
}
