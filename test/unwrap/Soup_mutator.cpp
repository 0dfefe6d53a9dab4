#include "Soup_mutator.h"

#include "to_soup.h"

#include <algorithm>
#include <map>
#include <utility>

Soup_mutator::Soup_mutator(const Polygon_soup& soup, std::uint64_t number) : m_points(soup.points), m_random(number)
{
  for(int polygon = 0; polygon < soup.number_of_polygons(); ++polygon)
  {
    const auto first = soup.corners.begin() + std::ptrdiff_t(soup.first_corner(polygon));
    m_polygons.emplace_back(first, first + soup.number_of_corners(polygon));
  }
}

void Soup_mutator::mutate()
{
  struct Kind { const char* name; void (Soup_mutator::*mutation)(); };
  static const std::vector<Kind> kinds = {
    {"dissolve edges", &Soup_mutator::dissolve_edges}, {"dissolve edges", &Soup_mutator::dissolve_edges},
    {"own points", &Soup_mutator::give_polygons_own_points}, {"split points", &Soup_mutator::split_points},
    {"pinch", &Soup_mutator::pinch}, {"touch along edge", &Soup_mutator::touch_along_edge},
    {"turn polygons", &Soup_mutator::turn_polygons}, {"repeat polygons", &Soup_mutator::repeat_polygons},
    {"spoil polygons", &Soup_mutator::spoil_polygons}};
  for(std::size_t i = 1 + pick(3); i > 0 && !m_polygons.empty(); --i)
  {
    const Kind& kind = kinds[pick(kinds.size())];
    (this->*kind.mutation)();
    m_description += std::string(", ") + kind.name;
  }
}

Polygon_soup Soup_mutator::soup() const { return to_soup(m_points, m_polygons); }

// Joins polygons to neighbors across one edge. What comes out need be neither flat nor convex.
void Soup_mutator::dissolve_edges()
{
  std::map<std::pair<int, int>, std::size_t> sides;
  for(std::size_t p = 0; p < m_polygons.size(); ++p)
    for(std::size_t k = 0; k < m_polygons[p].size(); ++k)
      sides[{m_polygons[p][k], m_polygons[p][(k + 1) % m_polygons[p].size()]}] = p;
  const std::size_t rounds = 1 + pick(3);
  std::vector<char> is_removed(m_polygons.size(), 0);
  for(std::size_t p = 0; p < m_polygons.size(); ++p)
    for(std::size_t round = 0; round < rounds && !is_removed[p] && !m_polygons[p].empty() && pick(8) > 0; ++round)
    {
      Polygon& polygon = m_polygons[p];
      const std::size_t k = pick(polygon.size());
      const int a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      const auto other = sides.find({b, a});
      if(other == sides.end() || other->second <= p || is_removed[other->second])
        continue;
      Polygon neighbor = m_polygons[other->second];
      std::rotate(neighbor.begin(), std::find(neighbor.begin(), neighbor.end(), a), neighbor.end());
      if(neighbor.size() < 3 || neighbor.back() != b)
        continue;
      polygon.insert(polygon.begin() + std::ptrdiff_t(k) + 1, neighbor.begin() + 1, neighbor.end() - 1);
      is_removed[other->second] = 1;
    }
  std::vector<Polygon> kept;
  for(std::size_t p = 0; p < m_polygons.size(); ++p)
    if(!is_removed[p])
      kept.push_back(m_polygons[p]);
  m_polygons = std::move(kept);
}

int Soup_mutator::copy_of_point(int v)
{
  if(v < 0 || v >= int(m_points.size()))
    return v; // a wrong index
  m_points.push_back(m_points[std::size_t(v)]);
  return int(m_points.size()) - 1;
}

void Soup_mutator::give_polygons_own_points()
{
  for(Polygon& polygon : m_polygons)
    for(int& v : polygon)
      v = copy_of_point(v);
  std::shuffle(m_polygons.begin(), m_polygons.end(), m_random);
}

void Soup_mutator::split_points()
{
  for(std::size_t i = 1 + pick(10); i > 0; --i)
    if(Polygon& polygon = pick_polygon(); !polygon.empty())
    {
      int& v = polygon[pick(polygon.size())];
      v = copy_of_point(v);
    }
}

void Soup_mutator::pinch()
{
  for(std::size_t i = 1 + pick(10); i > 0; --i)
  {
    const Polygon other = pick_polygon();
    if(Polygon& polygon = pick_polygon(); !polygon.empty() && !other.empty())
      polygon[pick(polygon.size())] = other[pick(other.size())];
  }
}

// A polygon more on an edge that has two.
void Soup_mutator::touch_along_edge()
{
  for(std::size_t i = 1 + pick(5); i > 0; --i)
  {
    const Polygon other = pick_polygon();
    if(other.size() < 3)
      continue;
    Polygon fin = {other[1], other[0], copy_of_point(other[2])};
    if(fin[2] >= 0 && fin[2] < int(m_points.size()))
      m_points[std::size_t(fin[2])][pick(3)] += 0.25;
    if(pick(2) == 0)
      std::reverse(fin.begin(), fin.end());
    m_polygons.insert(m_polygons.begin() + std::ptrdiff_t(pick(m_polygons.size())), fin);
  }
}

void Soup_mutator::turn_polygons()
{
  const std::size_t share = 1 + pick(5);
  for(Polygon& polygon : m_polygons)
    if(pick(share) == 0)
      std::reverse(polygon.begin(), polygon.end());
}

void Soup_mutator::repeat_polygons()
{
  for(std::size_t i = 1 + pick(4); i > 0; --i)
  {
    Polygon polygon = pick_polygon();
    std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t(pick(polygon.size() + 1)), polygon.end());
    if(pick(3) == 0)
      std::reverse(polygon.begin(), polygon.end());
    m_polygons.push_back(polygon);
  }
}

// Corners left out or given twice.
void Soup_mutator::spoil_polygons()
{
  for(std::size_t i = 1 + pick(4); i > 0; --i)
  {
    Polygon& polygon = pick_polygon();
    if(polygon.empty() || pick(6) == 0)
      polygon.clear();
    else if(pick(2) == 0)
      polygon.erase(polygon.begin() + std::ptrdiff_t(pick(polygon.size())));
    else
      polygon.insert(polygon.begin() + std::ptrdiff_t(pick(polygon.size())), polygon[pick(polygon.size())]);
  }
}
