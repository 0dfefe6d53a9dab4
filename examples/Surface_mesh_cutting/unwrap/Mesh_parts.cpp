#include "Mesh_parts.h"

#include <array>
#include <cstddef>
#include <map>

namespace {

// What a line `KEYWORD NAME` sets, or null if it is none.
std::string* find_name(const std::string& keyword, std::array<std::string, 3>& names)
{
  return keyword == "o" ? &names[0] : keyword == "g" ? &names[1] : keyword == "usemtl" ? &names[2] : nullptr;
}

} // namespace

Mesh_parts find_parts(const Obj_statements& statements, int number_of_polygons)
{
  std::array<std::string, 3> names; // of object, group and material
  std::map<std::array<std::string, 3>, std::vector<int> > polygons;
  auto line = statements.lines.begin();
  std::vector<int>* part = nullptr; // to which the next polygon belongs
  for(int polygon = 0; polygon < number_of_polygons; ++polygon)
  {
    for(; line != statements.lines.end() && line->polygon <= polygon; ++line)
    {
      const std::size_t blank = line->text.find(' ');
      if(std::string* const name = find_name(line->text.substr(0, blank), names))
      {
        *name = blank == std::string::npos ? "" : line->text.substr(blank + 1);
        part = nullptr;
      }
    }
    if(part == nullptr)
      part = &polygons[names];
    part->push_back(polygon);
  }

  Mesh_parts result;
  result.polygon_parts.resize(std::size_t(number_of_polygons));
  for(const auto& [key, members] : polygons)
  {
    for(const int polygon : members)
      result.polygon_parts[std::size_t(polygon)] = int(result.parts.size());
    result.parts.push_back({key[0] + (key[0].empty() || key[1].empty() ? "" : " ") + key[1], key[2]});
  }
  return result;
}
