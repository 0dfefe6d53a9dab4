#ifndef UNWRAP_TO_SOUP_H
#define UNWRAP_TO_SOUP_H

#include "Polygon_soup.h"

#include <vector>

// `Polygon`: a range of point indices.
template <typename Polygon>
Polygon_soup to_soup(const std::vector<Polygon_soup::Point>& points, const std::vector<Polygon>& polygons)
{
  Polygon_soup soup;
  soup.points = points;
  for(const Polygon& polygon : polygons)
  {
    soup.corners.insert(soup.corners.end(), polygon.begin(), polygon.end());
    soup.close_polygon();
  }
  return soup;
}

#endif // UNWRAP_TO_SOUP_H
