#include "Text_scanner.h"
#include "mesh_file.h"
#include "outcome.h"

#include <algorithm>
#include <array>

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

void read_polygon(Text_scanner& scanner, Polygon_soup& soup)
{
  for(std::string_view word = scanner.word_in_line(); !word.empty(); word = scanner.word_in_line())
  {
    // point/texture/normal, of which the last two are optional
    const int index = scanner.to_integer(word.substr(0, word.find('/')));
    if(index == 0 || index < -soup.number_of_points())
      scanner.fail("the index of a point", word);
    soup.corners.push_back(index > 0 ? index - 1 : soup.number_of_points() + index);
  }
  soup.close_polygon();
}

} // namespace

Polygon_soup read_obj(std::string_view text)
{
  Text_scanner scanner(without_byte_order_mark(text));
  Polygon_soup soup;
  for(std::string_view keyword = scanner.word(); !keyword.empty(); keyword = scanner.word())
  {
    if(keyword == "v")
    {
      const double x = scanner.number_in_line();
      const double y = scanner.number_in_line();
      const double z = scanner.number_in_line();
      soup.points.push_back({{x, y, z}});
    }
    else if(keyword == "f" || keyword == "fo") // the same in old files
      read_polygon(scanner, soup);
    else if(!is_skipped(keyword))
      scanner.fail("a statement of the OBJ format", keyword);
    scanner.skip_line();
  }
  if(soup.points.empty() && soup.polygon_ends.empty())
    throw Failure(Exit_code::UNREADABLE, "the file has neither points nor faces");
  return soup;
}
