#include "Off_header.h"

#include "outcome.h"

#include <cctype>
#include <optional>
#include <string>
#include <utility>

namespace {

constexpr std::string_view off = "OFF";

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

// The word begins with [ST][C][N][4][n]OFF; programs have these prefixes in several orders.
std::optional<std::pair<Off_header, std::size_t> > parse(std::string_view word)
{
  Off_header header;
  std::size_t length = 0;
  const auto take = [&](std::string_view prefix, bool& is_there)
  {
    if(is_there || word.substr(length, prefix.size()) != prefix)
      return false;
    length += prefix.size();
    return is_there = true;
  };
  while(take("ST", header.has_uv) || take("C", header.has_color) || take("N", header.has_normal)
        || take("4", header.is_homogeneous) || take("n", header.has_dimension))
    ;
  if(word.substr(length, off.size()) != off)
    return {};
  length += off.size();
  if(length < word.size() && !is_digit(word[length]))
    return {};
  return std::pair(header, length);
}

} // namespace

bool starts_off(std::string_view word) { return parse(word).has_value(); }

Off_header read_off_header(Text_scanner& scanner)
{
  const std::string_view word = scanner.word();
  const auto parsed = parse(word);
  if(!parsed && (word.empty() || !is_digit(word.front())))
    scanner.fail("OFF", word);
  const auto [header, length] = parsed.value_or(std::pair(Off_header(), std::size_t(0)));
  if(length < word.size())
  {
    scanner.put_back(word.substr(length));
    return header;
  }
  Text_scanner behind = scanner;
  Off_header result = header;
  if(behind.word_in_line() == "BINARY")
  {
    result.is_binary = true;
    scanner = behind;
    scanner.skip_line();
  }
  else if(result.has_dimension)
    check_off_dimension(scanner.index());
  return result;
}

void check_off_dimension(int dimension)
{
  if(dimension != 3)
    throw Failure(Exit_code::UNREADABLE, "the points of the file have " + std::to_string(dimension)
                                           + " dimensions; a surface to unwrap has three");
}
