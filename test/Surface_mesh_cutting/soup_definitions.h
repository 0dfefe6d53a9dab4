// What the definitions say about a soup whose polygons visit no vertex twice, by brute force.

#ifndef SOUP_DEFINITIONS_H
#define SOUP_DEFINITIONS_H

#include "polygon_soups.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test {

// Neighboring corners at the same vertex count as one.
inline Polygon without_repetitions(Polygon polygon)
{
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while(polygon.size() > 1 && polygon.back() == polygon.front())
    polygon.pop_back();
  return polygon;
}

// Of those whose corners are at different vertices, or which lead there and back.
inline bool is_degenerate(const Polygon& polygon)
{
  return std::set<std::size_t>(polygon.begin(), polygon.end()).size() < 3;
}

inline Polygon from_lowest(Polygon polygon)
{
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  return polygon;
}

inline bool are_reverse(const Polygon& polygon, Polygon other)
{
  std::reverse(other.begin(), other.end());
  return from_lowest(without_repetitions(polygon)) == from_lowest(without_repetitions(other));
}

// The interpretation of a soup, as far as it does not depend on how sheets are connected.
struct Brute_force
{
  std::vector<std::size_t> degenerate, duplicates, non_manifold_vertices;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t> > edges; // polygons of the surface at them
  std::set<std::size_t> left_out;

  explicit Brute_force(const Soup& soup)
  {
    std::set<Polygon> former;
    std::map<std::size_t, std::set<std::size_t> > polygons_at;
    for(std::size_t p = 0; p < soup.faces.size(); ++p)
    {
      const Polygon polygon = without_repetitions(soup.faces[p]);
      if(is_degenerate(polygon))
        degenerate.push_back(p);
      else if(!former.insert(from_lowest(polygon)).second)
        duplicates.push_back(p);
      else
        for(std::size_t k = 0; k < polygon.size(); ++k)
        {
          edges[std::minmax({polygon[k], polygon[(k + 1) % polygon.size()]})].push_back(p);
          polygons_at[polygon[k]].insert(p);
        }
    }
    left_out.insert(degenerate.begin(), degenerate.end());
    left_out.insert(duplicates.begin(), duplicates.end());
    for(const auto& [v, polygons] : polygons_at)
      if(!hang_together(v, polygons))
        non_manifold_vertices.push_back(v);
  }

  bool hang_together(std::size_t v, const std::set<std::size_t>& polygons) const
  {
    std::set<std::size_t> reached = {*polygons.begin()};
    for(std::size_t size = 0; size < reached.size();)
    {
      size = reached.size();
      for(const auto& [edge, at_edge] : edges)
        if((edge.first == v || edge.second == v) &&
           std::any_of(at_edge.begin(), at_edge.end(), [&](std::size_t p) { return reached.count(p) > 0; }))
          reached.insert(at_edge.begin(), at_edge.end());
    }
    return reached.size() == polygons.size();
  }
};

} // namespace test

#endif // SOUP_DEFINITIONS_H
