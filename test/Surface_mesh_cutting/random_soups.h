// Soups of what programs write that is no mesh.

#ifndef RANDOM_SOUPS_H
#define RANDOM_SOUPS_H

#include "polygon_soups.h"

#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace test {

inline std::size_t random_index(std::size_t size, CGAL::Random& random) { return std::size_t(random.get_int(0, int(size))); }

inline std::array<double, 3> random_point(CGAL::Random& random)
{
  return {random.get_double(), random.get_double(), random.get_double()};
}

// A square with a square hole, which a bridge connects.
inline void add_keyhole(Soup& soup, CGAL::Random& random)
{
  const std::size_t first = soup.points.size();
  const double height = random.get_double();
  for(double r : {2., random.get_double(0.1, 1.4)})
    for(int i = 0; i < 4; ++i)
      soup.points.push_back({r * std::cos(CGAL_PI * i / 2), r * std::sin(CGAL_PI * i / 2), height});
  Polygon polygon = {first, first + 1, first + 2, first + 3, first, first + 4, first + 7, first + 6, first + 5, first + 4};
  std::rotate(polygon.begin(), polygon.begin() + random.get_int(0, 10), polygon.end());
  soup.faces.push_back(polygon);
}

// Any walk between the vertices.
inline void add_walk(Soup& soup, CGAL::Random& random)
{
  Polygon polygon;
  for(int k = random.get_int(1, 9); k > 0; --k)
    polygon.push_back(random_index(soup.points.size(), random));
  soup.faces.push_back(polygon);
}

// Three points on a line, or nearly.
inline void add_sliver(Soup& soup, CGAL::Random& random)
{
  const std::size_t first = soup.points.size();
  const std::array<double, 3> p = random_point(random), q = random_point(random);
  const double t = random.get_double(), shift = random.get_bool() ? 0 : 1e-12;
  soup.points.push_back(p);
  soup.points.push_back(q);
  soup.points.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2]) + shift});
  soup.faces.push_back({first, first + 1, first + 2});
}

// A copy of a polygon, from another corner on or reversed.
inline void add_copy(Soup& soup, CGAL::Random& random)
{
  Polygon polygon = soup.faces[random_index(soup.faces.size(), random)];
  if(random.get_bool())
    std::reverse(polygon.begin(), polygon.end());
  if(!polygon.empty())
    std::rotate(polygon.begin(), polygon.begin() + random.get_int(0, int(polygon.size())), polygon.end());
  soup.faces.push_back(polygon);
}

// Two triangles that have a vertex in common as one polygon.
inline void add_pinch(Soup& soup, CGAL::Random& random)
{
  const std::size_t first = soup.points.size();
  for(int i = 0; i < 5; ++i)
    soup.points.push_back(random_point(random));
  soup.faces.push_back({first, first + 1, first + 2, first, first + 3, first + 4});
}

inline void repeat_corner(Soup& soup, CGAL::Random& random)
{
  Polygon& polygon = soup.faces[random_index(soup.faces.size(), random)];
  if(!polygon.empty())
  {
    const std::size_t k = random_index(polygon.size(), random), vertex = polygon[k];
    polygon.insert(polygon.begin() + std::ptrdiff_t(k), std::size_t(random.get_int(1, 4)), vertex);
  }
}

inline void add_back(Soup& soup)
{
  const std::size_t number = soup.faces.size();
  for(std::size_t f = 0; f < number; ++f)
    soup.faces.emplace_back(soup.faces[f].rbegin(), soup.faces[f].rend());
}

// Makes one vertex of two.
inline void pinch_vertices(Soup& soup, CGAL::Random& random)
{
  const std::size_t v = random_index(soup.points.size(), random), w = random_index(soup.points.size(), random);
  for(Polygon& polygon : soup.faces)
    std::replace(polygon.begin(), polygon.end(), v, w);
}

inline Soup random_soup(CGAL::Random& random)
{
  Soup soup = random.get_bool() ? quads(random.get_int(1, 4), random.get_int(1, 4), false, false)
                                : whole_quads(random.get_int(1, 4), random.get_int(1, 4), false, false);
  for(int number = random.get_int(0, 6); number > 0; --number)
    switch(random.get_int(0, 8))
    {
    case 0: add_keyhole(soup, random); break;
    case 1: add_walk(soup, random); break;
    case 2: add_sliver(soup, random); break;
    case 3: add_copy(soup, random); break;
    case 4: add_pinch(soup, random); break;
    case 5: repeat_corner(soup, random); break;
    case 6: add_back(soup); break;
    case 7: pinch_vertices(soup, random); break;
    }
  soup.faces.push_back({0, 1, soup.points.size()});
  soup.points.push_back({-1, -1, -1}); // so that there is always a surface
  return soup;
}

} // namespace test

#endif // RANDOM_SOUPS_H
