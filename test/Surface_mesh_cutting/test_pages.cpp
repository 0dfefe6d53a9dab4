// Charts on several pages, and at a given scale: against a test of all pairs of border edges, and known answers.

#include "../BGL/check.h"
#include "charts_to_pack.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/Box_packing.h>

#include <Eigen/Geometry>

#include <cstdlib>
#include <iostream>
#include <numeric>
#include <vector>

namespace pages_test {

template <typename Result, typename Parameters>
void check(const Charts& charts, const Result& result, double margin, int texture_size, const Parameters& np)
{
  const int pages = int(result.page_fills.size());
  check_distances(charts, margin, texture_size, pages);
  check_similarity(charts, result.scale);
  CHECK(CGAL::Surface_mesh_cutting::certify_packing(charts.mesh, charts.is_cut, charts.uv, np.number_of_pages(pages)));
  CHECK(pages == 1 || CGAL::Surface_mesh_cutting::certify_packing(charts.mesh, charts.is_cut, charts.uv,
                                                                  np.number_of_pages(pages - 1)).code == Status_code::NOT_CERTIFIED);
  const double sum = std::accumulate(result.page_fills.begin(), result.page_fills.end(), 0.);
  CHECK(std::abs(sum - area_of(charts)) < 1e-9 && std::abs(result.fill * pages - sum) < 1e-9);
  for(const double fill : result.page_fills)
    CHECK(fill > 0 && fill < 1);
}

void test_pages(CGAL::Random& random)
{
  const Charts charts = random_stars(random, 40);
  double former = 0;
  for(const int pages : {1, 2, 3, 12})
  {
    Charts packed = copy_of(charts), others = copy_of(charts);
    const auto np = parameters::margin(3).texture_size(512).effort(Effort::FAST);
    const auto result = CGAL::Surface_mesh_cutting::pack_charts(packed.mesh, packed.is_cut, packed.uv, np.number_of_pages(pages));
    CHECK(result && int(result.page_fills.size()) <= pages && result.number_of_charts == 40);
    check(packed, result, 3, 512, np);
    CHECK(result.scale > former); // more room
    former = result.scale;
    std::cout << pages << " pages: scale " << result.scale << ", fill " << result.fill << std::endl;
    CGAL::Surface_mesh_cutting::pack_charts<CGAL::Parallel_if_available_tag>(others.mesh, others.is_cut, others.uv,
                                                                             np.number_of_pages(pages));
    for(const auto h : packed.mesh.halfedges())
      CHECK(packed.uv[h] == others.uv[h]);
  }
}

Charts squares(int number)
{
  Charts charts;
  for(int i = 0; i < number; ++i)
  {
    const double x = 2 * i;
    charts.add({{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}, {x + 0.5, 0.5});
  }
  return charts;
}

void test_known_pages()
{
  Charts eight = squares(8);
  const auto two = CGAL::Surface_mesh_cutting::pack_charts(eight.mesh, eight.is_cut, eight.uv, parameters::number_of_pages(2));
  CHECK(two && two.page_fills.size() == 2 && two.scale > 0.97 * 0.5 && two.scale < 0.5);

  Charts nine = squares(9); // four on a page
  const auto density = parameters::texels_per_unit(460);
  const auto three = CGAL::Surface_mesh_cutting::pack_charts(nine.mesh, nine.is_cut, nine.uv, density);
  CHECK(three && three.page_fills.size() == 3 && std::abs(three.scale * 1024 / 460 - 1) < 1e-5);
  check(nine, three, 2, 1024, density);
  CHECK(CGAL::Surface_mesh_cutting::certify_packing(nine.mesh, nine.is_cut, nine.uv, density)); // on any number of pages

  Charts one = squares(1);
  const auto single = CGAL::Surface_mesh_cutting::pack_charts(one.mesh, one.is_cut, one.uv, parameters::texels_per_unit(100));
  CHECK(single && single.page_fills.size() == 1 && std::abs(single.scale * 1024 - 100) < 1e-3);
}

// The same texels for a unit, whatever the margin, on no fewer pages than the area needs.
void test_density(CGAL::Random& random)
{
  const Charts charts = random_stars(random, 60);
  for(const double density : {2., 60., 150.})
    for(const double margin : {0., 2.5})
    {
      Charts packed = copy_of(charts);
      const auto np = parameters::margin(margin).texture_size(1024).texels_per_unit(density);
      const auto result = CGAL::Surface_mesh_cutting::pack_charts(packed.mesh, packed.is_cut, packed.uv, np);
      CHECK(result && std::abs(result.scale * 1024 / density - 1) < 1e-5);
      check(packed, result, margin, 1024, np);
      const double area = area_of(charts) * density * density / (1024 * 1024);
      const int pages = int(result.page_fills.size());
      CHECK(pages >= area && pages < 2 * area + 2);
      std::cout << density << " texels per unit, margin " << margin << ": " << pages << " pages for " << area << std::endl;

      Charts again = copy_of(charts);
      const auto code = [&](int most)
      {
        return CGAL::Surface_mesh_cutting::pack_charts(again.mesh, again.is_cut, again.uv, np.number_of_pages(most)).status.code;
      };
      CHECK(pages == 1 || code(pages - 1) == Status_code::INFEASIBLE_CONSTRAINTS);
      CHECK(code(pages) == Status_code::OK);
    }
}

// Coordinates of type `float` are coarser far from the unit square.
void test_single_precision()
{
  using Point = CGAL::Simple_cartesian<float>::Point_2;
  Charts charts = squares(50); // four on a page
  const auto uv = charts.mesh.add_property_map<Mesh::Halfedge_index, Point>("h:float").first;
  for(const auto h : charts.mesh.halfedges())
    uv[h] = Point(float(charts.uv[h].x()), float(charts.uv[h].y()));
  const auto np = parameters::texels_per_unit(460);
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, uv, np);
  CHECK(result && result.page_fills.size() == 13); // three in the second row
  for(const auto h : charts.mesh.halfedges())
    charts.uv[h] = Kernel::Point_2(uv[h].x(), uv[h].y());
  check_distances(charts, 2, 1024, 13);
}

// Boxes lie in the squares and apart, also where their widths are misjudged; nine squares fill the pages they need.
void test_boxes(CGAL::Random& seeds)
{
  using namespace CGAL::Surface_mesh_cutting::internal;
  Packing_random random(seeds.get_int(0, 1000000));
  for(int round = 0; round < 60; ++round)
  {
    std::vector<Eigen::Vector2d> sizes;
    for(int i = 0; i < 25; ++i)
      sizes.emplace_back(seeds.get_double(0.02, 0.3), seeds.get_double(0.02, 0.3));
    const bool may_turn = round % 2 == 0;
    const auto places = Box_packing(sizes, 1, may_turn).pack(4, round % 3 * 0.5, random);
    CHECK(bool(places));
    std::vector<Eigen::AlignedBox2d> boxes;
    for(std::size_t i = 0; places && i < sizes.size(); ++i)
    {
      const Box_place& place = (*places)[i];
      const Eigen::Vector2d size = place.is_turned ? Eigen::Vector2d(sizes[i].y(), sizes[i].x()) : sizes[i];
      CHECK((may_turn || !place.is_turned) && place.page >= 0 && place.page < 4);
      CHECK(place.corner.minCoeff() >= 0 && (place.corner + size).maxCoeff() <= 1 + 1e-12);
      boxes.emplace_back(place.corner + Eigen::Vector2d(2 * place.page, 0), place.corner + size + Eigen::Vector2d(2 * place.page, 0));
      for(std::size_t j = 0; j < i; ++j)
      {
        const Eigen::Vector2d common = boxes[i].intersection(boxes[j]).sizes();
        CHECK(common.minCoeff() < 1e-12);
      }
    }
  }
  const std::vector<Eigen::Vector2d> squares(9, Eigen::Vector2d(1, 1));
  CHECK(Box_packing(squares, 3, true).pack(1, 0, random) && !Box_packing(squares, 2.9, true).pack(1, 0, random));
  CHECK(Box_packing(squares, 2, true).pack(3, 0, random) && !Box_packing(squares, 2, true).pack(2, 0, random));
  CHECK(!Box_packing(squares, 0.9, true).pack(100, 0, random)); // too large for any page
}

void test_errors(CGAL::Random& random)
{
  Charts charts = random_stars(random, 3);
  const auto code = [&](const auto& np)
  { return CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, np).status.code; };
  CHECK(code(parameters::number_of_pages(0)) == Status_code::WRONG_PARAMETER);
  CHECK(code(parameters::number_of_pages(-1).texels_per_unit(1)) == Status_code::WRONG_PARAMETER);
  CHECK(code(parameters::texels_per_unit(-1)) == Status_code::WRONG_PARAMETER);
  CHECK(code(parameters::texels_per_unit(std::nan(""))) == Status_code::WRONG_PARAMETER);
  CHECK(code(parameters::texels_per_unit(1e6)) == Status_code::INFEASIBLE_CONSTRAINTS); // larger than a page
  CHECK(code(parameters::texels_per_unit(1e-6)) == Status_code::OK);
}

} // namespace pages_test

int main(int argc, char** argv)
{
  using namespace pages_test;
  const unsigned int seed = argc > 1 ? unsigned(std::atoi(argv[1])) : 1;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  test_boxes(random);
  test_known_pages();
  test_errors(random);
  test_pages(random);
  test_density(random);
  test_single_precision();
  return test::exit_status();
}
