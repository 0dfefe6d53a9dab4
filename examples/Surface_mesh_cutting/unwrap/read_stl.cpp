#include "Point_merger.h"
#include "Text_scanner.h"
#include "byte_order.h"
#include "mesh_file.h"
#include "outcome.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string>
#include <vector>

namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

Polygon_soup read_binary(std::string_view bytes, bool does_merge)
{
  const std::optional<std::size_t> size = size_of_binary_stl(bytes);
  if(!size || bytes.size() < *size)
    throw Failure(Exit_code::UNREADABLE, "the file ends before its last facet");

  Polygon_soup soup;
  Point_merger merger(soup, does_merge);
  for(std::size_t facet = header_size; facet < *size; facet += facet_size)
  {
    if(load<std::uint16_t>(bytes.substr(facet + 48, 2), false) != 0)
      soup.kinds.insert(Data_kind::ATTRIBUTE_BYTES);
    const auto coordinate = [&](std::size_t i) // the first three are the normal
    { return double(load<float>(bytes.substr(facet + 4 * i, 4), false)); };
    for(std::size_t i = 3; i < 12; i += 3)
      merger.add_corner(coordinate(i), coordinate(i + 1), coordinate(i + 2));
    soup.close_polygon();
  }
  return soup;
}

// Some programs write the words in upper case.
std::string in_lower_case(std::string_view word)
{
  std::string result(word);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

// Names of parts, if there are several. That of one is the program's or the file's.
void add_names(const std::vector<Obj_statements::Line>& solids, Polygon_soup& soup)
{
  if(solids.size() < 2)
    return;
  soup.obj_statements.lines = solids;
  soup.kinds.insert(Data_kind::GROUPS);
}

Polygon_soup read_text(std::string_view text, Attributes attributes)
{
  Text_scanner scanner(without_byte_order_mark(text));
  Polygon_soup soup;
  Point_merger merger(soup, attributes.has_merged_points);
  std::vector<Obj_statements::Line> solids;
  bool is_in_solid = false;
  for(std::string_view found = scanner.word(); !found.empty(); found = scanner.word())
  {
    const std::string word = in_lower_case(found);
    if(word == "vertex")
    {
      const double x = scanner.number();
      const double y = scanner.number();
      const double z = scanner.number();
      merger.add_corner(x, y, z);
    }
    else if(word == "endfacet")
      soup.close_polygon();
    else if(word == "solid" || word == "endsolid")
    {
      is_in_solid = word == "solid";
      const std::string name(scanner.rest_of_line());
      if(is_in_solid)
        solids.push_back({soup.number_of_polygons(), "o " + (name.empty() ? "solid" : name)});
    }
    else if(word == "facet")
      for(int i = 0; i < 4; ++i) // the word "normal" and its coordinates
        scanner.word();
    else if(word != "outer" && word != "loop" && word != "endloop")
      scanner.fail("a word of the STL format", found);
  }
  if(is_in_solid || soup.corners.size() != soup.first_corner(soup.number_of_polygons()))
    scanner.fail("endsolid", {});
  if(attributes.has_looks)
    add_names(solids, soup);
  return soup;
}

} // namespace

std::optional<std::size_t> size_of_binary_stl(std::string_view bytes)
{
  if(bytes.size() < header_size)
    return {};
  return header_size + facet_size * std::size_t(load<std::uint32_t>(bytes.substr(80, 4), false));
}

bool starts_text_stl(std::string_view bytes)
{
  return in_lower_case(Text_scanner(without_byte_order_mark(bytes)).word()) == "solid";
}

Polygon_soup read_stl(std::string_view bytes, Attributes attributes)
{
  // The header of a binary file may start with any word, and something may follow its facets. Read
  // as their number, four characters of text would ask for gigabytes.
  const std::optional<std::size_t> size = size_of_binary_stl(bytes);
  const bool is_binary = size && bytes.size() >= *size;
  return !is_binary && starts_text_stl(bytes) ? read_text(bytes, attributes)
                                             : read_binary(bytes, attributes.has_merged_points);
}
