// Surfaces in the plane, as the program unwrap writes them.

#ifndef SURFACE_MESH_PARAMETERIZATION_BENCHMARK_LAYOUT_H
#define SURFACE_MESH_PARAMETERIZATION_BENCHMARK_LAYOUT_H

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>

#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

struct Layout
{
  std::vector<Eigen::Vector2d> uv;
  std::vector<Eigen::Vector3d> points; // where the vertices of the layout are on the surface
  std::vector<CGAL::Surface_mesh_parameterization::internal::Triangle> triangles;
};

// From an OBJ file of polygons with texture coordinates, as fans of triangles. It keeps the orientation of the input's
// faces, and the layout that of the surface.
inline Layout read_layout(const std::string& name)
{
  using CGAL::Surface_mesh_parameterization::internal::triangle_area;
  Layout layout;
  std::vector<Eigen::Vector3d> vertices;
  std::ifstream file(name);
  for(std::string line, key; std::getline(file, line);)
  {
    std::istringstream words(line);
    words >> key;
    if(key == "v")
    {
      Eigen::Vector3d& p = vertices.emplace_back();
      words >> p.x() >> p.y() >> p.z();
    }
    else if(key == "vt")
    {
      Eigen::Vector2d& p = layout.uv.emplace_back();
      words >> p.x() >> p.y();
    }
    else if(key == "f")
    {
      layout.points.resize(layout.uv.size());
      std::vector<int> corners;
      char slash;
      for(int vertex, corner; words >> vertex >> slash >> corner; words.ignore(line.size(), ' '))
      {
        corners.push_back(corner - 1);
        layout.points[corner - 1] = vertices[vertex - 1];
      }
      const std::size_t first = layout.triangles.size();
      double area = 0;
      for(std::size_t k = 2; k < corners.size(); ++k)
      {
        layout.triangles.push_back({corners[0], corners[k - 1], corners[k]});
        area += triangle_area(layout.triangles.back(), layout.uv);
      }
      for(std::size_t t = first; t < layout.triangles.size() && area < 0; ++t)
        std::swap(layout.triangles[t][1], layout.triangles[t][2]);
    }
  }
  return layout;
}

#endif // SURFACE_MESH_PARAMETERIZATION_BENCHMARK_LAYOUT_H
