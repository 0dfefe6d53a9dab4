#include "check_layout.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Segment = std::array<Point, 2>;

bool is_the_surface(const Layout& layout, const Polygon_soup& soup)
{
  const auto is_uv_point = [&](int uv) { return uv >= 0 && uv < int(layout.uv_points.size()); };
  return layout.points == soup.points && layout.corners == soup.corners && layout.polygon_ends == soup.polygon_ends
         && layout.corner_uvs.size() == soup.corners.size()
         && std::all_of(layout.corner_uvs.begin(), layout.corner_uvs.end(), is_uv_point)
         && layout.uv_triangles.size() == layout.triangles.size() && !layout.triangles.empty();
}

bool is_finite(const std::array<double, 2>& uv) { return std::isfinite(uv[0]) && std::isfinite(uv[1]); }

// The edges between UV vertices, and how many triangles each has.
std::map<std::array<int, 2>, int> count_sides(const Layout& layout)
{
  std::map<std::array<int, 2>, int> sides;
  for(const Layout::Triangle& t : layout.uv_triangles)
    for(std::size_t k = 0; k < 3; ++k)
      ++sides[{{(std::min)(t[k], t[(k + 1) % 3]), (std::max)(t[k], t[(k + 1) % 3])}}];
  return sides;
}

// Euler's formula for each chart.
bool are_disks(const Layout& layout, const std::map<std::array<int, 2>, int>& sides)
{
  boost::disjoint_sets_with_storage<> charts(layout.uv_points.size());
  for(const auto& side : sides)
    charts.union_set(side.first[0], side.first[1]);
  std::map<int, int> characteristics;
  for(std::size_t v = 0; v < layout.uv_points.size(); ++v)
    ++characteristics[int(charts.find_set(int(v)))];
  for(const auto& side : sides)
    --characteristics[int(charts.find_set(side.first[0]))];
  for(const Layout::Triangle& t : layout.uv_triangles)
    ++characteristics[int(charts.find_set(t[0]))];
  return std::all_of(characteristics.begin(), characteristics.end(),
                     [](const std::pair<const int, int>& c) { return c.second == 1; });
}

bool do_cross(const Segment& s, const Segment& t)
{
  const auto separates = [](const Segment& a, const Segment& b)
  { return CGAL::orientation(a[0], a[1], b[0]) * CGAL::orientation(a[0], a[1], b[1]) < 0; };
  return separates(s, t) && separates(t, s);
}

bool has_crossing(const std::vector<Segment>& border)
{
  for(std::size_t i = 0; i < border.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(do_cross(border[i], border[j]))
        return true;
  return false;
}

} // namespace

std::string find_fault(const Layout& layout, const Polygon_soup& soup, bool is_bijective)
{
  if(!is_the_surface(layout, soup))
    return "the layout has another surface";
  if(!std::all_of(layout.uv_points.begin(), layout.uv_points.end(), is_finite))
    return "a coordinate is not finite";
  std::vector<Point> points;
  for(const std::array<double, 2>& uv : layout.uv_points)
    points.emplace_back(uv[0], uv[1]);
  for(const Layout::Triangle& t : layout.uv_triangles)
    if(CGAL::orientation(points[std::size_t(t[0])], points[std::size_t(t[1])], points[std::size_t(t[2])])
       != CGAL::LEFT_TURN)
      return "a triangle is flipped";

  const std::map<std::array<int, 2>, int> sides = count_sides(layout);
  if(!are_disks(layout, sides))
    return "a chart is not a disk";
  std::vector<Segment> border;
  for(const auto& side : sides)
    if(side.second == 1)
      border.push_back({{points[std::size_t(side.first[0])], points[std::size_t(side.first[1])]}});
  if(is_bijective && has_crossing(border))
    return "the layout overlaps itself";
  return "";
}
