// Writes triangulations of one closed shape, as in the paper's Figures 12 and 13:
//
//   make_triangulations MESH FOLDER
//
// source (isotropic, about 13,000 triangles), sparse (2,000), dense (50,000), noisy (the source, each
// vertex moved at random), isotropic (another resolution), anisotropic (isotropic for a stretched
// shape), uneven (one half much finer than the other).

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Kernel::Point_3                     Point;
typedef Kernel::Vector_3                    Vector;

namespace PMP = CGAL::Polygon_mesh_processing;

// Equilateral triangles of this edge length cover the area.
double edge_length(const Mesh& mesh, int number_of_faces)
{
  return std::sqrt(4 / std::sqrt(3.) * PMP::area(mesh) / number_of_faces);
}

Mesh remeshed(Mesh mesh, int number_of_faces)
{
  PMP::isotropic_remeshing(faces(mesh), edge_length(mesh, number_of_faces), mesh,
                           CGAL::parameters::number_of_iterations(5));
  mesh.collect_garbage();
  return mesh;
}

Mesh noisy(Mesh mesh)
{
  constexpr double amplitude = 0.15; // of the edge length
  const double size = amplitude * edge_length(mesh, int(num_faces(mesh)));
  CGAL::Random random(0);
  for(auto v : vertices(mesh))
  {
    const double x = random.get_double(-size, size), y = random.get_double(-size, size);
    mesh.point(v) += Vector(x, y, random.get_double(-size, size));
  }
  return mesh;
}

Mesh scaled(Mesh mesh, double factor)
{
  for(auto v : vertices(mesh))
    mesh.point(v) = Point(factor * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  return mesh;
}

Mesh anisotropic(const Mesh& mesh, int number_of_faces)
{
  constexpr double stretch = 4;
  return scaled(remeshed(scaled(mesh, stretch), number_of_faces), 1 / stretch);
}

Mesh uneven(Mesh mesh, int number_of_faces)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  std::vector<Mesh::Face_index> half;
  for(auto f : faces(mesh))
    if(mesh.point(target(halfedge(f, mesh), mesh)).x() > (box.xmin() + box.xmax()) / 2)
      half.push_back(f);
  PMP::isotropic_remeshing(half, edge_length(mesh, number_of_faces), mesh, CGAL::parameters::number_of_iterations(5));
  mesh.collect_garbage();
  return mesh;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if(argc != 3 || !PMP::IO::read_polygon_mesh(argv[1], mesh) || !is_triangle_mesh(mesh) || !is_closed(mesh))
  {
    std::cerr << "usage: " << argv[0] << " MESH FOLDER; the mesh has to be closed" << std::endl;
    return EXIT_FAILURE;
  }
  const std::filesystem::path folder = argv[2];
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& name, const Mesh& result)
  {
    CGAL::IO::write_polygon_mesh((folder / (name + ".off")).string(), result,
                                 CGAL::parameters::stream_precision(17));
  };
  const Mesh source = remeshed(mesh, 13000);
  write("source", source);
  write("sparse", remeshed(source, 2000));
  write("dense", remeshed(source, 50000));
  write("noisy", noisy(source));
  write("isotropic", remeshed(source, 10000));
  write("anisotropic", anisotropic(source, 20000));
  write("uneven", uneven(remeshed(source, 4000), 50000));
  return EXIT_SUCCESS;
}
