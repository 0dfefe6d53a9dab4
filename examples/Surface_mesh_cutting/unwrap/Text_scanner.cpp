#include "Text_scanner.h"

#include "outcome.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <system_error>

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool is_word(char c) { return !is_blank(c) && c != '\n' && c != '#'; }

// A backslash at the end of a line joins it to the next one.
std::size_t length_of_continuation(std::string_view text)
{
  if(text.substr(0, 2) == "\\\n")
    return 2;
  return text.substr(0, 3) == "\\\r\n" ? 3 : 0;
}

std::string printable(std::string_view word)
{
  std::string result(word.substr(0, 20));
  std::replace_if(result.begin(), result.end(), [](char c) { return c < 32 || c > 126; }, '?');
  return result + (word.size() > 20 ? "..." : "");
}

std::string_view without_plus(std::string_view word)
{
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  return has_plus ? word.substr(1) : word;
}

} // namespace

std::string_view Text_scanner::word_in_line()
{
  while(!m_text.empty())
  {
    if(const std::size_t length = length_of_continuation(m_text))
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
        && length_of_continuation(m_text.substr(length, 3)) == 0)
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

void Text_scanner::skip_line()
{
  const std::size_t end = m_text.find('\n');
  if(end == std::string_view::npos)
  {
    m_text = {};
    return;
  }
  m_text.remove_prefix(end + 1);
  ++m_line;
}

double Text_scanner::to_number(std::string_view word) const
{
  const std::string_view digits = without_plus(word);
  const char* const end = digits.data() + digits.size();
  double result = 0;
  const std::from_chars_result parsed = std::from_chars(digits.data(), end, result);
  if(digits.empty() || parsed.ptr != end || parsed.ec == std::errc::invalid_argument)
    fail("a number", word);
  if(parsed.ec == std::errc::result_out_of_range) // becomes zero or infinity
    return std::strtod(std::string(digits).c_str(), nullptr);
  return result;
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
