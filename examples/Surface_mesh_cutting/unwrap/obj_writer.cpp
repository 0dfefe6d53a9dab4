#include "obj_writer.h"

#include "Number_writer.h"
#include "texture.h"

#include <algorithm>

namespace {

void write_point(const std::array<double, 3>& point, Number_writer& out)
{
  out << "v " << point[0] << " " << point[1] << " " << point[2] << "\n";
}

} // namespace

std::string to_obj(const Layout& layout, const std::string& material_file)
{
  Number_writer out;
  if(!material_file.empty())
    out << "mtllib " << material_file << "\n";
  for(const auto& point : layout.points)
    write_point(point, out);
  for(const auto& uv : layout.uv_points)
    out << "vt " << uv[0] << " " << uv[1] << "\n";
  if(!material_file.empty())
    out << "usemtl " << material_name << "\n";
  std::size_t corner = 0;
  for(const std::size_t end : layout.polygon_ends)
  {
    out << "f";
    for(; corner < end; ++corner)
      out << " " << layout.corners[corner] + 1 << "/" << layout.corner_uvs[corner] + 1;
    out << "\n";
  }
  return out.text();
}

std::string cut_to_obj(const Layout& layout)
{
  std::vector<int> vertices = layout.feature_points;
  for(const Layout::Edge& edge : layout.cut)
    vertices.insert(vertices.end(), edge.begin(), edge.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto position = [&](int vertex)
  { return int(std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin()); };

  Number_writer out;
  for(const int vertex : vertices)
    write_point(layout.points[std::size_t(vertex)], out);
  for(const Layout::Edge& edge : layout.cut)
    out << "l " << position(edge[0]) + 1 << " " << position(edge[1]) + 1 << "\n";
  for(const int vertex : layout.feature_points)
    out << "p " << position(vertex) + 1 << "\n";
  return out.text();
}
