// Text with many numbers, put together quickly.

#ifndef UNWRAP_NUMBER_WRITER_H
#define UNWRAP_NUMBER_WRITER_H

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

// A number to be written with two digits behind the point: enough for pictures.
struct Coarse
{
  double number;
};

class Number_writer
{
public:
  Number_writer& operator<<(std::string_view text)
  {
    m_text += text;
    return *this;
  }
  Number_writer& operator<<(int number)
  {
    append([=](char* first, char* last) { return std::to_chars(first, last, number); });
    return *this;
  }
  // 17 significant digits: enough to read back the same number.
  Number_writer& operator<<(double number)
  {
    append([=](char* first, char* last) {
      return std::to_chars(first, last, number, std::chars_format::general, 17); });
    return *this;
  }
  Number_writer& operator<<(Coarse coarse)
  {
    append([=](char* first, char* last) {
      return std::to_chars(first, last, double(std::llround(coarse.number * 100)) / 100); });
    return *this;
  }

  // Makes room for more text.
  void reserve(std::size_t length) { m_text.reserve(m_text.size() + length); }

  const std::string& text() const & { return m_text; }
  std::string text() && { return std::move(m_text); }

private:
  template <typename Convert>
  void append(Convert convert)
  {
    char buffer[64];
    m_text.append(buffer, convert(buffer, buffer + sizeof(buffer)).ptr);
  }

  std::string m_text;
};

#endif // UNWRAP_NUMBER_WRITER_H
