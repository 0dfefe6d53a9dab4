// Corners given by their coordinates, as in formats without indices.

#ifndef UNWRAP_POINT_MERGER_H
#define UNWRAP_POINT_MERGER_H

#include "Polygon_soup.h"

#include <boost/functional/hash.hpp>

#include <unordered_map>

// Gives exactly equal points the same index, in the order of their first appearance, or each an index of its own.
class Point_merger
{
public:
  Point_merger(Polygon_soup& soup, bool does_merge) : m_soup(soup), m_does_merge(does_merge) {}

  void add_corner(double x, double y, double z)
  {
    const Polygon_soup::Point point = {{x + 0.0, y + 0.0, z + 0.0}}; // -0 becomes 0
    if(!m_does_merge)
    {
      m_soup.corners.push_back(m_soup.number_of_points());
      m_soup.points.push_back(point);
      return;
    }
    const auto inserted = m_indices.emplace(point, m_soup.number_of_points());
    if(inserted.second)
      m_soup.points.push_back(point);
    m_soup.corners.push_back(inserted.first->second);
  }

private:
  Polygon_soup& m_soup;
  const bool m_does_merge;
  std::unordered_map<Polygon_soup::Point, int, boost::hash<Polygon_soup::Point> > m_indices;
};

#endif // UNWRAP_POINT_MERGER_H
