// How much of the unit square charts fill, packed in three ways, as CSV:
//   packing [--margin TEXELS] [--texture-size N] [--fast | --best] RESULT.obj...
// Each file has polygons with texture coordinates, such as those that the program unwrap writes. The ways: bounding
// boxes on shelves; outlines in a bitmap with four rotations, the largest first, each as low as it can be; and
// pack_charts(). All keep the same margin. `limit` is the fill at which the chart with the largest extent alone needs the
// whole square. The last lines have the means, of the files with at least 2 and with at least 10 charts.

#include "../Surface_mesh_parameterization/Layout.h"

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_packer.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_cutting::internal;
using CGAL::Surface_mesh_cutting::Chart_rotation;
using CGAL::Surface_mesh_cutting::Effort;
using CGAL::Surface_mesh_parameterization::internal::Triangle;

constexpr Execution execution = CGAL::internal::Graph_kernel::execution_of<CGAL::Parallel_if_available_tag>();

std::vector<int> opposites(const std::vector<Triangle>& triangles)
{
  std::map<std::pair<int, int>, int> halfedges;
  for(std::size_t t = 0; t < triangles.size(); ++t)
    for(int k = 0; k < 3; ++k)
      halfedges[{triangles[t][k], triangles[t][(k + 1) % 3]}] = 3 * int(t) + k;
  std::vector<int> result(3 * triangles.size(), -1);
  for(const auto& [ends, h] : halfedges)
    if(const auto other = halfedges.find({ends.second, ends.first}); other != halfedges.end())
      result[h] = other->second;
  return result;
}

std::vector<int> sorted(std::size_t number, const std::vector<double>& sizes)
{
  std::vector<int> order(number);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  return order;
}

// The fill at the largest scale that fits, found by bisection.
template <typename Fits>
double largest_fill(Fits fits)
{
  double low = 0, high = 1; // the area of the charts is 1
  for(int step = 0; step < 12; ++step)
  {
    const double middle = 0.5 * (low + high);
    (fits(middle) ? low : high) = middle;
  }
  return low * low;
}

double fill_of_shelves(const std::vector<Chart_outline>& outlines, double margin)
{
  std::vector<Eigen::Vector2d> sizes;
  std::vector<double> heights;
  for(const Chart_outline& outline : outlines)
  {
    const Eigen::Vector2d size = outline.extent(0);
    sizes.emplace_back(size.maxCoeff(), size.minCoeff()); // lying on the longer side
    heights.push_back(size.minCoeff());
  }
  const std::vector<int> order = sorted(outlines.size(), heights);
  return largest_fill([&](double scale)
  {
    double x = margin, y = margin, row = 0;
    for(const int i : order)
    {
      const Eigen::Vector2d size = scale * sizes[i];
      if(x + size.x() + margin > 1)
      {
        x = margin;
        y += row + margin;
        row = 0;
      }
      if(x + size.x() + margin > 1 || y + size.y() + margin > 1)
        return false;
      x += size.x() + margin;
      row = (std::max)(row, size.y());
    }
    return true;
  });
}

double fill_of_bitmap(const std::vector<Chart_outline>& outlines, double margin, int texture_size)
{
  std::vector<double> areas;
  for(const Chart_outline& outline : outlines)
    areas.push_back(outline.area);
  const double quarter = CGAL_PI / 2;
  const std::vector<std::vector<double> > turns(outlines.size(), {0, quarter});
  const Packing_strategy strategy = {sorted(outlines.size(), areas), 1};
  const int size = int(std::floor((1 - 2 * margin) * texture_size));
  return largest_fill([&](double scale)
  {
    const auto masks = chart_masks(execution, outlines, turns, scale * texture_size, margin * texture_size);
    return bool(Grid_packing(masks, outlines, size).pack(strategy));
  });
}

double limit_of_fill(const std::vector<Chart_outline>& outlines, double margin)
{
  double longest = 0;
  for(const Chart_outline& outline : outlines)
    longest = (std::max)(longest, outline.extent(tightest_square_angle(outline)).maxCoeff());
  const double scale = (1 - 2 * margin) / longest;
  return (std::min)(1., scale * scale);
}

// Of the fills in the columns.
struct Means
{
  int least_charts, number = 0;
  double sums[4] = {0, 0, 0, 0};

  void add(int charts, const double (&fills)[4])
  {
    if(charts < least_charts)
      return;
    ++number;
    for(int k = 0; k < 4; ++k)
      sums[k] += fills[k];
  }

  void print() const
  {
    if(number == 0)
      return;
    std::cout << "mean," << least_charts << " or more";
    for(const double sum : sums)
      std::cout << "," << sum / number;
    std::cout << "," << std::endl;
  }
};

} // namespace

int main(int argc, char** argv)
{
  double texels = 2;
  int texture_size = 1024;
  Effort effort = Effort::DEFAULT;
  std::vector<std::string> names;
  for(int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if(word == "--margin" && i + 1 < argc)
      texels = std::stod(argv[++i]);
    else if(word == "--texture-size" && i + 1 < argc)
      texture_size = std::stoi(argv[++i]);
    else if(word == "--fast" || word == "--best")
      effort = word == "--fast" ? Effort::FAST : Effort::BEST;
    else
      names.push_back(word);
  }
  const double margin = texels / texture_size;
  std::cout << "file,charts,shelves,bitmap,packed,limit,seconds" << std::endl;
  Means means[2] = {{2}, {10}};
  for(const std::string& name : names)
  {
    const Layout layout = read_layout(name);
    const Corner_table chart(layout.triangles, opposites(layout.triangles), int(layout.uv.size()));
    const Connected_parts parts(chart.opposites());
    const double area = CGAL::Surface_mesh_parameterization::internal::chart_area(layout.triangles, layout.uv);
    const std::vector<Chart_outline> outlines = chart_outlines(chart, parts, layout.uv, 1 / std::sqrt(area));
    CGAL::Surface_mesh_cutting::internal::Run_control control;
    CGAL::Real_timer timer;
    timer.start();
    const auto packed = Chart_packer(outlines, margin, effort, Chart_rotation::ANY, execution, control).pack();
    timer.stop();
    const double fills[4] = {fill_of_shelves(outlines, margin), fill_of_bitmap(outlines, margin, texture_size),
                             packed ? packed->scale * packed->scale : 0, limit_of_fill(outlines, margin)};
    std::cout << name << "," << parts.number;
    for(const double fill : fills)
      std::cout << "," << fill;
    std::cout << "," << timer.time() << std::endl;
    for(Means& mean : means)
      mean.add(parts.number, fills);
  }
  for(const Means& mean : means)
    mean.print();
  return EXIT_SUCCESS;
}
