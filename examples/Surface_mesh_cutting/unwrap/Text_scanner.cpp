#include "Text_scanner.h"

#include "outcome.h"
#include "stop_request.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <optional>
#include <system_error>

namespace {

// Carriage returns alone end the lines of old files.
char line_end_of(std::string_view text)
{
  return text.find('\n') == std::string_view::npos ? '\r' : '\n';
}

std::string_view without_plus(std::string_view word)
{
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return has_plus ? word.substr(1) : word;
}

std::optional<double> parse_number(std::string_view word)
{
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  double result = 0;
  const std::from_chars_result parsed = std::from_chars(digits.data(), end, result);
  if(digits.empty() || parsed.ptr != end || parsed.ec == std::errc::invalid_argument)
    return std::nullopt;
  if(parsed.ec == std::errc::result_out_of_range) // becomes zero or infinity
    return std::strtod(std::string(digits).c_str(), nullptr);
  return result;
}

} // namespace

std::string printable(std::string_view word)
{
  std::string result(word.substr(0, 20));
  std::replace_if(result.begin(), result.end(), [](char c) { return c < 32 || c > 126; }, '?');
  return result + (word.size() > 20 ? "..." : "");
}

double number_or_nan(std::string_view word)
{
  return parse_number(word).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::string_view without_byte_order_mark(std::string_view text)
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.substr(0, mark.size()) == mark ? text.substr(mark.size()) : text;
}

Text_scanner::Text_scanner(std::string_view text) : m_text(text), m_line_end(line_end_of(text)) {}

bool Text_scanner::is_blank(char c) const
{
  return c != m_line_end && (c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f');
}

bool Text_scanner::is_word(char c) const { return !is_blank(c) && c != m_line_end && c != '#'; }

// A backslash at the end of a line joins it to the next one.
std::size_t Text_scanner::length_of_continuation(std::size_t position) const
{
  const std::string_view text = m_text.substr(position, 3);
  if(text.size() > 1 && text[0] == '\\' && text[1] == m_line_end)
    return 2;
  return text == "\\\r\n" ? 3 : 0;
}

std::string_view Text_scanner::word_in_line()
{
  while(!m_text.empty())
  {
    if(const std::size_t length = length_of_continuation(0))
    {
      m_text.remove_prefix(length);
      ++m_line;
    }
    else if(is_blank(m_text.front()))
      m_text.remove_prefix(1);
    else
      break;
  }
  std::size_t length = 0;
  while(length < m_text.size() && is_word(m_text[length])
        && length_of_continuation(length) == 0)
    ++length;
  const std::string_view result = m_text.substr(0, length);
  m_text.remove_prefix(length);
  return result;
}

std::string_view Text_scanner::word()
{
  for(;;)
  {
    const std::string_view result = word_in_line();
    if(!result.empty() || m_text.empty())
      return result;
    skip_line();
  }
}

std::string_view Text_scanner::rest_of_line()
{
  const std::size_t size = (std::min)(m_text.find(m_line_end), m_text.size());
  std::string_view result = m_text.substr(0, size);
  m_text.remove_prefix(size);
  while(!result.empty() && is_blank(result.front()))
    result.remove_prefix(1);
  while(!result.empty() && is_blank(result.back()))
    result.remove_suffix(1);
  return result;
}

void Text_scanner::skip_line()
{
  const std::size_t end = m_text.find(m_line_end);
  if(end == std::string_view::npos)
  {
    m_text.remove_prefix(m_text.size());
    return;
  }
  m_text.remove_prefix(end + 1);
  ++m_line;
  constexpr int lines_per_question = 4096;
  if(m_line % lines_per_question == 0)
    end_if_stop_is_requested();
}

std::size_t Text_scanner::number_of_line_ends() const
{
  return std::size_t(std::count(m_text.begin(), m_text.end(), m_line_end));
}

double Text_scanner::to_number(std::string_view word) const
{
  const std::optional<double> number = parse_number(word);
  if(!number)
    fail("a number", word);
  return *number;
}

int Text_scanner::to_integer(std::string_view word) const
{
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  int result = 0;
  const std::from_chars_result parsed = std::from_chars(digits.data(), end, result);
  if(digits.empty() || parsed.ptr != end || parsed.ec != std::errc())
    fail("an integer", word);
  return result;
}

int Text_scanner::to_index(std::string_view word) const
{
  const int result = to_integer(word);
  if(result < 0)
    fail("a number that is not negative", word);
  return result;
}

void Text_scanner::fail(const std::string& expected, std::string_view word) const
{
  const std::string found = !word.empty() ? "'" + printable(word) + "'"
                          : m_text.empty() ? "the end of the file" : "the end of the line";
  throw Failure(Exit_code::UNREADABLE,
                "line " + std::to_string(m_line) + ": expected " + expected + ", found " + found);
}
