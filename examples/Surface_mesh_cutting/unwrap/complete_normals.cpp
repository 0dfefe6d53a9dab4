#include "complete_normals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

void complete_normals(Polygon_soup& soup)
{
  const auto is_finite = [](const std::array<double, 3>& normal)
  { return std::all_of(normal.begin(), normal.end(), [](double x) { return std::isfinite(x); }); };
  const auto is_none = [](int normal) { return normal < 0; };

  for(int& normal : soup.corner_normals)
    if(normal >= int(soup.normals.size()) || (normal >= 0 && !is_finite(soup.normals[std::size_t(normal)])))
      normal = -1;
  for(std::array<double, 3>& normal : soup.normals)
    if(!is_finite(normal))
      normal = {{0, 0, 0}};
  if(std::all_of(soup.corner_normals.begin(), soup.corner_normals.end(), is_none))
  {
    soup.corner_normals.clear();
    soup.normals.clear();
  }
  else
    soup.kinds.insert(Data_kind::NORMALS);
}
