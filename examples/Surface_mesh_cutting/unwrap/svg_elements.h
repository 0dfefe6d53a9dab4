// Elements of SVG that several drawings use.

#ifndef UNWRAP_SVG_ELEMENTS_H
#define UNWRAP_SVG_ELEMENTS_H

#include "Number_writer.h"

#include <array>
#include <string_view>

// A piece of a path.
inline void draw_line(const std::array<double, 2>& from, const std::array<double, 2>& to, Number_writer& out)
{
  out << "M" << Coarse{from[0]} << " " << Coarse{from[1]}
      << "L" << Coarse{to[0]} << " " << Coarse{to[1]};
}

// `anchor` is start, middle or end.
inline void write_text(double x, double y, const char* anchor, std::string_view text, Number_writer& out)
{
  out << "<text x=\"" << Coarse{x} << "\" y=\"" << Coarse{y} << "\" text-anchor=\"" << anchor
      << "\">" << text << "</text>\n";
}

#endif // UNWRAP_SVG_ELEMENTS_H
