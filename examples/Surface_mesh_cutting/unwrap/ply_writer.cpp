#include "ply_writer.h"

#include "Number_writer.h"
#include "Ply_source.h"
#include "byte_order.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

std::string texture_property(const Layout& layout)
{
  return "property list uint double " + Ply_header::name_of_uvs(layout.uv_set);
}

// The number of the texture of each polygon, where pages lie on top of each other, as VCG's programs know it.
const std::string& page_property()
{
  static const std::string line = "property int texnumber";
  return line;
}

bool has_page_numbers(const Layout& layout) { return !layout.page_corners.empty(); }

std::string image_comment(const std::string& image)
{
  return "comment " + std::string(Ply_header::image_comment) + " " + image; // as viewers know it
}

// Calls `visit(x)` for the coordinates of the corners of a polygon.
template <typename Visit>
void for_each_coordinate(const Layout& layout, std::size_t polygon, Visit visit)
{
  for(std::size_t corner = polygon == 0 ? 0 : layout.polygon_ends[polygon - 1]; corner < layout.polygon_ends[polygon];
      ++corner)
    for(const double x : layout.written_uv(std::size_t(layout.corner_uvs[corner])))
      visit(x);
}

int number_of_corners(const Layout& layout, std::size_t polygon)
{
  return int(layout.polygon_ends[polygon] - (polygon == 0 ? 0 : layout.polygon_ends[polygon - 1]));
}

void write_texture_coordinates(const Layout& layout, std::size_t polygon, Number_writer& out)
{
  out << 2 * number_of_corners(layout, polygon);
  for_each_coordinate(layout, polygon, [&](double x) { out << " " << x; });
}

std::string binary_texture_coordinates(const Layout& layout, std::size_t polygon, bool is_big_endian)
{
  std::string bytes;
  store(std::uint32_t(2 * number_of_corners(layout, polygon)), is_big_endian, bytes);
  for_each_coordinate(layout, polygon, [&](double x) { store(x, is_big_endian, bytes); });
  if(has_page_numbers(layout))
    store(std::int32_t(layout.polygon_pages[polygon]), is_big_endian, bytes);
  return bytes;
}

// The file as it was, with other texture coordinates.
std::string renewed(const Ply_source& source, const Layout& layout, const std::string& image)
{
  using Content = Ply_source::Content;
  const std::string_view bytes = source.bytes;
  const bool is_text = source.format == Ply_header::Format::TEXT;
  Number_writer out;
  std::size_t copied = 0, polygon = 0;
  for(const Ply_source::Place& place : source.places)
  {
    if(place.content == Content::FORMER_IMAGE && image.empty())
      continue;
    out << bytes.substr(copied, place.begin - copied);
    copied = place.end;
    if(place.content == Content::IMAGE && !image.empty())
      out << image_comment(image) << source.line_end;
    else if(place.content == Content::PROPERTY)
      out << texture_property(layout) << source.line_end
          << (has_page_numbers(layout) ? page_property() + source.line_end : std::string());
    else if(place.content == Content::TEXTURE_COORDINATES && is_text)
    {
      write_texture_coordinates(layout, polygon, out << (place.begin == place.end ? " " : ""));
      if(has_page_numbers(layout))
        out << " " << layout.polygon_pages[polygon];
      ++polygon;
    }
    else if(place.content == Content::TEXTURE_COORDINATES)
      out << binary_texture_coordinates(layout, polygon++, source.format == Ply_header::Format::BIG);
  }
  out << bytes.substr(copied);
  return std::move(out).text();
}

using Vectors = std::vector<std::array<double, 3> >;

// Per point, or nothing if corners of one point have different ones.
Vectors point_normals(const Layout& layout)
{
  Vectors normals(layout.points.size(), {{0, 0, 0}});
  std::vector<int> numbers(layout.points.size(), -1);
  for(std::size_t corner = 0; corner < layout.corner_normals.size(); ++corner)
  {
    const int normal = layout.corner_normals[corner];
    const std::size_t point = std::size_t(layout.corners[corner]);
    if(numbers[point] >= 0 && (normal < 0 || layout.normals[std::size_t(normal)] != normals[point]))
      return {};
    numbers[point] = normal;
    if(normal >= 0)
      normals[point] = layout.normals[std::size_t(normal)];
  }
  return layout.corner_normals.empty() ? Vectors() : normals;
}

void write_color_properties(const Vectors& colors, Number_writer& out)
{
  if(!colors.empty())
    out << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
}

void write_color(const Vectors& colors, std::size_t i, Number_writer& out)
{
  if(!colors.empty())
    for(const double channel : colors[i])
      out << " " << int(std::lround(255 * channel));
}

void write_header(const Layout& layout, const Vectors& normals, const std::string& image, Number_writer& out)
{
  out << "ply\nformat ascii 1.0\n";
  if(!image.empty())
    out << image_comment(image) << "\n";
  for(const Obj_statements::Line& line : layout.obj_statements.lines)
    if(line.text.front() == '#')
      out << "comment " << line.text << "\n";
  out << "element vertex " << int(layout.points.size())
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  if(!normals.empty())
    out << "property double nx\nproperty double ny\nproperty double nz\n";
  write_color_properties(layout.colors, out);
  out << "element face " << int(layout.polygon_ends.size()) << "\nproperty list uint int vertex_indices\n"
      << texture_property(layout) << "\n";
  if(has_page_numbers(layout))
    out << page_property() << "\n";
  write_color_properties(layout.face_colors, out);
  out << "end_header\n";
}

std::string new_file(const Layout& layout, const std::string& image)
{
  const Vectors normals = point_normals(layout);
  Number_writer out;
  write_header(layout, normals, image, out);
  for(std::size_t v = 0; v < layout.points.size(); ++v)
  {
    const std::array<double, 3>& point = layout.points[v];
    out << point[0] << " " << point[1] << " " << point[2];
    if(!normals.empty())
      for(const double x : normals[v])
        out << " " << x;
    write_color(layout.colors, v, out);
    out << "\n";
  }
  std::size_t corner = 0;
  for(std::size_t polygon = 0; polygon < layout.polygon_ends.size(); ++polygon)
  {
    out << number_of_corners(layout, polygon);
    for(; corner < layout.polygon_ends[polygon]; ++corner)
      out << " " << layout.corners[corner];
    write_texture_coordinates(layout, polygon, out << " ");
    if(has_page_numbers(layout))
      out << " " << layout.polygon_pages[polygon];
    write_color(layout.face_colors, polygon, out);
    out << "\n";
  }
  return std::move(out).text();
}

} // namespace

Data_kinds kinds_in_ply(const Layout& layout)
{
  if(layout.ply_source)
    return layout.kinds;
  Data_kinds kinds = {Data_kind::COMMENTS};
  if(!point_normals(layout).empty())
    kinds.insert(Data_kind::NORMALS);
  if(!layout.colors.empty())
    kinds.insert(Data_kind::COLORS);
  if(!layout.face_colors.empty())
    kinds.insert(Data_kind::FACE_COLORS);
  return kinds;
}

std::string to_ply(const Layout& layout, const std::string& image)
{
  return layout.ply_source ? renewed(*layout.ply_source, layout, image) : new_file(layout, image);
}
