#include "painted_colors.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <system_error>

void read_painted_colors(std::string_view comment, Colors& colors)
{
  constexpr std::string_view start = "#MRGB ";
  constexpr std::size_t size = 8;
  if(comment.substr(0, start.size()) != start)
    return;
  for(std::string_view rest = comment.substr(start.size()); rest.size() >= size; rest.remove_prefix(size))
  {
    std::uint32_t value = 0;
    const std::from_chars_result parsed = std::from_chars(rest.data(), rest.data() + size, value, 16);
    if(parsed.ec != std::errc() || parsed.ptr != rest.data() + size)
      return;
    const auto channel = [&](int shift) { return (value >> shift & 255) / 255.; };
    colors.push_back({{channel(16), channel(8), channel(0)}});
  }
}

void add_painted_colors(const Colors& colors, Polygon_soup& soup)
{
  if(!soup.colors.empty() || colors.empty() || colors.size() != soup.points.size())
    return;
  soup.colors = colors;
  soup.kinds.insert(Data_kind::COLORS);
  soup.obj_statements.point_ends.resize(soup.points.size()); // an OBJ has the comments
}
