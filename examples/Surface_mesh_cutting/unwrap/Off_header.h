// The first lines of an OFF file.

#ifndef UNWRAP_OFF_HEADER_H
#define UNWRAP_OFF_HEADER_H

#include "Text_scanner.h"

// The data of each point, in this order.
struct Off_header
{
  bool is_homogeneous = false; // a fourth coordinate, by which to divide
  bool has_normal = false, has_color = false, has_uv = false;
  bool has_dimension = false; // of the points, which follows
  bool is_binary = false;

  int number_of_coordinates() const { return is_homogeneous ? 4 : 3; }
};

// Whether a text that begins with this word is OFF.
bool starts_off(std::string_view word);

// Leaves the scanner behind the word OFF with its prefixes, in binary files where the numbers begin, in text where the
// counts do. Files that start with the counts have been seen, too, and many without a space between them and the word.
Off_header read_off_header(Text_scanner& scanner);

// Throws a `Failure` unless it is 3.
void check_off_dimension(int dimension);

#endif // UNWRAP_OFF_HEADER_H
