#include "Point_merger.h"
#include "Text_scanner.h"
#include "byte_order.h"
#include "mesh_file.h"
#include "outcome.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string>

namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

std::size_t size_of_binary_file(std::string_view bytes)
{
  return header_size + facet_size * std::size_t(load<std::uint32_t>(bytes.substr(80, 4), false));
}

Polygon_soup read_binary(std::string_view bytes, bool does_merge)
{
  if(bytes.size() < header_size || bytes.size() < size_of_binary_file(bytes))
    throw Failure(Exit_code::UNREADABLE, "the file ends before its last facet");

  Polygon_soup soup;
  Point_merger merger(soup, does_merge);
  for(std::size_t facet = header_size; facet < size_of_binary_file(bytes); facet += facet_size)
  {
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

Polygon_soup read_text(std::string_view text, bool does_merge)
{
  Text_scanner scanner(without_byte_order_mark(text));
  Polygon_soup soup;
  Point_merger merger(soup, does_merge);
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
      scanner.skip_line(); // its name
    }
    else if(word == "facet")
      for(int i = 0; i < 4; ++i) // the word "normal" and its coordinates
        scanner.word();
    else if(word != "outer" && word != "loop" && word != "endloop")
      scanner.fail("a word of the STL format", found);
  }
  if(is_in_solid || soup.corners.size() != soup.first_corner(soup.number_of_polygons()))
    scanner.fail("endsolid", {});
  return soup;
}

} // namespace

bool starts_text_stl(std::string_view bytes)
{
  return in_lower_case(Text_scanner(without_byte_order_mark(bytes)).word()) == "solid";
}

Polygon_soup read_stl(std::string_view bytes, Attributes attributes)
{
  // The header of a binary file may start with any word, and something may follow its facets. Read
  // as their number, four characters of text would ask for gigabytes.
  const bool is_binary = bytes.size() >= header_size && bytes.size() >= size_of_binary_file(bytes);
  return !is_binary && starts_text_stl(bytes) ? read_text(bytes, attributes.has_merged_points)
                                             : read_binary(bytes, attributes.has_merged_points);
}
