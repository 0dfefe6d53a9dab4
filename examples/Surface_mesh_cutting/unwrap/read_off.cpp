#include "Off_attributes.h"
#include "Off_header.h"
#include "Text_scanner.h"
#include "mesh_file.h"
#include "outcome.h"
#include "read_binary_off.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

// Reads the elements once.
class Off_reader
{
public:
  // `has_lines`: whether each point and each polygon has a line of its own. Otherwise, there is nothing but coordinates
  // and corners, in any lines.
  Off_reader(const Text_scanner& scanner, const Off_header& header, bool has_lines, Attributes attributes)
    : m_scanner(scanner), m_header(header), m_has_lines(has_lines), m_attributes(header, attributes)
  {}

  Polygon_soup run()
  {
    const int number_of_points = m_scanner.index();
    const int number_of_polygons = m_scanner.index();
    m_scanner.skip_line(); // the number of edges

    // An element takes at least a line of its own with a character in it.
    const std::size_t maximum = m_scanner.rest().size() / 2 + 1;
    m_soup.points.reserve((std::min)(std::size_t(number_of_points), maximum));
    m_soup.polygon_ends.reserve((std::min)(std::size_t(number_of_polygons), maximum));
    for(int i = 0; i < number_of_points; ++i)
      read_point();
    if(!m_has_lines)
      if(const std::string_view word = m_scanner.word_in_line(); !word.empty())
        m_scanner.fail("the end of the line", word);
    for(int i = 0; i < number_of_polygons; ++i)
      read_polygon();
    if(!m_has_lines)
      if(const std::string_view word = m_scanner.word(); !word.empty())
        m_scanner.fail("the end of the file", word);
    m_attributes.complete(m_soup);
    return std::move(m_soup);
  }

private:
  // The next number of an element.
  std::string_view next_word() { return m_has_lines ? m_scanner.word_in_line() : m_scanner.word(); }

  void read_point()
  {
    std::array<double, 4> x = {{m_scanner.number(), 0, 0, 1}};
    for(int i = 1; i < m_header.number_of_coordinates(); ++i)
      x[std::size_t(i)] = m_scanner.to_number(next_word());
    m_soup.points.push_back({{x[0] / x[3], x[1] / x[3], x[2] / x[3]}});
    if(m_has_lines)
      m_attributes.add_point(finish_line(), m_soup);
  }

  void read_polygon()
  {
    const int size = m_scanner.index();
    for(int k = 0; k < size; ++k)
      m_soup.corners.push_back(m_scanner.to_index(next_word()));
    m_soup.close_polygon();
    if(m_has_lines)
      m_attributes.add_polygon(finish_line(), m_soup);
    else
      m_scanner.skip_line();
  }

  // The numbers that stand behind.
  const std::vector<double>& finish_line()
  {
    m_numbers.clear();
    for(std::string_view word = m_scanner.word_in_line(); !word.empty(); word = m_scanner.word_in_line())
      m_numbers.push_back(number_or_nan(word));
    m_scanner.skip_line();
    return m_numbers;
  }

  Text_scanner m_scanner;
  const Off_header m_header;
  const bool m_has_lines;
  Off_attributes m_attributes;
  Polygon_soup m_soup;
  std::vector<double> m_numbers;
};

// They go to the top, in their order.
void keep_comments(std::string_view text, Polygon_soup& soup)
{
  for(std::size_t begin = text.find('#'); begin < text.size(); begin = text.find('#', begin))
  {
    const std::size_t end = (std::min)(text.find_first_of("\r\n", begin), text.size());
    soup.obj_statements.lines.push_back({-1, std::string(text.substr(begin, end - begin))});
    soup.kinds.insert(Data_kind::COMMENTS);
    begin = end;
  }
}

Polygon_soup read_text(const Text_scanner& behind_header, const Off_header& header, Attributes attributes)
{
  try
  {
    return Off_reader(behind_header, header, true, attributes).run();
  }
  catch(const Failure& failure)
  {
    if(failure.code != Exit_code::UNREADABLE)
      throw;
    try
    {
      return Off_reader(behind_header, header, false, attributes).run();
    }
    catch(const Failure& other)
    {
      if(other.code != Exit_code::UNREADABLE)
        throw;
    }
    throw;
  }
}

} // namespace

// Usually, each point and each polygon has a line of its own. Some files have several points in a line, or one in several:
// that is tried where the other reading fails, and must account for all.
Polygon_soup read_off(std::string_view text, Attributes attributes)
{
  Text_scanner scanner(without_byte_order_mark(text));
  const Off_header header = read_off_header(scanner);
  if(header.is_binary)
    return read_binary_off(scanner.rest(), header, attributes);
  Polygon_soup soup = read_text(scanner, header, attributes);
  if(attributes.has_looks)
    keep_comments(text, soup);
  return soup;
}
