// Random changes to polygons by which they cease to be a mesh of triangles, as many files are none.

#ifndef SOUP_MUTATOR_H
#define SOUP_MUTATOR_H

#include "Polygon_soup.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

// The same number gives the same mutation.
class Soup_mutator
{
public:
  Soup_mutator(const Polygon_soup& soup, std::uint64_t number);

  // One to three mutations.
  void mutate();

  Polygon_soup soup() const;

  // The kinds of mutations that were done, each behind a comma.
  const std::string& description() const { return m_description; }

private:
  using Polygon = std::vector<int>;

  void dissolve_edges();
  void give_polygons_own_points();
  void split_points();
  void pinch();
  void touch_along_edge();
  void turn_polygons();
  void repeat_polygons();
  void spoil_polygons();

  std::size_t pick(std::size_t n) { return std::size_t(m_random() % n); }
  Polygon& pick_polygon() { return m_polygons[pick(m_polygons.size())]; }
  int copy_of_point(int v);

  std::vector<Polygon_soup::Point> m_points;
  std::vector<Polygon> m_polygons;
  std::mt19937_64 m_random;
  std::string m_description;
};

#endif // SOUP_MUTATOR_H
