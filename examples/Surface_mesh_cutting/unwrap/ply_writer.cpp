#include "ply_writer.h"

#include "Number_writer.h"

#include <cstddef>

namespace {

void write_header(const Layout& layout, const std::string& texture, Number_writer& out)
{
  out << "ply\nformat ascii 1.0\n";
  if(!texture.empty())
    out << "comment TextureFile " << texture << "\n"; // as viewers know it
  out << "element vertex " << int(layout.points.size())
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element face " << int(layout.polygon_ends.size())
      << "\nproperty list uint int vertex_indices\nproperty list uint double texcoord\nend_header\n";
}

} // namespace

std::string to_ply(const Layout& layout, const std::string& texture)
{
  Number_writer out;
  write_header(layout, texture, out);
  for(const auto& point : layout.points)
    out << point[0] << " " << point[1] << " " << point[2] << "\n";
  std::size_t first = 0;
  for(const std::size_t end : layout.polygon_ends)
  {
    out << int(end - first);
    for(std::size_t corner = first; corner < end; ++corner)
      out << " " << layout.corners[corner];
    out << " " << int(2 * (end - first));
    for(std::size_t corner = first; corner < end; ++corner)
    {
      const auto& uv = layout.uv_points[std::size_t(layout.corner_uvs[corner])];
      out << " " << uv[0] << " " << uv[1];
    }
    out << "\n";
    first = end;
  }
  return out.text();
}
