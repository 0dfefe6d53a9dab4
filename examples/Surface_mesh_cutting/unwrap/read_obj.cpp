#include "Text_scanner.h"
#include "keep_obj_statements.h"
#include "mesh_file.h"
#include "outcome.h"
#include "vertex_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

// Statements that neither add a point nor a polygon. An unknown word is an error: it may be a
// damaged statement, without which all that follows would shift.
bool is_skipped(std::string_view keyword)
{
  static const std::array<std::string_view, 51> keywords = {{
    "vt", "vn", "vp", "l", "p", "g", "o", "s", "mg", "mtllib", "usemtl", "usemap", "maplib",
    "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech", "call",
    "csh", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole",
    "scrv", "sp", "end", "con", "bsp", "bzp", "cdc", "cdp", "res", "vc", "surf_1", "surf_2",
    "q0_1", "q0_2", "q1_1", "q1_2", "curv2d_1", "curv2d_2"}};
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

// The texture points, and for each corner the index of one, -1 for none.
struct Texture
{
  std::vector<Polygon_soup::Texture_point> points;
  std::vector<int> indices;
};

double read_texture_coordinate(Text_scanner& scanner, std::string_view word)
{
  const double coordinate = scanner.to_number(word);
  if(!std::isfinite(coordinate))
    scanner.fail("a finite number", word);
  return coordinate;
}

void read_texture_point(Text_scanner& scanner, Texture& texture)
{
  const double u = read_texture_coordinate(scanner, scanner.word_in_line());
  const std::string_view second = scanner.word_in_line(); // is optional
  texture.points.push_back({{u, second.empty() ? 0 : read_texture_coordinate(scanner, second)}});
}

// `word` is point/texture/normal; relative to those that the file has so far if negative.
void read_texture_index(const Text_scanner& scanner, std::string_view word, Texture& texture)
{
  const std::size_t first = word.find('/');
  const std::string_view number
    = first == std::string_view::npos ? "" : word.substr(first + 1, word.find('/', first + 1) - first - 1);
  const int index = number.empty() ? 0 : scanner.to_integer(number);
  const int count = int(texture.points.size());
  if((index == 0 && !number.empty()) || index < -count)
    scanner.fail("the index of a texture point", word);
  texture.indices.push_back(index >= 0 ? index - 1 : count + index);
}

void add_uvs(const Texture& texture, Polygon_soup& soup)
{
  const auto is_index = [](int index) { return index >= 0; };
  if(std::none_of(texture.indices.begin(), texture.indices.end(), is_index))
    return;
  for(const int index : texture.indices)
  {
    if(index >= int(texture.points.size()))
      throw Failure(Exit_code::UNREADABLE, "a face refers to texture point " + std::to_string(index)
                                             + ", but there are only " + std::to_string(texture.points.size())
                                             + " (all counted from 0)");
    soup.corner_uvs.push_back(index < 0 ? std::nullopt : std::make_optional(texture.points[std::size_t(index)]));
  }
}

void read_polygon(Text_scanner& scanner, Attributes attributes, Polygon_soup& soup, Texture& texture)
{
  for(std::string_view word = scanner.word_in_line(); !word.empty(); word = scanner.word_in_line())
  {
    // point/texture/normal, of which the last two are optional
    const int index = scanner.to_integer(word.substr(0, word.find('/')));
    if(index == 0 || index < -soup.number_of_points())
      scanner.fail("the index of a point", word);
    soup.corners.push_back(index > 0 ? index - 1 : soup.number_of_points() + index);
    if(attributes.has_uvs)
      read_texture_index(scanner, word, texture);
    if(attributes.has_looks)
      keep_normal_index(word, soup);
  }
  soup.close_polygon();
}

} // namespace

Polygon_soup read_obj(std::string_view text, Attributes attributes)
{
  Text_scanner scanner(without_byte_order_mark(text));
  Polygon_soup soup;
  Texture texture;
  for(std::string_view keyword = scanner.word(); !keyword.empty(); keyword = scanner.word())
  {
    if(keyword == "v")
    {
      const double x = scanner.number_in_line();
      const double y = scanner.number_in_line();
      const double z = scanner.number_in_line();
      soup.points.push_back({{x, y, z}});
      if(attributes.has_looks)
      {
        keep_point_end(scanner, soup);
        read_color(scanner, soup);
      }
    }
    else if(keyword == "vt" && attributes.has_uvs)
      read_texture_point(scanner, texture);
    else if(keyword == "f" || keyword == "fo") // the same in old files
      read_polygon(scanner, attributes, soup, texture);
    else if(keyword.front() == '$')
      ; // a comment of the early nineties
    else if(!is_skipped(keyword))
      scanner.fail("a statement of the OBJ format", keyword);
    else if(attributes.has_looks)
      keep_statement(keyword, scanner, soup);
    scanner.skip_line();
  }
  if(soup.points.empty() && soup.polygon_ends.empty())
    throw Failure(Exit_code::UNREADABLE, "the file has neither points nor faces");
  add_uvs(texture, soup);
  complete_colors(soup);
  complete_looks(soup);
  return soup;
}
