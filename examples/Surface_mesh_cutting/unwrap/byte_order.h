// Numbers and the bytes of a file.

#ifndef UNWRAP_BYTE_ORDER_H
#define UNWRAP_BYTE_ORDER_H

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

inline bool is_big_endian_machine()
{
  const unsigned short one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

// The number stored in the first bytes of `bytes`.
template <typename Number>
Number load(std::string_view bytes, bool is_big_endian)
{
  char buffer[sizeof(Number)];
  std::copy_n(bytes.data(), sizeof(Number), buffer);
  if(is_big_endian != is_big_endian_machine())
    std::reverse(buffer, buffer + sizeof(Number));
  Number result;
  std::memcpy(&result, buffer, sizeof(Number));
  return result;
}

// Appends the bytes of a number.
template <typename Number>
void store(Number number, bool is_big_endian, std::string& bytes)
{
  char buffer[sizeof(Number)];
  std::memcpy(buffer, &number, sizeof(Number));
  if(is_big_endian != is_big_endian_machine())
    std::reverse(buffer, buffer + sizeof(Number));
  bytes.append(buffer, sizeof(Number));
}

#endif // UNWRAP_BYTE_ORDER_H
