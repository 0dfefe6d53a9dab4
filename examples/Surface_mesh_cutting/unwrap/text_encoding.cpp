#include "text_encoding.h"

#include "byte_order.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace {

constexpr std::size_t unit = 2; // bytes

// Whether the high byte of each unit comes first, if the text is UTF-16.
std::optional<bool> byte_order(std::string_view bytes)
{
  const std::string_view mark = bytes.substr(0, unit);
  return mark == "\xFE\xFF" ? std::optional<bool>(true) : mark == "\xFF\xFE" ? std::optional<bool>(false) : std::nullopt;
}

void append(std::uint32_t character, std::string& text)
{
  const auto add = [&](std::uint32_t byte) { text += char(byte); };
  const auto add_following = [&](int shift) { add(0x80 | (character >> shift & 0x3F)); };
  if(character < 0x80)
    return add(character);
  if(character < 0x800)
    add(0xC0 | character >> 6);
  else
  {
    if(character < 0x10000)
      add(0xE0 | character >> 12);
    else
    {
      add(0xF0 | character >> 18);
      add_following(12);
    }
    add_following(6);
  }
  add_following(0);
}

} // namespace

std::string in_utf8(std::string bytes)
{
  const std::optional<bool> is_big_endian = byte_order(bytes);
  if(!is_big_endian)
    return bytes;
  constexpr std::uint32_t replacement = 0xFFFD;
  const auto is_high = [](std::uint32_t c) { return c >= 0xD800 && c < 0xDC00; };
  const auto is_low = [](std::uint32_t c) { return c >= 0xDC00 && c < 0xE000; };
  std::string text;
  for(std::string_view rest = std::string_view(bytes).substr(unit); rest.size() >= unit;)
  {
    const auto next = [&]() -> std::uint32_t
    { return rest.size() < unit ? replacement : load<std::uint16_t>(rest, *is_big_endian); };
    std::uint32_t character = next();
    rest.remove_prefix(unit);
    if(is_high(character) && is_low(next()))
    {
      character = 0x10000 + ((character - 0xD800) << 10) + (next() - 0xDC00);
      rest.remove_prefix(unit);
    }
    append(is_high(character) || is_low(character) ? replacement : character, text);
  }
  return text;
}

std::string with_line_feeds(std::string bytes)
{
  const auto replace = [&](std::size_t size)
  { std::replace(bytes.begin(), bytes.begin() + std::ptrdiff_t(size), '\r', '\n'); };
  constexpr std::string_view last_line = "end_header\r";
  const std::size_t end = bytes.compare(0, 4, "ply\r") == 0 && bytes.compare(4, 1, "\n") != 0 ? bytes.find(last_line) : bytes.npos;
  if(end != bytes.npos && bytes.substr(0, end).find("\rformat binary") != bytes.npos)
    replace(end + last_line.size());
  else if(bytes.find('\n') == bytes.npos && bytes.find('\0') == bytes.npos)
    replace(bytes.size());
  return bytes;
}
