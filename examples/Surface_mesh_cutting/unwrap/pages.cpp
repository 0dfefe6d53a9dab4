#include "pages.h"

#include "Gltf_source.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/Page_tile.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace packing = CGAL::Surface_mesh_cutting::internal;

// At the mean of its corners, which is inside of the page also where some of them are at its border.
int page_of_polygon(const Layout& layout, std::size_t polygon, int number_of_pages)
{
  const std::size_t begin = polygon == 0 ? 0 : layout.polygon_ends[polygon - 1], end = layout.polygon_ends[polygon];
  Eigen::Vector2d sum(0, 0);
  for(std::size_t corner = begin; corner < end; ++corner)
    sum += Eigen::Map<const Eigen::Vector2d>(layout.uv_points[std::size_t(layout.corner_uvs[corner])].data());
  const int page = packing::page_at(sum / double((std::max)(end - begin, std::size_t(1))));
  return (std::min)((std::max)(page, 0), number_of_pages - 1);
}

// Statements of groups that also name the page of the polygons that follow.
std::vector<Obj_statements::Line> with_page_groups(const std::vector<Obj_statements::Line>& lines,
                                                   const std::vector<int>& pages)
{
  std::vector<Obj_statements::Line> result;
  std::string names;
  int page = -1; // told last
  auto line = lines.begin();
  for(int polygon = 0; polygon < int(pages.size()); ++polygon)
  {
    for(; line != lines.end() && line->polygon <= polygon; ++line)
      if(line->text == "g" || line->text.rfind("g ", 0) == 0)
      {
        names = line->text.substr(1);
        page = -1;
      }
      else
        result.push_back(*line);
    if(std::exchange(page, pages[std::size_t(polygon)]) != page)
      result.push_back({polygon, "g" + names + " page_" + std::to_string(page + 1)});
  }
  result.insert(result.end(), line, lines.end());
  return result;
}

} // namespace

void place_pages(const Options& options, int number_of_pages, Layout& layout)
{
  if(number_of_pages < 2)
    return;
  for(std::size_t polygon = 0; polygon < layout.polygon_ends.size(); ++polygon)
    layout.polygon_pages.push_back(page_of_polygon(layout, polygon, number_of_pages));
  if(options.is_udim || layout.gltf_source)
    return;
  layout.page_corners.resize(layout.uv_points.size());
  for(std::size_t polygon = 0, corner = 0; polygon < layout.polygon_ends.size(); ++polygon)
    for(; corner < layout.polygon_ends[polygon]; ++corner)
    {
      const Eigen::Vector2d low = packing::corner_of_page(layout.polygon_pages[polygon]);
      layout.page_corners[std::size_t(layout.corner_uvs[corner])] = {{low.x(), low.y()}};
    }
  if(!options.has_page_files)
    layout.obj_statements.lines = with_page_groups(layout.obj_statements.lines, layout.polygon_pages);
}
