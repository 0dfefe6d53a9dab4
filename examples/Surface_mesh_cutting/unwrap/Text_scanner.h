// Splits text into words and words into numbers.

#ifndef UNWRAP_TEXT_SCANNER_H
#define UNWRAP_TEXT_SCANNER_H

#include <cstddef>
#include <string>
#include <string_view>

// What some editors write in front of a text in UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

// A word as messages quote it: not long, and without what a terminal would interpret.
std::string printable(std::string_view word);

// For what is kept but not needed: NaN unless the word is a number.
double number_or_nan(std::string_view word);

// A `#` starts a comment, which ends with the line. An unexpected word is a
// `Failure` with `Exit_code::UNREADABLE` that names the line.
class Text_scanner
{
public:
  explicit Text_scanner(std::string_view text);

  // The next word; empty at the end of the text.
  std::string_view word();
  // The next word of the current line; empty if there is none.
  std::string_view word_in_line();
  // The end of the word that was read last becomes the next word.
  void put_back(std::string_view end) { m_text = {end.data(), m_text.size() + std::size_t(m_text.data() - end.data())}; }
  // What is left of the line, whatever it is, without blanks at both ends.
  std::string_view rest_of_line();
  // Leaves the current line.
  void skip_line();

  // The next word as a number. Whether it may be in a later line: `word()`, `word_in_line()`.
  double number() { return to_number(word()); }
  double number_in_line() { return to_number(word_in_line()); }
  // A non-negative integer that can serve as a count or as an index.
  int index() { return to_index(word()); }
  int index_in_line() { return to_index(word_in_line()); }

  double to_number(std::string_view word) const;
  int to_integer(std::string_view word) const;
  int to_index(std::string_view word) const;

  std::string_view rest() const { return m_text; }
  bool is_at_end() const { return m_text.empty(); }
  int line() const { return m_line; } // counted from 1
  std::size_t number_of_line_ends() const;

  // Throws the `Failure` that what is expected here is not `word`.
  [[noreturn]] void fail(const std::string& expected, std::string_view word) const;

private:
  bool is_blank(char c) const;
  bool is_word(char c) const;
  std::size_t length_of_continuation(std::size_t position) const;

  std::string_view m_text; // what is not read yet
  char m_line_end;
  int m_line = 1;
};

#endif // UNWRAP_TEXT_SCANNER_H
