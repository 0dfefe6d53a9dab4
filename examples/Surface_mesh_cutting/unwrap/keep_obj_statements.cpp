#include "keep_obj_statements.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <vector>

namespace {

// With a blank before each word.
std::string rest_of_line(Text_scanner& scanner)
{
  std::string text;
  for(std::string_view word = scanner.word_in_line(); !word.empty(); word = scanner.word_in_line())
    text.append(" ").append(word);
  return text;
}

bool is_about_polygons(std::string_view keyword)
{
  static const std::array<std::string_view, 6> keywords = {{"g", "o", "s", "mg", "mtllib", "usemtl"}};
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

} // namespace

void keep_point_end(Text_scanner scanner, Polygon_soup& soup)
{
  const std::string end = rest_of_line(scanner);
  std::vector<std::string>& ends = soup.obj_statements.point_ends;
  if(end.empty() && ends.empty())
    return;
  ends.resize(soup.points.size() - 1);
  ends.push_back(end);
}

void keep_normal_index(std::string_view word, Polygon_soup& soup)
{
  const std::size_t slash = std::count(word.begin(), word.end(), '/') == 2 ? word.rfind('/') : std::string_view::npos;
  int index = 0;
  if(slash != std::string_view::npos)
    std::from_chars(word.data() + slash + 1, word.data() + word.size(), index);
  if(index < 0)
    index += int(soup.normals.size()) + 1;
  soup.corner_normals.push_back((std::max)(index, 0) - 1);
}

void keep_statement(std::string_view keyword, Text_scanner scanner, Polygon_soup& soup)
{
  if(keyword == "vn")
  {
    const double x = number_or_nan(scanner.word_in_line()), y = number_or_nan(scanner.word_in_line());
    soup.normals.push_back({{x, y, number_or_nan(scanner.word_in_line())}});
  }
  else if(is_about_polygons(keyword))
    soup.obj_statements.lines.push_back({soup.number_of_polygons(), std::string(keyword) + rest_of_line(scanner)});
}

void complete_looks(Polygon_soup& soup)
{
  for(int& normal : soup.corner_normals)
    if(normal >= int(soup.normals.size()))
      normal = -1;
  const auto is_none = [](int normal) { return normal < 0; };
  if(std::all_of(soup.corner_normals.begin(), soup.corner_normals.end(), is_none))
  {
    soup.corner_normals.clear();
    soup.normals.clear();
  }
  std::vector<std::string>& ends = soup.obj_statements.point_ends;
  if(!ends.empty())
    ends.resize(soup.points.size());
}
