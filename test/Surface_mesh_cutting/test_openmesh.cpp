// The method on meshes of OpenMesh, with constraints and with removed elements, which stay as they are.

#include "../BGL/check.h"
#include "surface_meshes.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <iostream>
#include <vector>

namespace openmesh_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

// The faces from `first_removed` on are removed, with the vertices and edges that only they use.
template <typename Mesh>
Mesh make_open_mesh(const test::Soup& soup, std::size_t first_removed)
{
  Mesh mesh;
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_halfedge_status();
  mesh.request_face_status();
  std::vector<typename Mesh::VertexHandle> vertices;
  for(const std::array<double, 3>& p : soup.points)
    vertices.push_back(mesh.add_vertex(typename Mesh::Point(p[0], p[1], p[2])));
  std::vector<typename Mesh::FaceHandle> faces;
  for(const std::vector<std::size_t>& f : soup.faces)
    faces.push_back(mesh.add_face(vertices[f[0]], vertices[f[1]], vertices[f[2]]));
  for(std::size_t f = first_removed; f < faces.size(); ++f)
    mesh.delete_face(faces[f], true);
  return mesh;
}

// All that a mesh holds, removed elements included.
template <typename Mesh>
std::vector<double> contents(const Mesh& mesh)
{
  std::vector<double> all;
  for(auto v = mesh.vertices_begin(); v != mesh.vertices_end(); ++v)
  {
    for(int i = 0; i < 3; ++i)
      all.push_back(mesh.point(*v)[i]);
    all.push_back(mesh.status(*v).bits());
  }
  for(auto h = mesh.halfedges_begin(); h != mesh.halfedges_end(); ++h)
  {
    all.push_back(mesh.to_vertex_handle(*h).idx());
    all.push_back(mesh.next_halfedge_handle(*h).idx());
    all.push_back(mesh.face_handle(*h).idx());
    all.push_back(mesh.status(*h).bits());
  }
  for(auto f = mesh.faces_begin(); f != mesh.faces_end(); ++f)
    all.push_back(mesh.status(*f).bits());
  return all;
}

template <typename Mesh>
void test_mesh(const test::Soup& soup, std::size_t first_removed)
{
  Mesh mesh = make_open_mesh<Mesh>(soup, first_removed);
  auto is_cut = get(CGAL::dynamic_edge_property_t<char>(), mesh); // CGAL's bool does not compile
  auto must_be_cut = get(CGAL::dynamic_edge_property_t<char>(), mesh);
  auto uv = get(CGAL::dynamic_halfedge_property_t<Point_2>(), mesh);
  int i = 0;
  for(auto e : edges(mesh))
    put(must_be_cut, e, i++ % 50 == 7);
  const std::vector<double> before = contents(mesh);
  const auto result
    = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::edge_is_constrained_map(must_be_cut));
  CHECK(result, result.status.message.c_str());
  CHECK(result.components == 1 && result.genus == 0 && result.borders == 0, "topology");
  CHECK(SMC::certify_unwrap(mesh, is_cut, uv), "certificate");
  for(auto e : edges(mesh))
    CHECK(!get(must_be_cut, e) || get(is_cut, e), "an edge that must be cut");
  CHECK(contents(mesh) == before, "the mesh is as it was");
}

struct Double_traits : public OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
};

} // namespace openmesh_test

int main()
{
  using namespace openmesh_test;
  test::Soup soup = test::sphere(16, 11);
  const std::size_t number_of_faces = soup.faces.size();
  soup.add(test::patch(3, 3));
  test_mesh<OpenMesh::TriMesh_ArrayKernelT<Double_traits> >(soup, number_of_faces);
  test_mesh<OpenMesh::PolyMesh_ArrayKernelT<> >(soup, number_of_faces);
  return test::exit_status();
}
