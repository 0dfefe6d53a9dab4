// Surfaces as points and faces.

#ifndef SOUPS_H
#define SOUPS_H

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test {

struct Soup
{
  std::vector<std::array<double, 3> > points;
  std::vector<std::vector<std::size_t> > faces;

  void scale(double factor)
  {
    for(std::array<double, 3>& p : points)
      for(double& x : p)
        x *= factor;
  }

  // Side by side.
  void add(const Soup& other)
  {
    const std::size_t first = points.size();
    for(std::array<double, 3> p : other.points)
    {
      p[2] += 10;
      points.push_back(p);
    }
    for(std::vector<std::size_t> f : other.faces)
    {
      for(std::size_t& v : f)
        v += first;
      faces.push_back(f);
    }
  }
};

// m by n squares, halved; closed in none, one or both directions.
inline Soup quads(int m, int n, bool is_closed_m, bool is_closed_n)
{
  Soup soup;
  const int rows = m + !is_closed_m, columns = n + !is_closed_n;
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
    {
      const double a = 2 * CGAL_PI * i / m, b = 2 * CGAL_PI * j / n;
      if(is_closed_m && is_closed_n)
        soup.points.push_back({(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)});
      else if(is_closed_m)
        soup.points.push_back({std::cos(a), std::sin(a), double(j)});
      else
        soup.points.push_back({double(i), double(j), 0.1 * i * j});
    }
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j)
    {
      const std::size_t a = i * columns + j, b = (i + 1) % rows * columns + j;
      const std::size_t c = (i + 1) % rows * columns + (j + 1) % columns, d = i * columns + (j + 1) % columns;
      soup.faces.push_back({a, b, c});
      soup.faces.push_back({a, c, d});
    }
  return soup;
}

inline Soup torus(int m, int n) { return quads(m, n, true, true); }
inline Soup tube(int m, int n) { return quads(m, n, true, false); }
inline Soup patch(int m, int n) { return quads(m, n, false, false); }

// A tube with both ends closed by a fan.
inline Soup sphere(int m, int n)
{
  Soup soup = tube(m, n);
  const std::size_t low = soup.points.size(), high = low + 1;
  soup.points.push_back({0, 0, -1});
  soup.points.push_back({0, 0, n + 1.});
  for(int i = 0; i < m; ++i)
  {
    const std::size_t a = i * (n + 1), b = (i + 1) % m * (n + 1);
    soup.faces.push_back({b, a, low});
    soup.faces.push_back({a + n, b + n, high});
  }
  return soup;
}

// A sphere with bumps: `n` rings, smooth, no two parts alike.
inline Soup bumpy_sphere(int n)
{
  Soup soup = sphere(2 * n, n);
  for(std::array<double, 3>& p : soup.points)
  {
    const double polar = CGAL_PI * (p[2] + 1) / (n + 2), around = std::atan2(p[1], p[0]);
    const double radius = 1 + 0.5 * std::sin(3 * polar) * std::cos(2 * around) + 0.3 * std::cos(5 * polar);
    p = {radius * std::sin(polar) * std::cos(around), radius * std::sin(polar) * std::sin(around),
         1.5 * radius * std::cos(polar)};
  }
  return soup;
}

} // namespace test

#endif // SOUPS_H
