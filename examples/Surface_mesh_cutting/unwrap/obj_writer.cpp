#include "obj_writer.h"

#include "Number_writer.h"
#include "texture.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace {

void write_point(const std::array<double, 3>& point, std::string_view end, Number_writer& out)
{
  out << "v " << point[0] << " " << point[1] << " " << point[2] << end << "\n";
}

void write_points(const Layout& layout, Number_writer& out)
{
  const std::vector<std::string>& ends = layout.obj_statements.point_ends;
  for(std::size_t v = 0; v < layout.points.size(); ++v)
  {
    Number_writer color;
    if(ends.empty() && !layout.colors.empty())
      for(const double channel : layout.colors[v])
        color << " " << channel;
    write_point(layout.points[v], ends.empty() ? color.text() : ends[v], out);
  }
}

void write_polygons(const Layout& layout, bool has_own_material, Number_writer& out)
{
  const Obj_statements& statements = layout.obj_statements;
  std::size_t corner = 0;
  auto line = statements.lines.begin();
  const auto write_lines_before = [&](int polygon)
  {
    for(; line != statements.lines.end() && line->polygon <= polygon; ++line)
      if(!has_own_material || (line->text.rfind("usemtl", 0) != 0 && line->text.rfind("mtllib", 0) != 0))
        out << line->text << "\n";
  };
  for(std::size_t polygon = 0; polygon < layout.polygon_ends.size(); ++polygon)
  {
    write_lines_before(int(polygon));
    out << "f";
    for(; corner < layout.polygon_ends[polygon]; ++corner)
    {
      out << " " << layout.corners[corner] + 1 << "/" << layout.corner_uvs[corner] + 1;
      if(!layout.corner_normals.empty() && layout.corner_normals[corner] >= 0)
        out << "/" << layout.corner_normals[corner] + 1;
    }
    out << "\n";
  }
  write_lines_before(int(layout.polygon_ends.size()));
}

} // namespace

std::string to_obj(const Layout& layout, const std::string& material_file)
{
  Number_writer out;
  if(!material_file.empty())
    out << "mtllib " << material_file << "\n";
  write_points(layout, out);
  for(const auto& uv : layout.uv_points)
    out << "vt " << uv[0] << " " << uv[1] << "\n";
  for(const std::array<double, 3>& normal : layout.normals)
    out << "vn " << normal[0] << " " << normal[1] << " " << normal[2] << "\n";
  if(!material_file.empty())
    out << "usemtl " << material_name << "\n";
  write_polygons(layout, !material_file.empty(), out);
  return std::move(out).text();
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
    write_point(layout.points[std::size_t(vertex)], "", out);
  for(const Layout::Edge& edge : layout.cut)
    out << "l " << position(edge[0]) + 1 << " " << position(edge[1]) + 1 << "\n";
  for(const int vertex : layout.feature_points)
    out << "p " << position(vertex) + 1 << "\n";
  return std::move(out).text();
}
