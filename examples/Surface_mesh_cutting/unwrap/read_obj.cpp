#include "Text_scanner.h"
#include "keep_obj_statements.h"
#include "mesh_file.h"
#include "obj_keywords.h"
#include "outcome.h"
#include "painted_colors.h"
#include "vertex_colors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace {

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

// Damaged numbers of the former statement, or no text at all, are no statement, not even an unknown one.
bool can_be_statement(std::string_view word)
{
  const auto is_digit = [&](std::size_t i) { return i < word.size() && word[i] >= '0' && word[i] <= '9'; };
  const bool has_sign = word[0] == '+' || word[0] == '-' || word[0] == '.';
  const auto is_text = [](unsigned char c) { return c > ' ' && c != 127; };
  return !is_digit(has_sign ? 1 : 0) && std::all_of(word.begin(), word.end(), is_text);
}

// Statements of other programs, which are told together.
class Unknown_statements
{
public:
  void add(std::string_view word, int line)
  {
    ++m_number;
    ++m_words.emplace(word, Word{line, 0}).first->second.number;
  }

  void tell(Polygon_soup& soup) const
  {
    if(m_number == 0)
      return;
    std::string text = std::to_string(m_number) + (m_number == 1 ? " statement that OBJ does not have is" : " statements that OBJ does not have are")
                       + " not interpreted: ";
    int i = 0;
    for(auto word = m_words.begin(); word != m_words.end() && i < most_words; ++word, ++i)
      text += (i == 0 ? "" : ", ") + printable(word->first) + " (" + std::to_string(word->second.number)
              + ", first in line " + std::to_string(word->second.first_line) + ")";
    if(m_words.size() > most_words)
      text += " and " + std::to_string(m_words.size() - most_words) + " other words";
    soup.warnings.push_back(text);
  }

private:
  struct Word
  {
    int first_line, number;
  };
  static constexpr int most_words = 5;

  std::map<std::string, Word, std::less<> > m_words;
  int m_number = 0;
};

class Obj_reader
{
public:
  Obj_reader(std::string_view text, Attributes attributes)
    : m_attributes(attributes), m_scanner(without_byte_order_mark(text))
  {}

  Polygon_soup run()
  {
    for(; !m_scanner.is_at_end(); m_scanner.skip_line())
    {
      if(const std::string_view word = m_scanner.word_in_line(); !word.empty())
        read_statement(word);
      while(!m_scanner.word_in_line().empty()) // also in lines that continue this one
        ;
      if(m_attributes.has_looks)
        read_comment();
    }
    if(m_soup.points.empty() && m_soup.polygon_ends.empty())
      throw Failure(Exit_code::UNREADABLE, "the file has neither points nor faces");
    add_uvs(m_texture, m_soup);
    complete_colors(m_soup);
    add_painted_colors(m_painted_colors, m_soup);
    complete_looks(m_soup);
    m_unknown.tell(m_soup);
    if(!m_attributes.has_looks)
      m_soup.obj_statements = {};
    return std::move(m_soup);
  }

private:
  void read_statement(std::string_view word)
  {
    if(word == "v")
      read_point();
    else if(word == "vt")
    {
      if(m_attributes.has_uvs)
        read_texture_point(m_scanner, m_texture);
    }
    else if(word == "vn")
    {
      if(m_attributes.has_looks)
        keep_normal(m_scanner, m_soup);
    }
    else if(word == "f" || word == "fo") // the same in old files
      read_polygon();
    else
      read_other(word);
  }

  void read_point()
  {
    const double x = m_scanner.number_in_line();
    const double y = m_scanner.number_in_line();
    const double z = m_scanner.number_in_line();
    m_soup.points.push_back({{x, y, z}});
    if(!m_attributes.has_looks)
      return;
    keep_point_end(m_scanner, m_soup);
    read_color(m_scanner, m_soup);
  }

  void read_polygon()
  {
    for(std::string_view word = m_scanner.word_in_line(); !word.empty(); word = m_scanner.word_in_line())
    {
      // point/texture/normal, of which the last two are optional
      const int index = m_scanner.to_integer(word.substr(0, word.find('/')));
      if(index == 0 || index < -m_soup.number_of_points())
        m_scanner.fail("the index of a point", word);
      m_soup.corners.push_back(index > 0 ? index - 1 : m_soup.number_of_points() + index);
      if(m_attributes.has_uvs)
        read_texture_index(m_scanner, word, m_texture);
      if(m_attributes.has_looks)
        keep_normal_index(word, m_soup);
    }
    m_soup.close_polygon();
  }

  void read_other(std::string_view word)
  {
    const Obj_keyword* const keyword = find_obj_keyword(word);
    if(keyword == nullptr)
    {
      if(!can_be_statement(word))
        m_scanner.fail("a statement of the OBJ format", word);
      m_unknown.add(word, m_scanner.line());
    }
    keep_statement(word, keyword, m_scanner, m_soup);
  }

  void read_comment()
  {
    const std::string_view text = m_scanner.rest_of_line();
    if(text.empty())
      return;
    keep_comment(text, m_soup);
    read_painted_colors(text, m_painted_colors);
  }

  const Attributes m_attributes;
  Text_scanner m_scanner;
  Polygon_soup m_soup;
  Texture m_texture;
  Unknown_statements m_unknown;
  Colors m_painted_colors;
};

} // namespace

Polygon_soup read_obj(std::string_view text, Attributes attributes)
{
  return Obj_reader(text, attributes).run();
}
