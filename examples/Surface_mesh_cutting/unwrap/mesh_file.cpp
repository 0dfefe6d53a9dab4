#include "mesh_file.h"

#include "Text_scanner.h"
#include "file_bytes.h"
#include "file_extension.h"
#include "outcome.h"
#include "read_gltf.h"
#include "read_with_cgal.h"

#include <climits>
#include <string>

namespace {

using Reader = Polygon_soup (*)(std::string_view, Attributes);

Reader find_reader_by_extension(const std::string& path)
{
  const std::string extension = extension_of(path);
  return extension == ".off" ? read_off
       : extension == ".obj" ? read_obj
       : extension == ".ply" ? read_ply
       : extension == ".stl" ? read_stl : nullptr;
}

Reader find_reader_by_content(std::string_view bytes)
{
  const std::string_view word = Text_scanner(without_byte_order_mark(bytes)).word();
  return word == "OFF" ? read_off
       : word == "ply" ? read_ply
       : starts_text_stl(bytes) ? read_stl : nullptr;
}

Polygon_soup read_soup(const std::string& path, Attributes attributes)
{
  const std::string bytes = read_bytes(path);
  Reader read = find_reader_by_extension(path);
  if(read == nullptr)
    read = find_reader_by_content(bytes);
  return read != nullptr ? read(bytes, attributes) : read_with_cgal(path);
}

} // namespace

void check_indices(const Polygon_soup& soup)
{
  for(int polygon = 0; polygon < soup.number_of_polygons(); ++polygon)
    for(int k = 0; k < soup.number_of_corners(polygon); ++k)
      if(soup.corner(polygon, k) >= soup.number_of_points())
        throw Failure(Exit_code::UNREADABLE,
                      "face " + std::to_string(polygon) + " refers to vertex "
                        + std::to_string(soup.corner(polygon, k)) + ", but there are only "
                        + std::to_string(soup.number_of_points()) + " (all counted from 0)",
                      {Witness::Kind::FACES, {polygon}});
}

Polygon_soup read_mesh_file(const std::string& path, Attributes attributes)
{
  const Polygon_soup soup = is_gltf(path) ? read_gltf(path, attributes) : read_soup(path, attributes);
  if(soup.corners.size() > std::size_t(INT_MAX) || soup.points.size() > std::size_t(INT_MAX))
    throw Failure(Exit_code::UNREADABLE, "the mesh is too large");
  check_indices(soup);
  return soup;
}
