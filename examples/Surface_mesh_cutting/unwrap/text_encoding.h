#ifndef UNWRAP_TEXT_ENCODING_H
#define UNWRAP_TEXT_ENCODING_H

#include <string>

// A text in UTF-16, which starts with a byte order mark, in UTF-8 and without one. Everything else stays as it is.
std::string in_utf8(std::string bytes);

// Lines that end in a carriage return alone, as on old machines, end in a line feed: those of a text, or of the header of a
// PLY file with binary values.
std::string with_line_feeds(std::string bytes);

#endif // UNWRAP_TEXT_ENCODING_H
