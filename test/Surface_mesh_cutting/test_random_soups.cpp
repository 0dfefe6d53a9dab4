// Random soups with all that goes wrong: what is written is checked with exact arithmetic, independently of how the
// soup is read. Every polygon with area has UVs of this orientation, and no two of these polygons overlap.

#include "../BGL/check.h"
#include "exact_outlines.h"
#include "random_soups.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrapped_polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/unwrap_polygon_soup.h>

#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace random_soups_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using Kernel = CGAL::Simple_cartesian<double>;
using test::Polygon;
using test::Soup;
using Kind = SMC::Interpretation_kind;
using Corner_uvs = std::vector<std::vector<Kernel::Point_2> >;

std::set<std::size_t> polygons(const SMC::Unwrap_soup_result& result, Kind kind)
{
  for(const SMC::Interpretation& i : result.interpreted)
    if(i.kind == kind)
      return std::set<std::size_t>(i.polygons.begin(), i.polygons.end());
  return {};
}

// Whether each side is there as often in both directions, so that the area vector is zero wherever the points are.
bool leads_there_and_back(const Polygon& polygon)
{
  std::map<std::pair<std::size_t, std::size_t>, int> sums;
  for(std::size_t k = 0; k < polygon.size(); ++k)
  {
    const std::size_t a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    if(a != b)
      sums[std::minmax(a, b)] += a < b ? 1 : -1;
  }
  return std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second == 0; });
}

Polygon from_least(Polygon polygon)
{
  Polygon least = polygon;
  for(std::size_t k = 0; k < polygon.size(); ++k)
  {
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    least = (std::min)(least, polygon);
  }
  return least;
}

// Of corners without those that repeat their neighbor.
std::vector<std::size_t> outline(const Polygon& polygon)
{
  std::vector<std::size_t> corners;
  for(std::size_t k = 0; k < polygon.size(); ++k)
    if(corners.empty() || polygon[corners.back()] != polygon[k])
      corners.push_back(k);
  while(corners.size() > 1 && polygon[corners.back()] == polygon[corners.front()])
    corners.pop_back();
  return corners;
}

// The same without corners that lead to a vertex and back, if that visits no vertex twice.
std::vector<std::size_t> reduced_outline(const Polygon& polygon)
{
  std::vector<std::size_t> corners = outline(polygon);
  for(std::size_t i = 0, steps = 0; steps < corners.size(); ++steps, ++i)
  {
    const std::size_t n = corners.size(), former = (i % n + n - 1) % n, next = (i % n + 1) % n;
    if(n > 2 && polygon[corners[former]] == polygon[corners[next]])
    {
      corners.erase(corners.begin() + std::ptrdiff_t((std::max)(i % n, next)));
      corners.erase(corners.begin() + std::ptrdiff_t((std::min)(i % n, next)));
      steps = std::size_t(-1);
    }
  }
  std::set<std::size_t> vertices;
  for(std::size_t k : corners)
    vertices.insert(polygon[k]);
  return vertices.size() == corners.size() ? corners : outline(polygon);
}

// The loops with three corners or more that a walk closes.
std::vector<std::vector<std::size_t> > loops(const Polygon& polygon)
{
  std::vector<std::vector<std::size_t> > result;
  std::vector<std::size_t> open;
  const auto close = [&](std::size_t begin)
  {
    if(open.size() >= begin + 3)
      result.emplace_back(open.begin() + std::ptrdiff_t(begin), open.end());
    open.resize(begin);
  };
  for(std::size_t corner : outline(polygon))
  {
    for(std::size_t i = 0; i < open.size(); ++i)
      if(polygon[open[i]] == polygon[corner])
        close(i);
    open.push_back(corner);
  }
  close(0);
  return result;
}

void check_soup(const std::string& name, const Soup& soup, std::size_t& number_of_outlines)
{
  std::vector<Kernel::Point_3> points;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  Corner_uvs uvs;
  const auto np = CGAL::parameters::do_bijective(true).effort(SMC::Effort::FAST);
  const SMC::Unwrap_soup_result result = SMC::unwrap_polygon_soup(points, soup.faces, uvs, np);
  CHECK(result && result.flips == 0 && result.overlaps == 0, name + ": " + result.status.message);
  if(!result.has_result)
    return;
  const SMC::Result_status<SMC::Polygon_soup> certificate
    = SMC::certify_unwrapped_polygon_soup(points, soup.faces, uvs, CGAL::parameters::do_bijective(true));
  CHECK(certificate, name + ": certificate: " + certificate.message);

  const std::set<std::size_t> flat = polygons(result, Kind::DEGENERATE_FACES), duplicates = polygons(result, Kind::DUPLICATE_FACES),
                              turned = polygons(result, Kind::REORIENTED_FACES), divided = polygons(result, Kind::DIVIDED_FACES);
  std::set<Polygon> former;
  std::vector<test::Outline> outlines;
  for(std::size_t p = 0; p < soup.faces.size(); ++p)
  {
    const Polygon& polygon = soup.faces[p];
    if(flat.count(p) > 0)
    {
      CHECK(leads_there_and_back(polygon), name + ": a polygon without area");
      continue;
    }
    std::vector<std::vector<std::size_t> > parts = divided.count(p) > 0 ? loops(polygon)
                                                 : std::vector<std::vector<std::size_t> >{reduced_outline(polygon)};
    for(const std::vector<std::size_t>& part : parts)
    {
      Polygon vertices;
      test::Outline of_uvs;
      for(std::size_t k : part)
      {
        vertices.push_back(polygon[k]);
        of_uvs.emplace_back(uvs[p][k].x(), uvs[p][k].y());
      }
      if(!former.insert(from_least(vertices)).second)
      {
        CHECK(duplicates.count(p) > 0, name + ": a duplicate is reported");
        continue; // it lies where the former one does, as the certificate says
      }
      if(turned.count(p) > 0)
        std::reverse(of_uvs.begin(), of_uvs.end());
      // The loops of a polygon may be turned independently; the report names the polygon alone.
      if(parts.size() > 1 && test::signed_area(of_uvs) < 0 && turned.count(p) > 0)
        std::reverse(of_uvs.begin(), of_uvs.end());
      CHECK(test::signed_area(of_uvs) > 0, name + ": orientation of polygon " + std::to_string(p));
      outlines.push_back(of_uvs);
    }
  }
  number_of_outlines += outlines.size();
  for(std::size_t i = 0; i < outlines.size(); ++i)
    for(std::size_t j = 0; j <= i; ++j)
      CHECK(!test::overlap(outlines[i], outlines[j], i == j), name + ": overlap of " + std::to_string(j) + " and " + std::to_string(i));
}

} // namespace random_soups_test

int main()
{
  using namespace random_soups_test;
  CGAL::Random random(20261129);
  std::cout << "seed " << random.get_seed() << std::endl;
  std::size_t number_of_outlines = 0;
  for(int i = 0; i < 2000; ++i)
    check_soup("soup " + std::to_string(i), test::random_soup(random), number_of_outlines);
  CHECK(number_of_outlines > 10000, "number of polygons that were compared");
  return test::exit_status();
}
