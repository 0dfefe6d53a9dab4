#include "base64.h"

#include <cstddef>

namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

} // namespace

std::string to_base64(std::string_view bytes)
{
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    unsigned int group = 0; // of three bytes
    for(std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for(std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::optional<std::string> from_base64(std::string_view text)
{
  while(!text.empty() && text.back() == '=')
    text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  unsigned int group = 0;
  int number_of_bits = 0; // of the group that are no bytes yet
  for(const char c : text)
  {
    const std::size_t digit = digits.find(c);
    if(digit == std::string_view::npos)
      return std::nullopt;
    group = (group << 6 | unsigned(digit)) & 0xffff;
    number_of_bits += 6;
    if(number_of_bits >= 8)
    {
      number_of_bits -= 8;
      bytes += char(group >> number_of_bits & 255);
    }
  }
  return bytes;
}
