#include "obj_writer.h"

#include "Number_writer.h"
#include "texture.h"
#include "write_in_blocks.h"

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
  write_in_blocks(layout.points.size(), [&](std::size_t begin, std::size_t end, Number_writer& block)
  {
    for(std::size_t v = begin; v < end; ++v)
    {
      Number_writer color;
      if(ends.empty() && !layout.colors.empty())
        for(const double channel : layout.colors[v])
          color << " " << channel;
      write_point(layout.points[v], ends.empty() ? color.text() : ends[v], block);
    }
  }, out);
}

void write_uvs(const Layout& layout, Number_writer& out)
{
  write_in_blocks(layout.uv_points.size(), [&](std::size_t begin, std::size_t end, Number_writer& block)
  {
    for(std::size_t v = begin; v < end; ++v)
    {
      const std::array<double, 2> uv = layout.written_uv(v);
      block << "vt " << uv[0] << " " << uv[1] << "\n";
    }
  }, out);
}

void write_polygon(const Layout& layout, std::size_t polygon, Number_writer& out)
{
  out << "f";
  for(std::size_t corner = polygon == 0 ? 0 : layout.polygon_ends[polygon - 1]; corner < layout.polygon_ends[polygon];
      ++corner)
  {
    out << " " << layout.corners[corner] + 1 << "/" << layout.corner_uvs[corner] + 1;
    if(!layout.corner_normals.empty() && layout.corner_normals[corner] >= 0)
      out << "/" << layout.corner_normals[corner] + 1;
  }
  out << "\n";
}

// A backslash at the end would join the next line; an empty one does no harm.
void write_line(const std::string& text, Number_writer& out)
{
  out << text << (text.back() == '\\' ? "\n\n" : "\n");
}

void write_polygons(const Layout& layout, bool has_own_material, Number_writer& out)
{
  using Line = Obj_statements::Line;
  const std::vector<Line>& lines = layout.obj_statements.lines;
  const auto first_line_from = [&](std::size_t polygon)
  {
    return std::partition_point(lines.begin(), lines.end(),
                                [&](const Line& line) { return line.polygon < int(polygon); });
  };
  const auto write_statement = [&](const Line& line, Number_writer& block)
  {
    if(!has_own_material || (line.text.rfind("usemtl", 0) != 0 && line.text.rfind("mtllib", 0) != 0))
      write_line(line.text, block);
  };
  const std::size_t size = layout.polygon_ends.size();
  write_in_blocks(size, [&](std::size_t begin, std::size_t end, Number_writer& block)
  {
    auto line = first_line_from(begin);
    for(std::size_t polygon = begin; polygon < end; ++polygon)
    {
      for(; line != lines.end() && line->polygon <= int(polygon); ++line)
        write_statement(*line, block);
      write_polygon(layout, polygon, block);
    }
  }, out);
  for(auto line = first_line_from(size); line != lines.end(); ++line)
    write_statement(*line, out);
}

} // namespace

std::string to_obj(const Layout& layout, const std::string& material_file)
{
  Number_writer out;
  for(const Obj_statements::Line& line : layout.obj_statements.lines)
    if(line.polygon < 0)
      write_line(line.text, out);
  if(!material_file.empty())
    out << "mtllib " << material_file << "\n";
  write_points(layout, out);
  write_uvs(layout, out);
  for(const std::array<double, 3>& normal : layout.normals)
    out << "vn " << normal[0] << " " << normal[1] << " " << normal[2] << "\n";
  if(!material_file.empty())
    out << "usemtl " << material_name << "\n";
  write_polygons(layout, !material_file.empty(), out);
  return std::move(out).text();
}

Data_kinds kinds_in_obj(const Layout& layout, bool has_own_material)
{
  Data_kinds kinds = {Data_kind::NORMALS, Data_kind::GROUPS, Data_kind::SMOOTHING_GROUPS, Data_kind::LINES,
                      Data_kind::POINTS, Data_kind::CURVES_AND_SURFACES, Data_kind::POINT_WEIGHTS,
                      Data_kind::DISPLAY_SETTINGS, Data_kind::UNKNOWN_STATEMENTS, Data_kind::COMMENTS};
  if(!has_own_material)
    kinds.insert({Data_kind::MATERIALS, Data_kind::MATERIAL_FILES});
  if(!layout.colors.empty() || !layout.obj_statements.point_ends.empty())
    kinds.insert(Data_kind::COLORS);
  if(!layout.obj_statements.point_ends.empty())
    kinds.insert(Data_kind::TRANSPARENCY);
  return kinds;
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
