#include "terminal_text.h"

#include <cstddef>

namespace {

// How many bytes at the beginning are a character that controls the terminal, or the direction of writing; 0 if none.
std::size_t length_of_control(std::string_view text)
{
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  const auto is_from = [&](std::size_t i, int low, int high) { return byte(i) >= low && byte(i) <= high; };
  if(byte(0) < 32 || byte(0) == 127)
    return 1;
  if(byte(0) == 0xC2 && is_from(1, 0x80, 0x9F)) // in UTF-8
    return 2;
  const bool is_direction = (byte(1) == 0x80 && (is_from(2, 0x8E, 0x8F) || is_from(2, 0xA8, 0xAE)))
                            || (byte(1) == 0x81 && is_from(2, 0xA6, 0xA9));
  return byte(0) == 0xE2 && is_direction ? 3 : 0;
}

} // namespace

std::string for_terminal(std::string_view text)
{
  constexpr const char* digits = "0123456789abcdef";
  std::string result;
  while(!text.empty())
  {
    const std::size_t length = length_of_control(text);
    if(length == 0)
      result += text.front();
    for(std::size_t i = 0; i < length; ++i)
    {
      const unsigned char byte = static_cast<unsigned char>(text[i]);
      result.append("\\x") += digits[byte / 16];
      result += digits[byte % 16];
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}
