#include "Text_scanner.h"
#include "mesh_file.h"
#include "outcome.h"
#include "point_uvs.h"
#include "vertex_colors.h"

#include <algorithm>
#include <cctype>
#include <optional>

namespace {

// What a line has behind the coordinates of a point.
struct Point_line
{
  bool has_normal = false, has_color = false, has_uv = false; // in this order
};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

// Reads the word OFF with its prefixes. Files that start with the counts have been seen, too, and many without a space
// between them and the word.
Point_line read_word_of_format(Text_scanner& scanner)
{
  constexpr std::string_view off = "OFF";
  const std::string_view word = scanner.word();
  const std::size_t length = word.compare(0, off.size(), off) == 0 ? off.size() : 0;
  if(word.size() > length && is_digit(word[length]) && word != "4OFF")
  {
    scanner.put_back(word.substr(length));
    return {};
  }
  if(word != "OFF" && word != "COFF" && word != "NOFF" && word != "CNOFF" && word != "STOFF"
     && word != "STCOFF" && word != "STNOFF" && word != "STCNOFF")
    scanner.fail("OFF", word);
  const Text_scanner behind = scanner;
  if(scanner.word_in_line() == "BINARY")
    throw Failure(Exit_code::UNREADABLE, "binary OFF is not supported, use binary PLY");
  scanner = behind;
  const auto has = [&](std::string_view prefix) { return word.find(prefix) != std::string_view::npos; };
  return {has("N"), has("C"), has("ST")};
}

// The last two words of the line, since colors may be of three numbers or four.
Polygon_soup::Texture_point read_uv(Text_scanner& scanner)
{
  std::string_view u, v;
  for(std::string_view word = scanner.word_in_line(); !word.empty(); word = scanner.word_in_line())
  {
    u = v;
    v = word;
  }
  return {{scanner.to_number(u), scanner.to_number(v)}};
}

void read_attributes(Point_line line, Text_scanner& scanner, Point_uvs& uvs, Polygon_soup& soup)
{
  for(int i = 0; i < 3 && line.has_normal; ++i)
    scanner.word_in_line();
  if(line.has_color)
    read_color(scanner, soup);
  if(line.has_uv)
    uvs.push_back(read_uv(scanner));
}

// The next number of a point or polygon: in the same line if each has a line of its own.
std::string_view next_word(Text_scanner& scanner, bool has_lines)
{
  return has_lines ? scanner.word_in_line() : scanner.word();
}

// Without a line for each point, there is nothing but coordinates, in any lines.
Point_uvs read_points(Text_scanner& scanner, int number, const std::optional<Point_line>& line, Polygon_soup& soup)
{
  Point_uvs uvs;
  for(int i = 0; i < number; ++i)
  {
    const double x = scanner.number();
    const double y = scanner.to_number(next_word(scanner, line.has_value()));
    const double z = scanner.to_number(next_word(scanner, line.has_value()));
    soup.points.push_back({{x, y, z}});
    if(!line)
      continue;
    read_attributes(*line, scanner, uvs, soup);
    scanner.skip_line(); // with what stands behind
  }
  if(!line)
    if(const std::string_view word = scanner.word_in_line(); !word.empty())
      scanner.fail("the end of the line", word);
  return uvs;
}

Polygon_soup read_elements(Text_scanner& scanner, const std::optional<Point_line>& line)
{
  const int number_of_points = scanner.index();
  const int number_of_polygons = scanner.index();
  scanner.skip_line(); // the number of edges

  // An element takes at least a line of its own with a character in it.
  const std::size_t maximum = scanner.rest().size() / 2 + 1;
  Polygon_soup soup;
  soup.points.reserve((std::min)(std::size_t(number_of_points), maximum));
  soup.polygon_ends.reserve((std::min)(std::size_t(number_of_polygons), maximum));

  const Point_uvs uvs = read_points(scanner, number_of_points, line, soup);
  for(int i = 0; i < number_of_polygons; ++i)
  {
    const int size = scanner.index();
    for(int k = 0; k < size; ++k)
      soup.corners.push_back(scanner.to_index(next_word(scanner, line.has_value())));
    soup.close_polygon();
    scanner.skip_line();
  }
  complete_colors(soup);
  if(!uvs.empty())
    set_corner_uvs(uvs, soup);
  return soup;
}

std::optional<Polygon_soup> try_any_lines(Text_scanner& scanner)
{
  try
  {
    const Polygon_soup soup = read_elements(scanner, std::nullopt);
    return scanner.word().empty() ? std::make_optional(soup) : std::nullopt;
  }
  catch(const Failure& failure)
  {
    if(failure.code != Exit_code::UNREADABLE)
      throw;
    return {};
  }
}

} // namespace

// Usually, each point and each polygon has a line of its own, and what follows its numbers is passed over. Some files
// have several points in a line, or one in several: that is tried where the other reading fails, and must account for all.
Polygon_soup read_off(std::string_view text, Attributes attributes)
{
  Text_scanner scanner(without_byte_order_mark(text));
  Point_line line = read_word_of_format(scanner);
  line.has_color = line.has_color && attributes.has_looks;
  line.has_uv = line.has_uv && attributes.has_uvs;
  const Text_scanner behind_header = scanner;
  try
  {
    return read_elements(scanner, line);
  }
  catch(const Failure& failure)
  {
    if(failure.code != Exit_code::UNREADABLE)
      throw;
    scanner = behind_header;
    const std::optional<Polygon_soup> soup = try_any_lines(scanner);
    if(!soup)
      throw;
    return *soup;
  }
}
