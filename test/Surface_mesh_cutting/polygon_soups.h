// Soups of polygons with any number of corners, and such as are no manifolds.

#ifndef POLYGON_SOUPS_H
#define POLYGON_SOUPS_H

#include "soups.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace test {

using Polygon = std::vector<std::size_t>;

// m by n squares, which are not halved.
inline Soup whole_quads(int m, int n, bool is_closed_m, bool is_closed_n)
{
  Soup soup = quads(m, n, is_closed_m, is_closed_n);
  std::vector<Polygon> faces;
  for(std::size_t f = 0; f < soup.faces.size(); f += 2)
    faces.push_back({soup.faces[f][0], soup.faces[f][1], soup.faces[f][2], soup.faces[f + 1][2]});
  soup.faces = faces;
  return soup;
}

// A prism over a star of n rays: two concave polygons, and a rectangle for each side.
inline Soup star_prism(int n)
{
  Soup soup;
  Polygon low, high;
  for(int i = 0; i < 2 * n; ++i)
    for(double z : {0., 1.})
      soup.points.push_back({(1 + i % 2) * std::cos(CGAL_PI * i / n), (1 + i % 2) * std::sin(CGAL_PI * i / n), z});
  for(int i = 0; i < 2 * n; ++i)
  {
    const std::size_t a = 2 * i, b = 2 * ((i + 1) % (2 * n));
    soup.faces.push_back({a, b, b + 1, a + 1});
    low.insert(low.begin(), a);
    high.push_back(a + 1);
  }
  soup.faces.push_back(low);
  soup.faces.push_back(high);
  return soup;
}

// With a vertex of two polygons in the middle of each edge.
inline Soup with_midpoints(Soup soup)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
  for(Polygon& polygon : soup.faces)
  {
    Polygon finer;
    for(std::size_t k = 0; k < polygon.size(); ++k)
    {
      const std::size_t a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      const auto inserted = midpoints.emplace(std::minmax(a, b), soup.points.size());
      if(inserted.second)
      {
        const std::array<double, 3> p = soup.points[a], q = soup.points[b];
        soup.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      }
      finer.push_back(a);
      finer.push_back(inserted.first->second);
    }
    polygon = finer;
  }
  return soup;
}

// A strip of n squares with a half turn; the last vertices are the first ones, exchanged.
inline Soup moebius_strip(int n)
{
  Soup soup;
  for(int i = 0; i < n; ++i)
    for(double t : {-0.4, 0., 0.4})
    {
      const double a = 2 * CGAL_PI * i / n;
      soup.points.push_back({(1 + t * std::cos(a / 2)) * std::cos(a), (1 + t * std::cos(a / 2)) * std::sin(a),
                             t * std::sin(a / 2)});
    }
  const auto vertex = [n](int i, int j) { return std::size_t(i < n ? 3 * i + j : 3 * (i - n) + 2 - j); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < 2; ++j)
      soup.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  return soup;
}

// k sheets of n squares at one line.
inline Soup book(int k, int n)
{
  Soup soup;
  for(int j = 0; j <= n; ++j)
    soup.points.push_back({0, 0, double(j)});
  for(int i = 0; i < k; ++i)
  {
    const std::size_t first = soup.points.size();
    for(int j = 0; j <= n; ++j)
      soup.points.push_back({std::cos(2 * CGAL_PI * i / k), std::sin(2 * CGAL_PI * i / k), double(j)});
    for(std::size_t j = 0; j < std::size_t(n); ++j)
      soup.faces.push_back({j, first + j, first + j + 1, j + 1});
  }
  return soup;
}

inline Soup tetrahedron(std::size_t a, std::size_t b, std::size_t c, std::size_t d)
{
  Soup soup;
  soup.faces = {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
  return soup;
}

inline Soup without_indices(const Soup& soup)
{
  Soup result;
  for(const Polygon& polygon : soup.faces)
  {
    result.faces.emplace_back();
    for(const std::size_t v : polygon)
    {
      result.faces.back().push_back(result.points.size());
      result.points.push_back(soup.points[v]);
    }
  }
  return result;
}

} // namespace test

#endif // POLYGON_SOUPS_H
