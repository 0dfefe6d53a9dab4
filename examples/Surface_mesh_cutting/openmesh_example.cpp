#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <boost/property_map/property_map.hpp>

#include <iostream>
#include <map>
#include <string>

typedef CGAL::Simple_cartesian<double>  Kernel;
typedef OpenMesh::TriMesh_ArrayKernelT<> Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef std::map<edge_descriptor, bool>                Edge_marks;
typedef std::map<halfedge_descriptor, Kernel::Point_2> UVs;

namespace SMC = CGAL::Surface_mesh_cutting;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Mesh mesh;
  if(!OpenMesh::IO::read_mesh(mesh, filename))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Edge_marks marks;
  UVs uvs;
  const SMC::Unwrap_result<Mesh> result = SMC::unwrap(mesh, boost::associative_property_map<Edge_marks>(marks),
                                                      boost::associative_property_map<UVs>(uvs));
  if(!result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }

  // OpenMesh keeps texture coordinates at halfedges, too.
  mesh.request_halfedge_texcoords2D();
  for(const auto& corner : uvs)
    mesh.set_texcoord2D(corner.first, Mesh::TexCoord2D(float(corner.second.x()), float(corner.second.y())));
  std::cout << "a cut through " << result.feature_points.size() << " feature points, mean energy " << result.average_distortion
            << std::endl;
  return EXIT_SUCCESS;
}
