#include "point_uvs.h"

#include <cstddef>

void set_corner_uvs(const Point_uvs& uvs, Polygon_soup& soup)
{
  soup.corner_uvs.clear();
  for(const int point : soup.corners)
    soup.corner_uvs.push_back(point >= 0 && std::size_t(point) < uvs.size() ? uvs[std::size_t(point)] : std::nullopt);
}
