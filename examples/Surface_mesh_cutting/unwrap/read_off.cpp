#include "Text_scanner.h"
#include "mesh_file.h"
#include "outcome.h"

#include <algorithm>
#include <cctype>

namespace {

// Reads the word OFF with its prefixes. Files that start with the counts have been seen, too.
void read_header(Text_scanner& scanner)
{
  const Text_scanner start = scanner;
  const std::string_view word = scanner.word();
  if(!word.empty() && std::isdigit(static_cast<unsigned char>(word.front())) && word != "4OFF")
  {
    scanner = start;
    return;
  }
  // Texture coordinates, colors and normals stand behind the coordinates and are not needed.
  if(word != "OFF" && word != "COFF" && word != "NOFF" && word != "CNOFF" && word != "STOFF"
     && word != "STCOFF" && word != "STNOFF" && word != "STCNOFF")
    scanner.fail("OFF", word);
  const Text_scanner behind = scanner;
  if(scanner.word_in_line() == "BINARY")
    throw Failure(Exit_code::UNREADABLE, "binary OFF is not supported, use binary PLY");
  scanner = behind;
}

} // namespace

Polygon_soup read_off(std::string_view text)
{
  Text_scanner scanner(text);
  read_header(scanner);
  const int number_of_points = scanner.index();
  const int number_of_polygons = scanner.index();
  scanner.skip_line(); // the number of edges

  // An element takes at least a line of its own with a character in it.
  const std::size_t maximum = scanner.rest().size() / 2 + 1;
  Polygon_soup soup;
  soup.points.reserve((std::min)(std::size_t(number_of_points), maximum));
  soup.polygon_ends.reserve((std::min)(std::size_t(number_of_polygons), maximum));

  for(int i = 0; i < number_of_points; ++i)
  {
    const double x = scanner.number();
    const double y = scanner.number_in_line();
    const double z = scanner.number_in_line();
    soup.points.push_back({{x, y, z}});
    scanner.skip_line();
  }
  for(int i = 0; i < number_of_polygons; ++i)
  {
    const int size = scanner.index();
    for(int k = 0; k < size; ++k)
      soup.corners.push_back(scanner.index_in_line());
    soup.close_polygon();
    scanner.skip_line();
  }
  return soup;
}
