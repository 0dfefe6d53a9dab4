// The header of a PLY file.

#ifndef UNWRAP_PLY_HEADER_H
#define UNWRAP_PLY_HEADER_H

#include "Data_kinds.h"
#include "Text_scanner.h"

#include <string>
#include <string_view>
#include <vector>

struct Ply_header
{
  enum class Format { TEXT, LITTLE, BIG };
  enum class Type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

  struct Property
  {
    std::string name;
    Type type;
    bool is_list;
    Type size_type; // of a list
    std::string_view line;
  };

  struct Element
  {
    std::string name;
    int number;
    std::vector<Property> properties;

    // The position of the first property that has one of the names, -1 if there is none.
    int find(std::string_view name_1, std::string_view name_2 = {}) const;
    // The positions of the two texture coordinates of points, or nothing. Programs name them differently.
    std::vector<int> find_point_uv() const;
    bool has_points() const { return name == "vertex" || name == "vertices"; }
    bool has_polygons() const { return name == "face" || name == "faces"; }
    bool has_strips() const { return name == "tristrips"; }
  };

  // The name of the property of faces that lists the texture coordinates of corners.
  static std::string name_of_uvs(int set) { return set == 0 ? "texcoord" : "texcoord_" + std::to_string(set); }

  Format format = Format::TEXT;
  std::vector<Element> elements;
  std::string_view format_line;
  std::vector<std::string_view> image_lines; // comments that name the file of a texture
  std::vector<std::string_view> comments;    // the text of all others

  std::size_t number_of_elements() const;
  // The kinds of data besides points, polygons and texture coordinates.
  Data_kinds kinds() const;

  // The line that names the file of a texture begins so.
  static constexpr std::string_view image_comment = "TextureFile";
};

// Leaves the scanner where the values begin. Each line of the header includes the character that ends it.
Ply_header read_ply_header(Text_scanner& scanner);

#endif // UNWRAP_PLY_HEADER_H
