#include "mesh_file.h"

#include "Off_header.h"
#include "Text_scanner.h"
#include "file_bytes.h"
#include "file_extension.h"
#include "foreign_formats.h"
#include "obj_keywords.h"
#include "outcome.h"
#include "read_gltf.h"
#include "read_with_cgal.h"
#include "text_encoding.h"

#include <climits>
#include <optional>
#include <string>
#include <utility>

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
  return starts_off(word) ? read_off
       : word == "ply" ? read_ply
       : starts_text_stl(bytes) || size_of_binary_stl(bytes) == bytes.size() ? read_stl
       : bytes.substr(0, 4) == "glTF" ? read_glb
       : starts_obj_statement(word) ? read_obj : nullptr;
}

// Tells what is wrong with a file that no reader knows.
[[noreturn]] void fail_to_read(const std::string& path, std::string_view bytes)
{
  std::string reason = refuse_content(bytes);
  if(reason.empty())
    reason = refuse_ending(path);
  throw Failure(Exit_code::UNREADABLE,
                !reason.empty() ? reason : "the format is unknown or the file is damaged; OFF, OBJ, PLY, STL and glTF are read");
}

Polygon_soup read_of_unknown_name(const std::string& path, std::string_view bytes, Attributes attributes)
{
  if(const Reader read = find_reader_by_content(bytes); read != nullptr)
    return read(bytes, attributes);
  if(path != standard_input)
    if(std::optional<Polygon_soup> soup = read_with_cgal(path))
      return *std::move(soup);
  fail_to_read(path, bytes);
}

Polygon_soup read_soup(const std::string& path, Attributes attributes)
{
  std::string bytes = path == standard_input ? read_standard_input() : read_bytes(path);
  if(bytes.empty())
    throw Failure(Exit_code::UNREADABLE, "the file is empty");
  const Reader read = find_reader_by_extension(path);
  if(read == read_stl && size_of_binary_stl(bytes) == bytes.size()) // whatever its header begins with
    return read_stl(bytes, attributes);
  bytes = with_line_feeds(in_utf8(std::move(bytes)));
  if(read == nullptr)
    return read_of_unknown_name(path, bytes, attributes);
  if(!refuse_content(bytes).empty())
    fail_to_read(path, bytes);
  return read(bytes, attributes);
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
