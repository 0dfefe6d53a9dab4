// Polygons in the plane by exact arithmetic, one pair after the other.

#ifndef EXACT_OUTLINES_H
#define EXACT_OUTLINES_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <vector>

namespace test {

using Exact_kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
using Exact_point = Exact_kernel::Point_2;
using Outline = std::vector<Exact_point>; // it may touch itself

inline const Exact_point& after(const Outline& outline, std::size_t i) { return outline[(i + 1) % outline.size()]; }

inline CGAL::Exact_rational signed_area(const Outline& outline)
{
  CGAL::Exact_rational twice = 0;
  for(std::size_t i = 0; i < outline.size(); ++i)
    twice += outline[i].x() * after(outline, i).y() - outline[i].y() * after(outline, i).x();
  return twice / 2;
}

// Whether two segments have one point in common that is an end of neither.
inline bool cross(const Exact_point& a, const Exact_point& b, const Exact_point& c, const Exact_point& d)
{
  const auto side = [](const Exact_point& p, const Exact_point& q, const Exact_point& r)
  { return int(CGAL::orientation(p, q, r)); };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

// How often an outline turns around a point that is not on it.
inline int winding_number(const Outline& outline, const Exact_point& p)
{
  int number = 0;
  for(std::size_t i = 0; i < outline.size(); ++i)
  {
    const Exact_point& a = outline[i];
    const Exact_point& b = after(outline, i);
    const bool is_up = a.y() <= p.y() && p.y() < b.y(), is_down = b.y() <= p.y() && p.y() < a.y();
    const auto turn = CGAL::orientation(a, b, p);
    number += is_up && turn == CGAL::LEFT_TURN ? 1 : is_down && turn == CGAL::RIGHT_TURN ? -1 : 0;
  }
  return number;
}

inline bool is_on(const Outline& outline, const Exact_point& p)
{
  for(std::size_t i = 0; i < outline.size(); ++i)
    if(CGAL::collinear(outline[i], after(outline, i), p) && CGAL::collinear_are_ordered_along_line(outline[i], p, after(outline, i)))
      return true;
  return false;
}

// A point inside, beside the first side that can be seen from there.
inline Exact_point inner_point(const Outline& outline)
{
  for(std::size_t i = 0; i < outline.size(); ++i)
  {
    const Exact_point& a = outline[i];
    const Exact_point& b = after(outline, i);
    const Exact_point middle = CGAL::midpoint(a, b);
    Exact_kernel::Vector_2 inward(a.y() - b.y(), b.x() - a.x());
    for(int halvings = 0; halvings < 80; ++halvings, inward = inward / 2)
      if(const Exact_point p = middle + inward; !is_on(outline, p) && winding_number(outline, p) == 1)
        return p;
  }
  return outline.front();
}

// Whether two outlines, or an outline and itself, cover a point twice.
inline bool overlap(const Outline& a, const Outline& b, bool is_same)
{
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t j = 0; j < b.size(); ++j)
      if(cross(a[i], after(a, i), b[j], after(b, j)))
        return true;
  if(is_same)
    return winding_number(a, inner_point(a)) != 1;
  return winding_number(b, inner_point(a)) != 0 || winding_number(a, inner_point(b)) != 0;
}

} // namespace test

#endif // EXACT_OUTLINES_H
