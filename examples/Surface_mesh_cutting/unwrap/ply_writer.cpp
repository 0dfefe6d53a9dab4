#include "ply_writer.h"

#include "Number_writer.h"
#include "Ply_source.h"
#include "byte_order.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace {

const std::string& texture_property()
{
  static const std::string line = "property list uint double texcoord";
  return line;
}

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
    for(const double x : layout.uv_points[std::size_t(layout.corner_uvs[corner])])
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
      out << texture_property() << source.line_end;
    else if(place.content == Content::TEXTURE_COORDINATES && is_text)
      write_texture_coordinates(layout, polygon++, out << (place.begin == place.end ? " " : ""));
    else if(place.content == Content::TEXTURE_COORDINATES)
      out << binary_texture_coordinates(layout, polygon++, source.format == Ply_header::Format::BIG);
  }
  out << bytes.substr(copied);
  return std::move(out).text();
}

void write_header(const Layout& layout, const std::string& image, Number_writer& out)
{
  out << "ply\nformat ascii 1.0\n";
  if(!image.empty())
    out << image_comment(image) << "\n";
  out << "element vertex " << int(layout.points.size())
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  if(!layout.colors.empty())
    out << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  out << "element face " << int(layout.polygon_ends.size()) << "\nproperty list uint int vertex_indices\n"
      << texture_property() << "\nend_header\n";
}

std::string new_file(const Layout& layout, const std::string& image)
{
  Number_writer out;
  write_header(layout, image, out);
  for(std::size_t v = 0; v < layout.points.size(); ++v)
  {
    const std::array<double, 3>& point = layout.points[v];
    out << point[0] << " " << point[1] << " " << point[2];
    if(!layout.colors.empty())
      for(const double channel : layout.colors[v])
        out << " " << int(std::lround(255 * channel));
    out << "\n";
  }
  std::size_t corner = 0;
  for(std::size_t polygon = 0; polygon < layout.polygon_ends.size(); ++polygon)
  {
    out << number_of_corners(layout, polygon);
    for(; corner < layout.polygon_ends[polygon]; ++corner)
      out << " " << layout.corners[corner];
    write_texture_coordinates(layout, polygon, out << " ");
    out << "\n";
  }
  return std::move(out).text();
}

} // namespace

Data_kinds kinds_in_ply(const Layout& layout)
{
  return layout.ply_source ? layout.kinds : Data_kinds{Data_kind::COLORS};
}

std::string to_ply(const Layout& layout, const std::string& image)
{
  return layout.ply_source ? renewed(*layout.ply_source, layout, image) : new_file(layout, image);
}
