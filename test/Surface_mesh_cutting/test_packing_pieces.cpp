// The pieces of packing against their definitions, in other words and by other means: cells and distances by CGAL's
// predicates and distances of all segments, simplified outlines and separated charts by what they promise.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_mask.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_separator.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Joint_growth.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <iostream>
#include <vector>

namespace packing_pieces_test {

using namespace CGAL::Surface_mesh_cutting::internal;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Polygon = CGAL::Polygon_2<Kernel>;

std::vector<Eigen::Vector2d> random_star(CGAL::Random& random)
{
  std::vector<Eigen::Vector2d> corners;
  const int number = random.get_int(3, 24);
  for(int k = 0; k < number; ++k)
  {
    const double angle = 2 * CGAL_PI * k / number, radius = random.get_double(0.3, 1);
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return corners;
}

std::vector<Outline_segment> segments_of(const std::vector<Eigen::Vector2d>& corners)
{
  std::vector<Outline_segment> segments;
  for(std::size_t i = 0; i < corners.size(); ++i)
    segments.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return segments;
}

Point to_point(const Eigen::Vector2d& p) { return Point(p.x(), p.y()); }

Polygon to_polygon(const std::vector<Eigen::Vector2d>& corners)
{
  Polygon polygon;
  for(const Eigen::Vector2d& p : corners)
    polygon.push_back(to_point(p));
  return polygon;
}

template <typename Object>
double distance_to_border(const Polygon& polygon, const Object& object)
{
  double least = std::numeric_limits<double>::infinity();
  for(const auto& edge : polygon.edges())
    least = (std::min)(least, CGAL::to_double(CGAL::squared_distance(edge, object)));
  return std::sqrt(least);
}

// Of a unit cell to the closed polygon.
double distance_of_cell(const Polygon& polygon, int x, int y)
{
  const Polygon cell = to_polygon({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
  if(!polygon.has_on_unbounded_side(cell[0]) || !cell.has_on_unbounded_side(polygon[0]))
    return 0;
  double least = std::numeric_limits<double>::infinity();
  for(const auto& edge : cell.edges())
    least = (std::min)(least, distance_to_border(polygon, edge));
  return least;
}

bool has_cell(const std::vector<Cell_run>& runs, int x, int y)
{
  for(const Cell_run& run : runs)
    if(run.row == y && run.first <= x && x <= run.last)
      return true;
  return false;
}

void check_mask(const Chart_mask& mask, const std::vector<Eigen::Vector2d>& corners, double factor, double margin)
{
  constexpr double rounding = 3e-3; // of a cell: more than the mask adds
  const Rigid_motion motion(mask.angle, mask.origin);
  std::vector<Eigen::Vector2d> moved;
  for(const Eigen::Vector2d& p : corners)
    moved.push_back(motion(factor * p));
  const Polygon polygon = to_polygon(moved);
  const int border = int(margin) + 3;
  for(int y = -border; y < mask.height + border; ++y)
    for(int x = -border; x < mask.width + border; ++x)
    {
      const double distance = distance_of_cell(polygon, x, y);
      CHECK(distance > 0 || has_cell(mask.inner, x, y));
      CHECK(distance < rounding || !has_cell(mask.inner, x, y));
      CHECK(distance > margin || has_cell(mask.outer, x, y));
      CHECK(distance < margin + rounding || !has_cell(mask.outer, x, y));
      if(has_cell(mask.inner, x, y))
        CHECK(x >= 0 && y >= 0 && x < mask.width && y < mask.height);
    }
  for(std::size_t i = 1; i < mask.inner.size(); ++i)
    CHECK(mask.inner[i - 1].length() >= mask.inner[i].length());
}

void test_masks(CGAL::Random& random)
{
  for(int round = 0; round < 20; ++round)
  {
    const std::vector<Eigen::Vector2d> corners = random_star(random);
    Chart_outline outline;
    outline.segments = segments_of(corners);
    const double factor = random.get_double(1, 10), margin = random.get_double(0, 3);
    const Chart_mask mask(outline, random.get_double(0, 7), factor, margin);
    check_mask(mask, corners, factor, margin);
    check_mask(mask.upside_down(), corners, factor, margin);
  }
}

void test_distances(CGAL::Random& random)
{
  for(int round = 0; round < 20; ++round)
  {
    const std::vector<Eigen::Vector2d> corners = random_star(random);
    const Polygon polygon = to_polygon(corners);
    constexpr double reach = 0.1;
    const Distance_field field(segments_of(corners), reach);
    for(int k = 0; k < 1000; ++k)
    {
      const Eigen::Vector2d p(random.get_double(-1.5, 1.5), random.get_double(-1.5, 1.5));
      const double distance = distance_to_border(polygon, to_point(p));
      const bool is_inside = polygon.has_on_bounded_side(to_point(p));
      const Signed_distance found = field(p);
      const double signed_distance = is_inside ? -distance : distance;
      const double limit = random.get_double(0, reach); // matters only for what is farther away
      CHECK(field(p, limit).distance == found.distance || (signed_distance >= limit - 1e-9 && found.distance >= limit));
      CHECK(field.least_distance(p) <= signed_distance + 1e-9);
      CHECK(distance > reach || std::abs(field.rough_distance(p) - signed_distance) < 0.04); // a cell's diagonal is 0.06
      if(!is_inside && distance > reach)
        CHECK(found.distance > reach * (1 - 1e-9));
      else
      {
        CHECK((found.distance < 0) == is_inside || distance < 1e-9);
        // Deep inside, it is off by up to the diagonal of a cell, of which 48 lie along the box.
        const double error = std::abs(std::abs(found.distance) - distance);
        CHECK(error < (is_inside && distance > 0.12 ? 0.07 : 1e-9));
        // Following the direction leads to the border.
        const Eigen::Vector2d foot = p - found.distance * found.direction;
        CHECK(std::abs(found.direction.norm() - 1) < 1e-9);
        CHECK(distance_to_border(polygon, to_point(foot)) < 1e-9);
      }
    }
  }
}

// The same two segments are a slit in one chart, and all of another one, which has no area.
void test_slit_and_sliver()
{
  const Eigen::Vector2d a(-0.5, 0.), b(0.5, 0.);
  const std::vector<Outline_segment> sliver = {{a, b}, {b, a}};
  std::vector<Outline_segment> slit = segments_of({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  slit.insert(slit.end(), sliver.begin(), sliver.end());
  const Distance_field around(sliver, 0.2), inside(slit, 0.2);
  for(const double y : {-0.1, -0.03, 0.03, 0.1})
    for(const double x : {-0.4, 0.1, 0.45})
    {
      const Eigen::Vector2d p(x, y);
      CHECK(std::abs(around(p).distance - std::abs(y)) < 1e-12 && around(p).direction.y() * y > 0);
      CHECK(std::abs(inside(p).distance + std::abs(y)) < 1e-12 && inside(p).direction.y() * y < 0);
    }
}

void test_simplified_outlines(CGAL::Random& random)
{
  for(int round = 0; round < 20; ++round)
  {
    constexpr double tolerance = 0.02;
    std::vector<Eigen::Vector2d> corners; // a wave around a circle, finer than what is kept of it
    const int number = 400, waves = random.get_int(2, 60);
    for(int k = 0; k < number; ++k)
    {
      const double angle = 2 * CGAL_PI * k / number, radius = 1 + 0.05 * std::sin(waves * angle);
      corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    const std::vector<Outline_segment> simplified = simplified_outline(segments_of(corners), tolerance);
    CHECK(simplified.size() >= 3 && simplified.size() < corners.size() / 2);
    std::vector<Eigen::Vector2d> kept;
    for(std::size_t i = 0; i < simplified.size(); ++i)
    {
      CHECK(simplified[i].target == simplified[(i + 1) % simplified.size()].source);
      CHECK(std::find(corners.begin(), corners.end(), simplified[i].source) != corners.end());
      kept.push_back(simplified[i].source);
    }
    const Polygon polygon = to_polygon(kept);
    CHECK(polygon.is_counterclockwise_oriented());
    for(const Eigen::Vector2d& p : corners)
      CHECK(distance_to_border(polygon, to_point(p)) <= tolerance * (1 + 1e-12));
  }
}

Rigid_chart rectangle(double width, double height)
{
  const double x = 0.5 * width, y = 0.5 * height;
  return Rigid_chart(segments_of({{-x, -y}, {x, -y}, {x, y}, {-x, y}}), 1);
}

void test_overlaps()
{
  const Rigid_chart bar = rectangle(10, 0.01), square = rectangle(1, 1);
  const Rigid_motion here(0, {0, 0}), upright(CGAL_PI / 2, {0.123, 0.2}), far(0.3, {0, 6});
  CHECK(do_overlap(bar, here, bar, upright)); // though none has a corner in the other one
  CHECK(!do_overlap(bar, here, bar, far));
  CHECK(do_overlap(square, here, rectangle(0.1, 0.1), here) && do_overlap(rectangle(0.1, 0.1), here, square, here));
  std::vector<Outline_segment> two = segments_of({{5, 5}, {6, 5}, {6, 6}}); // of which one lies in the other chart
  for(const Outline_segment& s : segments_of({{-0.1, 0}, {0.1, 0}, {0, 0.1}}))
    two.push_back(s);
  CHECK(do_overlap(square, here, Rigid_chart(two, 1), here) && do_overlap(Rigid_chart(two, 1), here, square, here));
  CHECK(!do_overlap(square, here, Rigid_chart(two, 1), far));
}

// Blocks cover all samples.
void test_blocks(CGAL::Random& random)
{
  const Rigid_chart chart(segments_of(random_star(random)), 0.1);
  int end = 0;
  for(const Sample_block& block : chart.blocks)
  {
    CHECK(block.begin == end && block.end > block.begin);
    end = block.end;
    for(int k = block.begin; k < block.end; ++k)
      CHECK((chart.samples[k] - block.center).norm() <= block.radius);
  }
  CHECK(end == int(chart.samples.size()));
}

// The one gap between bars is found, for all turns that fit, and rated higher where what is around it weighs more.
void test_places(CGAL::Random& seeds)
{
  Packing_random random(seeds.get_int(0, 1000000));
  const std::vector<Rigid_chart> charts = {rectangle(1, 0.5), rectangle(4, 2.4), rectangle(4, 0.9)};
  const std::vector<Rigid_motion> motions = {{0, {2, 2}}, {0, {2, 1.2}}, {0, {2, 3.55}}}; // the gap is at y = 2.4 ... 3.1
  Crowding_map map(charts);
  map.put_all(motions, 4, 0.01);
  std::vector<Rated_place> places, heavy_places;
  map.look_from(0, [](int) { return 1.; });
  for(int k = 0; k < 50; ++k)
    map.try_places(0, random.share() * 7, random, places);
  for(int k = 0; k < 50; ++k)
    map.try_places(0, CGAL_PI, random, places);
  CHECK(places.size() == 2 && places[0].energy <= places[1].energy);
  const Eigen::Vector2d& center = places[0].motion.translation();
  CHECK(std::abs(center.y() - 2.75) < 0.15 && center.x() >= 0.5 && center.x() <= 3.5);
  map.look_from(0, [](int j) { return j == 1 ? 100. : 1.; });
  map.try_places(0, 0, random, heavy_places);
  CHECK(heavy_places[0].motion.translation().y() > 2.4);
  std::vector<Rated_place> none;
  map.try_places(1, CGAL_PI / 4, random, none); // too long for any place along the diagonal
  CHECK(none.empty());
}

// Squares thrown onto each other come apart where there is room, and only there.
void test_separation(CGAL::Random& random)
{
  constexpr double distance = 0.1, slack = 1e-3;
  const std::vector<Rigid_chart> charts(4, rectangle(1, 1));
  for(const double side : {3.2, 1.9})
  {
    std::vector<Rigid_motion> motions;
    for(std::size_t i = 0; i < charts.size(); ++i)
      motions.emplace_back(random.get_double(0, 7), Eigen::Vector2d(random.get_double(1, 1.5), random.get_double(1, 1.5)));
    Chart_separator separator(charts);
    const bool is_separated
      = separator.separate(motions, {side, distance, slack}, 10000000, CGAL::internal::Graph_kernel::always_go_further);
    CHECK(is_separated == (side > 2));
    if(!is_separated)
      continue;
    std::vector<Polygon> polygons;
    for(std::size_t i = 0; i < charts.size(); ++i)
    {
      std::vector<Eigen::Vector2d> corners;
      for(const Outline_segment& s : charts[i].outline)
      {
        corners.push_back(motions[i](s.source));
        CHECK(corners.back().minCoeff() >= 0 && corners.back().maxCoeff() <= side);
      }
      polygons.push_back(to_polygon(corners));
      for(std::size_t j = 0; j < i; ++j)
      {
        CHECK(!do_overlap(charts[i], motions[i], charts[j], motions[j]));
        for(const auto& edge : polygons[i].edges())
          CHECK(distance_to_border(polygons[j], edge) >= distance);
      }
    }
  }
}

// Those that are found by sorting, against all pairs.
void test_meeting_pairs(CGAL::Random& random)
{
  for(int round = 0; round < 20; ++round)
  {
    std::vector<Rigid_chart> charts;
    std::vector<Rigid_motion> motions;
    for(int i = 0; i < 30; ++i)
    {
      charts.push_back(rectangle(random.get_double(0.1, 2), random.get_double(0.1, 1)));
      motions.emplace_back(random.get_double(0, 6), Eigen::Vector2d(random.get_double(0, 8), random.get_double(0, 8)));
    }
    Contact_finder finder(charts);
    finder.set_room({8, 0.1, 0.01});
    std::vector<std::pair<int, int> > pairs;
    for(int i = 0; i < 30; ++i)
      for(int j = 0; j < i; ++j)
        if(finder.can_meet(i, motions[i], j, motions[j]))
          pairs.emplace_back(i, j);
    CHECK(!pairs.empty() && pairs.size() < 30 * 29 / 2 && finder.meeting_pairs(motions) == pairs);
  }
}

// Charts thrown into a large square grow until they are jammed: a bar across it, and a row of squares that has to be
// straightened for that, which none of them can do alone.
void test_growth(CGAL::Random& random)
{
  constexpr double distance = 0.02, slack = 1e-3;
  const auto room_at = [=](double scale) { return Square_room{10 / scale, distance, slack}; };
  const auto go_further = CGAL::internal::Graph_kernel::always_go_further;
  const auto nearly = [](double scale, double best) { return scale <= best && scale > 0.995 * best; };
  const std::vector<Rigid_chart> bar(1, rectangle(4, 0.01));
  std::vector<Rigid_motion> motions(1, Rigid_motion(random.get_double(0.2, 1.3), {5, 5}));
  constexpr long long enough = 1000000000;
  CHECK(Joint_growth(bar, go_further).grow(motions, 1, 100, 0, room_at) == 1); // no lookup allowed
  const double diagonal = Joint_growth(bar, go_further).grow(motions, 1, 100, enough, room_at);
  CHECK(nearly(diagonal, 10 * std::sqrt(2) / 4));
  const std::vector<Rigid_chart> row(5, rectangle(1, 1));
  motions.clear();
  for(int i = 0; i < 5; ++i)
    motions.emplace_back(random.get_double(-0.2, 0.2), Eigen::Vector2d(1 + 1.9 * i, 5 + random.get_double(-0.3, 0.3)));
  Joint_growth joint_growth(row, go_further);
  CHECK(joint_growth.grow(motions, 1, 1.1, enough, room_at) == 1.1); // the limit
  const double jammed = joint_growth.grow(motions, 1.1, 100, enough, room_at);
  CHECK(jammed > 1.5 && joint_growth.lookups() > 0);
  Contact_finder finder(row);
  finder.set_room({room_at(jammed).side, distance, 0});
  const auto no_contact = [](const Contact&) { CHECK(false); return true; };
  for(int i = 0; i < 5; ++i)
  {
    finder.at_border(i, motions[i], no_contact);
    for(int j = 0; j < 5; ++j)
      if(j != i)
        finder.in_chart(i, motions[i], j, motions[j], no_contact);
  }
  CHECK(!finder.has_overlap(motions));
}

} // namespace packing_pieces_test

int main(int argc, char** argv)
{
  using namespace packing_pieces_test;
  const unsigned int seed = argc > 1 ? unsigned(std::atoi(argv[1])) : 1;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  test_masks(random);
  test_distances(random);
  test_slit_and_sliver();
  test_simplified_outlines(random);
  test_overlaps();
  test_blocks(random);
  test_places(random);
  test_separation(random);
  test_meeting_pairs(random);
  test_growth(random);
  return test::exit_status();
}
