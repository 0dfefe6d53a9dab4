// Surfaces with random handles and holes.

#ifndef RANDOM_SURFACES_H
#define RANDOM_SURFACES_H

#include "surface_meshes.h"

#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace test {

// Takes faces out of a closed surface, no two of which have neighboring vertices, so that what is
// put in their places never makes an edge twice.
class Surgery
{
public:
  Surgery(Soup& soup, CGAL::Random& random)
    : m_soup(soup), m_random(random), m_neighbors(soup.points.size()),
      m_is_taken(soup.points.size(), false)
  {
    for(const std::vector<std::size_t>& f : soup.faces)
      for(std::size_t v : f)
        m_neighbors[v].insert(f.begin(), f.end());
  }

  bool add_hole()
  {
    std::vector<std::size_t> corners;
    return take_face(corners);
  }

  // A tube between two faces.
  bool add_handle()
  {
    std::vector<std::size_t> a, b;
    if(!take_face(a))
      return false;
    if(!take_face(b))
    {
      m_soup.faces.push_back(a);
      return false;
    }
    std::reverse(b.begin(), b.end());
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      m_soup.faces.push_back({a[i], a[j], b[j]});
      m_soup.faces.push_back({a[i], b[j], b[i]});
    }
    return true;
  }

private:
  bool take_face(std::vector<std::size_t>& corners)
  {
    std::vector<std::size_t> candidates;
    const auto is_taken = [this](std::size_t v) { return m_is_taken[v]; };
    for(std::size_t f = 0; f < m_soup.faces.size(); ++f)
      if(std::none_of(m_soup.faces[f].begin(), m_soup.faces[f].end(), is_taken))
        candidates.push_back(f);
    if(candidates.empty())
      return false;
    const std::size_t f = candidates[m_random.uniform_int(0, int(candidates.size()) - 1)];
    corners = m_soup.faces[f];
    m_soup.faces.erase(m_soup.faces.begin() + f);
    for(std::size_t v : corners)
      for(std::size_t w : m_neighbors[v])
        m_is_taken[w] = true;
    return true;
  }

  Soup& m_soup;
  CGAL::Random& m_random;
  std::vector<std::set<std::size_t> > m_neighbors;
  std::vector<bool> m_is_taken;
};

struct Random_surface
{
  Soup soup;
  int genus = 0;
  int borders = 0;
};

// A bumpy sphere of m by n squares with as many of the handles and holes as there is room for.
inline Random_surface random_surface(int m, int n, int handles, int holes, CGAL::Random& random)
{
  Random_surface surface;
  surface.soup = sphere(m, n);
  for(std::array<double, 3>& p : surface.soup.points)
    for(double& x : p)
      x *= random.get_double(0.9, 1.1);
  Surgery surgery(surface.soup, random);
  for(int i = 0; i < handles && surgery.add_handle(); ++i)
    ++surface.genus;
  for(int i = 0; i < holes && surgery.add_hole(); ++i)
    ++surface.borders;
  return surface;
}

} // namespace test

#endif // RANDOM_SURFACES_H
