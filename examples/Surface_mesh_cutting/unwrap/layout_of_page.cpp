#include "layout_of_page.h"

#include "obj_keywords.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

namespace {

// Some of the elements of an array, in their order.
class Page_selection
{
public:
  explicit Page_selection(const std::vector<char>& is_chosen) : m_numbers(is_chosen.size(), -1)
  {
    for(std::size_t i = 0; i < is_chosen.size(); ++i)
      if(is_chosen[i])
      {
        m_numbers[i] = int(m_chosen.size());
        m_chosen.push_back(i);
      }
  }

  // Among the chosen ones; -1 for the others, and for -1.
  int number(int element) const { return element < 0 ? -1 : m_numbers[std::size_t(element)]; }
  const std::vector<std::size_t>& chosen() const { return m_chosen; }

  // An array may also be empty.
  template <typename Element>
  std::vector<Element> of(const std::vector<Element>& elements) const
  {
    std::vector<Element> result;
    for(const std::size_t i : m_chosen)
      if(!elements.empty())
        result.push_back(elements[i]);
    return result;
  }

private:
  std::vector<int> m_numbers;
  std::vector<std::size_t> m_chosen;
};

bool is_on_page(const Layout& layout, std::size_t polygon, int page)
{
  return layout.polygon_pages.empty() || layout.polygon_pages[polygon] == page;
}

std::vector<char> polygons_of_page(const Layout& layout, int page)
{
  std::vector<char> is_chosen;
  for(std::size_t polygon = 0; polygon < layout.polygon_ends.size(); ++polygon)
    is_chosen.push_back(is_on_page(layout, polygon, page));
  return is_chosen;
}

std::vector<char> corners_of_page(const Layout& layout, int page)
{
  std::vector<char> is_chosen;
  for(std::size_t polygon = 0; polygon < layout.polygon_ends.size(); ++polygon)
    is_chosen.resize(layout.polygon_ends[polygon], char(is_on_page(layout, polygon, page)));
  return is_chosen;
}

// The elements, of so many, that the chosen corners have.
Page_selection elements_at(const Page_selection& corners, const std::vector<int>& elements_of_corners, std::size_t number)
{
  std::vector<char> is_chosen(number, 0);
  for(const int element : corners.of(elements_of_corners))
    if(element >= 0)
      is_chosen[std::size_t(element)] = 1;
  return Page_selection(is_chosen);
}

std::vector<int> numbers_of(const std::vector<int>& elements, const Page_selection& selection)
{
  std::vector<int> numbers;
  for(const int element : elements)
    numbers.push_back(selection.number(element));
  return numbers;
}

std::vector<Layout::Triangle> numbers_of(const std::vector<Layout::Triangle>& triangles, const Page_selection& selection)
{
  std::vector<Layout::Triangle> numbers;
  for(const Layout::Triangle& t : triangles)
    numbers.push_back({{selection.number(t[0]), selection.number(t[1]), selection.number(t[2])}});
  return numbers;
}

Page_selection triangles_at(const Page_selection& corners, const Layout& layout)
{
  std::vector<char> is_chosen;
  for(const Layout::Triangle& triangle : layout.triangle_corners)
    is_chosen.push_back(corners.number(triangle[0]) >= 0);
  return Page_selection(is_chosen);
}

std::string_view word_of(std::string_view statement)
{
  return statement.substr(0, 1) == "#" ? "$" : statement.substr(0, statement.find(' ')); // both start comments
}

Data_kind kind_of(std::string_view statement)
{
  const Obj_keyword* const keyword = find_obj_keyword(word_of(statement));
  return keyword == nullptr ? Data_kind::UNKNOWN_STATEMENTS : keyword->kind;
}

// Statements that do not refer to points. One that another of its kind replaces before it has a polygon is left out.
std::vector<Obj_statements::Line> statements_of(const std::vector<Obj_statements::Line>& lines, const Page_selection& polygons)
{
  const Data_kinds left_out = kinds_not_on_pages();
  std::vector<Obj_statements::Line> result;
  for(const Obj_statements::Line& line : lines)
  {
    const std::vector<std::size_t>& chosen = polygons.chosen();
    const auto next = std::lower_bound(chosen.begin(), chosen.end(), std::size_t((std::max)(line.polygon, 0)));
    const int polygon = line.polygon < 0 ? -1 : int(next - chosen.begin());
    const std::string_view word = word_of(line.text);
    const Data_kind kind = kind_of(line.text);
    if(left_out.count(kind) > 0)
      continue;
    auto same_place = result.end();
    while(same_place != result.begin() && (same_place - 1)->polygon == polygon)
      --same_place;
    if(kind != Data_kind::COMMENTS && polygon >= 0)
      result.erase(std::remove_if(same_place, result.end(), [&](const auto& other) { return word_of(other.text) == word; }),
                   result.end());
    if(kind == Data_kind::COMMENTS || next != chosen.end())
      result.push_back({polygon, line.text});
  }
  return result;
}

} // namespace

Data_kinds kinds_not_on_pages()
{
  return {Data_kind::LINES, Data_kind::POINTS, Data_kind::CURVES_AND_SURFACES, Data_kind::UNKNOWN_STATEMENTS};
}

Layout mesh_of_page(const Layout& layout, int page)
{
  const Page_selection polygons(polygons_of_page(layout, page)), corners(corners_of_page(layout, page));
  const Page_selection points = elements_at(corners, layout.corners, layout.points.size());
  const Page_selection uvs = elements_at(corners, layout.corner_uvs, layout.uv_points.size());
  const Page_selection normals = elements_at(corners, layout.corner_normals, layout.normals.size());
  const Page_selection triangles = triangles_at(corners, layout);
  Layout result;
  result.points = points.of(layout.points);
  result.colors = points.of(layout.colors);
  result.obj_statements = {statements_of(layout.obj_statements.lines, polygons), points.of(layout.obj_statements.point_ends)};
  result.normals = normals.of(layout.normals);
  for(const std::size_t uv : uvs.chosen())
    result.uv_points.push_back(layout.written_uv(uv));

  result.corners = numbers_of(corners.of(layout.corners), points);
  result.corner_uvs = numbers_of(corners.of(layout.corner_uvs), uvs);
  result.corner_normals = numbers_of(corners.of(layout.corner_normals), normals);
  result.corner_vertices = corners.of(layout.corner_vertices);
  result.former_uvs = corners.of(layout.former_uvs);
  for(const std::size_t polygon : polygons.chosen())
    result.polygon_ends.push_back((result.polygon_ends.empty() ? 0 : result.polygon_ends.back()) + layout.polygon_ends[polygon]
                                  - (polygon == 0 ? 0 : layout.polygon_ends[polygon - 1]));
  result.face_colors = polygons.of(layout.face_colors);

  result.triangles = numbers_of(triangles.of(layout.triangles), points);
  result.triangle_corners = numbers_of(triangles.of(layout.triangle_corners), corners);
  result.uv_triangles = numbers_of(triangles.of(layout.uv_triangles), uvs);
  result.kinds = layout.kinds;
  result.has_mirrored = layout.has_mirrored;
  result.uv_scale = layout.uv_scale;
  result.uv_set = layout.uv_set;
  return result;
}

Layout picture_of_page(const Layout& layout, int page)
{
  const Page_selection corners(corners_of_page(layout, page)), triangles = triangles_at(corners, layout);
  const Page_selection uvs = elements_at(corners, layout.corner_uvs, layout.uv_points.size());
  Layout result = layout;
  result.triangles = triangles.of(layout.triangles);
  result.triangle_corners = triangles.of(layout.triangle_corners);
  result.uv_triangles = triangles.of(layout.uv_triangles);
  result.chart_borders.clear();
  std::copy_if(layout.chart_borders.begin(), layout.chart_borders.end(), std::back_inserter(result.chart_borders),
               [&](const Layout::Edge& border) { return uvs.number(border[0]) >= 0; });
  return result;
}
