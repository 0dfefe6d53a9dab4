// Surfaces in the plane, as the program unwrap writes them.

#ifndef SURFACE_MESH_PARAMETERIZATION_BENCHMARK_LAYOUT_H
#define SURFACE_MESH_PARAMETERIZATION_BENCHMARK_LAYOUT_H

#include <CGAL/Surface_mesh_parameterization/internal/chart/areas.h>

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

// From an OBJ file of triangles with texture coordinates. It keeps the orientation of the input's faces, and the layout
// that of the surface.
inline Layout read_layout(const std::string& name)
{
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
      auto& t = layout.triangles.emplace_back();
      for(int& corner : t)
      {
        int vertex;
        char slash;
        words >> vertex >> slash >> corner;
        layout.points[--corner] = vertices[vertex - 1];
        words.ignore(line.size(), ' ');
      }
      if(CGAL::Surface_mesh_parameterization::internal::triangle_area(t, layout.uv) < 0)
        std::swap(t[1], t[2]);
    }
  }
  return layout;
}

#endif // SURFACE_MESH_PARAMETERIZATION_BENCHMARK_LAYOUT_H
