// The values of a PLY file.

#ifndef UNWRAP_PLY_VALUES_H
#define UNWRAP_PLY_VALUES_H

#include "Ply_header.h"
#include "Text_scanner.h"
#include "byte_order.h"
#include "outcome.h"

#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// The values behind the header, one after the other.
class Ply_values
{
  using Format = Ply_header::Format;
  using Type = Ply_header::Type;

public:
  Ply_values(const Ply_header& header, Text_scanner scanner, std::string_view file)
    : m_format(header.format), m_scanner(scanner), m_bytes(scanner.rest()), m_file(file),
      m_has_lines(m_format == Format::TEXT && scanner.number_of_line_ends() + 1 >= header.number_of_elements())
  {}

  double next(Type type)
  {
    if(m_format == Format::TEXT)
      return m_scanner.number();
    switch(type)
    {
      case Type::INT8: return next_binary<std::int8_t>();
      case Type::UINT8: return next_binary<std::uint8_t>();
      case Type::INT16: return next_binary<std::int16_t>();
      case Type::UINT16: return next_binary<std::uint16_t>();
      case Type::INT32: return next_binary<std::int32_t>();
      case Type::UINT32: return next_binary<std::uint32_t>();
      case Type::FLOAT32: return next_binary<float>();
      case Type::FLOAT64: return next_binary<double>();
    }
    return 0;
  }

  // A value that serves as a count or as an index.
  int next_index(Type type) { return to_index(next(type)); }

  // Or nothing for -1, which ends a triangle strip.
  std::optional<int> next_index_or_end(Type type)
  {
    const double value = next(type);
    return value == -1 ? std::nullopt : std::make_optional(to_index(value));
  }

  // Leaves what the line of an element holds behind its properties: some programs declare fewer than they write.
  void end_element()
  {
    if(m_has_lines)
      m_scanner.skip_line();
  }

  // A bound for the number of values to come.
  std::size_t maximum_number() const
  {
    return m_format == Format::TEXT ? m_scanner.rest().size() : m_bytes.size();
  }

  // Where in the file the latest value ends, and where the next one begins.
  std::size_t end() const
  {
    const std::string_view rest = m_format == Format::TEXT ? m_scanner.rest() : m_bytes;
    return std::size_t(rest.data() - m_file.data());
  }
  std::size_t next_begin() const
  {
    Text_scanner scanner = m_scanner;
    return m_format == Format::TEXT ? std::size_t(scanner.word().data() - m_file.data()) : end();
  }

private:
  static int to_index(double value)
  {
    if(!(value >= 0 && value <= INT_MAX) || value != std::floor(value))
      throw Failure(Exit_code::UNREADABLE, "a count or an index is not a number from 0 to "
                                             + std::to_string(INT_MAX));
    return int(value);
  }

  template <typename Number>
  double next_binary()
  {
    if(m_bytes.size() < sizeof(Number))
      throw Failure(Exit_code::UNREADABLE, "the file ends before its last element");
    const double result = double(load<Number>(m_bytes, m_format == Format::BIG));
    m_bytes.remove_prefix(sizeof(Number));
    return result;
  }

  Format m_format;
  Text_scanner m_scanner;
  std::string_view m_bytes; // that are not read yet
  std::string_view m_file;
  const bool m_has_lines; // whether each element of a text may have one
};

#endif // UNWRAP_PLY_VALUES_H
