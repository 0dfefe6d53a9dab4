// Numbers from the bytes of a file.

#ifndef UNWRAP_BYTE_ORDER_H
#define UNWRAP_BYTE_ORDER_H

#include <algorithm>
#include <cstring>
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

#endif // UNWRAP_BYTE_ORDER_H
