#include "keep_obj_statements.h"

#include "complete_normals.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

namespace {

// With a blank before each word.
std::string remaining_words(Text_scanner& scanner)
{
  std::string text;
  for(std::string_view word = scanner.word_in_line(); !word.empty(); word = scanner.word_in_line())
    text.append(" ").append(word);
  return text;
}

// Other readers take all of the line for a name, too. A backslash at its end joins the next line, as in all statements,
// unless that is empty or begins a statement: names of folders end so.
std::string names(Text_scanner& scanner)
{
  std::string text(scanner.rest_of_line());
  while(!text.empty() && text.back() == '\\')
  {
    Text_scanner next = scanner;
    next.skip_line();
    const Text_scanner line = next;
    if(const std::string_view word = next.word_in_line(); word.empty() || starts_obj_statement(word))
      break;
    scanner = line;
    text.pop_back();
    text.append(scanner.rest_of_line());
  }
  return text.empty() ? text : " " + text;
}

// `word` is point/texture/normal. Only the point keeps its number in what is written.
std::string point_of(std::string_view word, int number_of_points)
{
  const std::string_view number = word.substr(0, word.find('/'));
  const char* const end = number.data() + number.size();
  int index = 0;
  const std::from_chars_result parsed = std::from_chars(number.data(), end, index);
  if(parsed.ec != std::errc() || parsed.ptr != end || index == 0 || index < -number_of_points)
    return std::string(word);
  return std::to_string(index > 0 ? index : number_of_points + index + 1);
}

std::string words_with_points(std::size_t first_point, Text_scanner& scanner, int number_of_points)
{
  std::string text;
  std::size_t i = 0;
  for(std::string_view word = scanner.word_in_line(); !word.empty(); word = scanner.word_in_line())
    text.append(" ").append(i++ < first_point ? std::string(word) : point_of(word, number_of_points));
  return text;
}

} // namespace

void keep_point_end(Text_scanner scanner, Polygon_soup& soup)
{
  const std::string end = remaining_words(scanner);
  const auto number_of_words = std::count(end.begin(), end.end(), ' ');
  if(number_of_words >= 3)
    soup.kinds.insert(Data_kind::COLORS);
  if(number_of_words == 4)
    soup.kinds.insert(Data_kind::TRANSPARENCY);
  if(number_of_words == 1 && number_or_nan(std::string_view(end).substr(1)) != 1)
    soup.kinds.insert(Data_kind::POINT_WEIGHTS);
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

void keep_normal(Text_scanner& scanner, Polygon_soup& soup)
{
  const double x = number_or_nan(scanner.word_in_line()), y = number_or_nan(scanner.word_in_line());
  soup.normals.push_back({{x, y, number_or_nan(scanner.word_in_line())}});
}

void keep_statement(std::string_view word, const Obj_keyword* keyword, Text_scanner& scanner, Polygon_soup& soup)
{
  std::string text(word);
  if(keyword != nullptr && keyword->has_names)
    text += names(scanner);
  else if(keyword != nullptr && keyword->first_point)
    text += words_with_points(*keyword->first_point, scanner, soup.number_of_points());
  else
    text += remaining_words(scanner);
  if(text != "s off" && text != "s 0") // which is how it is without
    soup.kinds.insert(keyword != nullptr ? keyword->kind : Data_kind::UNKNOWN_STATEMENTS);
  soup.obj_statements.lines.push_back({soup.number_of_polygons(), text});
}

void keep_comment(std::string_view text, Polygon_soup& soup)
{
  std::vector<Obj_statements::Line>& lines = soup.obj_statements.lines;
  soup.kinds.insert(Data_kind::COMMENTS);
  const bool is_at_top = soup.points.empty() && (lines.empty() || lines.back().polygon < 0);
  lines.push_back({is_at_top ? -1 : soup.number_of_polygons(), std::string(text)});
}

void complete_looks(Polygon_soup& soup)
{
  complete_normals(soup);
  std::vector<std::string>& ends = soup.obj_statements.point_ends;
  if(!ends.empty())
    ends.resize(soup.points.size());
}
