#include "read_with_cgal.h"

#include "outcome.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <exception>

std::optional<Polygon_soup> read_with_cgal(const std::string& path)
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<int> > polygons;
  bool is_read = false;
  try
  {
    is_read = CGAL::IO::read_polygon_soup(path, points, polygons);
  }
  catch(const std::exception&)
  {
    // the same to the user
  }
  if(!is_read)
    return {};

  Polygon_soup soup;
  for(const auto& p : points)
    soup.points.push_back({{p.x(), p.y(), p.z()}});
  for(const std::vector<int>& polygon : polygons)
  {
    for(const int corner : polygon)
    {
      if(corner < 0)
        throw Failure(Exit_code::UNREADABLE, "an index is negative");
      soup.corners.push_back(corner);
    }
    soup.close_polygon();
  }
  return soup;
}
