// How packing turns charts: by which angles, and that aligned charts cost as little as promised.

#include "../BGL/check.h"
#include "charts_to_pack.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace chart_rotation_test {

using CGAL::Surface_mesh_cutting::Chart_rotation;

// Crosses, each turned by some angle.
Charts turned_crosses(CGAL::Random& random, int number)
{
  Charts charts;
  for(int i = 0; i < number; ++i)
  {
    const double turn = random.get_double(0, 2 * CGAL_PI), c = std::cos(turn), s = std::sin(turn);
    const double length = random.get_double(1, 3), width = random.get_double(0.2, 0.8);
    std::vector<Kernel::Point_2> polygon;
    for(const auto& [x, y] : std::vector<std::pair<double, double> >{
          {length, -width}, {length, width}, {width, width}, {width, 1}, {-width, 1}, {-width, width},
          {-1, width}, {-1, -width}, {-width, -width}, {-width, -1}, {width, -1}, {width, -width}})
      polygon.emplace_back(9 * i + c * x - s * y, s * x + c * y);
    charts.add(polygon, {9. * i, 0});
  }
  return charts;
}

// By which each triangle was turned, from 0 to `period`.
std::vector<double> turns(const Charts& charts, double period)
{
  std::vector<double> result;
  for(const auto f : charts.mesh.faces())
  {
    const auto h = charts.mesh.halfedge(f), n = charts.mesh.next(h);
    const Kernel::Vector_3 a = charts.mesh.point(charts.mesh.target(n)) - charts.mesh.point(charts.mesh.target(h));
    const Kernel::Vector_2 b = charts.uv[n] - charts.uv[h];
    const double turn = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
    result.push_back(turn - period * std::floor(turn / period));
  }
  return result;
}

double distance_to_multiple(double number, double period)
{
  return std::abs(number - period * std::round(number / period));
}

void test_rotations(CGAL::Random& random)
{
  for(const int number : {1, 2, 9, 101})
    for(const bool are_stars : {false, true})
    {
      const Charts charts = are_stars ? random_stars(random, number) : turned_crosses(random, number);
      double fill_of_any = 0;
      for(const Chart_rotation rotation :
          {Chart_rotation::ANY, Chart_rotation::AUTOMATIC, Chart_rotation::QUARTER, Chart_rotation::NONE})
      {
        Charts packed = copy_of(charts);
        const auto np = parameters::chart_rotation(rotation).effort(Effort::FAST).texture_size(512);
        const auto result = CGAL::Surface_mesh_cutting::pack_charts(packed.mesh, packed.is_cut, packed.uv, np);
        CHECK(result && CGAL::Surface_mesh_cutting::certify_packing(packed.mesh, packed.is_cut, packed.uv, np));
        if(number < 20)
          check_distances(packed, 2, 512);
        check_similarity(packed, result.scale);
        std::cout << number << (are_stars ? " stars" : " crosses") << ", rotation " << int(rotation) << ": fill "
                  << result.fill << std::endl;
        if(rotation == Chart_rotation::NONE)
          for(const double turn : turns(packed, 2 * CGAL_PI))
            CHECK(distance_to_multiple(turn, 2 * CGAL_PI) < 1e-9);
        const bool is_one_cross = number == 1 && !are_stars;
        if((rotation == Chart_rotation::QUARTER && !are_stars) || (rotation == Chart_rotation::AUTOMATIC && is_one_cross))
          for(const auto h : packed.mesh.halfedges())
            if(packed.mesh.is_border(packed.mesh.opposite(h)))
            {
              const Kernel::Vector_2 along = packed.uv[h] - packed.uv[packed.mesh.prev(h)];
              CHECK(distance_to_multiple(std::atan2(along.y(), along.x()), CGAL_PI / 2) < 1e-9);
            }
        if(rotation == Chart_rotation::ANY)
          fill_of_any = result.fill;
        else if(rotation == Chart_rotation::AUTOMATIC && number <= 100 && !is_one_cross)
          CHECK(result.fill > 0.9699 * fill_of_any);
      }
    }
}

// A chart that no direction of its border stands out of is aligned by the smallest rectangle around it; charts that are
// aligned once stay as they are.
void test_alignment(CGAL::Random& random)
{
  const auto quarter = parameters::chart_rotation(Chart_rotation::QUARTER);
  for(int round = 0; round < 20; ++round)
  {
    Charts charts; // a triangle of angles from 60 to 90 degrees
    const double turn = random.get_double(0, 2 * CGAL_PI), height = random.get_double(0.88, 1.2);
    const auto turned = [turn](double x, double y)
    { return Kernel::Point_2(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y); };
    charts.add({turned(0, 0), turned(1, 0), turned(0.5, height)}, turned(0.5, 0.3));
    const auto box_area = [&charts](double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      double low[2] = {9, 9}, high[2] = {-9, -9};
      for(const auto h : charts.mesh.halfedges())
        if(!charts.mesh.is_border(h))
        {
          const double p[2] = {c * charts.uv[h].x() - s * charts.uv[h].y(), s * charts.uv[h].x() + c * charts.uv[h].y()};
          for(int k = 0; k < 2; ++k)
          {
            low[k] = (std::min)(low[k], p[k]);
            high[k] = (std::max)(high[k], p[k]);
          }
        }
      return (high[0] - low[0]) * (high[1] - low[1]);
    };
    CHECK(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, quarter));
    for(int degree = 0; degree < 90; ++degree)
      CHECK(box_area(0) <= box_area(degree * CGAL_PI / 180) * (1 + 1e-9));
    const std::vector<Kernel::Point_2> before(charts.uv.begin(), charts.uv.end());
    CHECK(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, quarter));
    for(const auto h : charts.mesh.halfedges())
      if(!charts.mesh.is_border(h))
        CHECK(CGAL::squared_distance(before[std::size_t(h)], charts.uv[h]) < 1e-9);
  }
}

} // namespace chart_rotation_test

int main(int argc, char** argv)
{
  using namespace chart_rotation_test;
  const unsigned int seed = argc > 1 ? unsigned(std::atoi(argv[1])) : 1;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  test_alignment(random);
  test_rotations(random);
  return test::exit_status();
}
