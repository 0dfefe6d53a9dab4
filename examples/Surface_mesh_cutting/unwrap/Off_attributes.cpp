#include "Off_attributes.h"

#include "complete_normals.h"
#include "outcome.h"
#include "vertex_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace {

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

std::array<double, 3> three(const std::vector<double>& numbers, std::size_t first)
{
  return {{numbers[first], numbers[first + 1], numbers[first + 2]}};
}

// Polygons without one have the color that the format says.
void complete_face_colors(Polygon_soup& soup)
{
  constexpr double gray = 2. / 3;
  if(soup.face_colors.empty())
    return;
  complete_fractions(soup.face_colors);
  soup.face_colors.resize(soup.polygon_ends.size(), {{not_given, not_given, not_given}});
  for(std::array<double, 3>& color : soup.face_colors)
    for(double& channel : color)
      channel = std::isnan(channel) ? gray : (std::min)(channel, 1.);
}

} // namespace

// Colors may have three numbers or four, so texture coordinates are the last two.
void Off_attributes::add_point(const std::vector<double>& numbers, Polygon_soup& soup)
{
  const std::size_t number_of_uvs = m_header.has_uv ? 2 : 0, first_color = m_header.has_normal ? 3 : 0;
  const std::size_t end_of_color = numbers.size() - (std::min)(number_of_uvs, numbers.size());
  if(m_header.has_normal && m_attributes.has_looks)
    soup.normals.push_back(numbers.size() >= 3 ? three(numbers, 0) : std::array<double, 3>{{not_given, not_given, not_given}});
  if(m_header.has_color && m_attributes.has_looks && end_of_color >= first_color + 3)
  {
    soup.kinds.insert(Data_kind::COLORS);
    soup.colors.push_back(three(numbers, first_color));
    note_alpha(&numbers[first_color], end_of_color - first_color);
  }
  if(!m_header.has_color && end_of_color > first_color && std::isfinite(numbers[first_color]))
    soup.kinds.insert(Data_kind::OTHER_PROPERTIES); // that the header does not announce
  if(!m_header.has_uv || !m_attributes.has_uvs)
    return;
  const Polygon_soup::Texture_point uv = numbers.size() < 2 ? Polygon_soup::Texture_point{{not_given, not_given}}
                                         : Polygon_soup::Texture_point{{numbers[end_of_color], numbers[end_of_color + 1]}};
  if(!std::isfinite(uv[0]) || !std::isfinite(uv[1]))
    throw Failure(Exit_code::UNREADABLE, "vertex " + std::to_string(m_uvs.size()) + " has no texture coordinates",
                  {Witness::Kind::VERTICES, {int(m_uvs.size())}});
  m_uvs.push_back(uv);
}

// A single number stands for a color of a table that is no part of the file.
void Off_attributes::add_polygon(const std::vector<double>& numbers, Polygon_soup& soup)
{
  if(!m_attributes.has_looks || numbers.empty() || std::any_of(numbers.begin(), numbers.end(), [](double x) { return !(x >= 0); }))
    return;
  soup.kinds.insert(Data_kind::FACE_COLORS);
  if(numbers.size() < 3)
    return;
  soup.face_colors.resize(soup.polygon_ends.size() - 1, {{not_given, not_given, not_given}});
  soup.face_colors.push_back(three(numbers, 0));
  note_alpha(numbers.data(), numbers.size());
}

void Off_attributes::note_alpha(const double* color, std::size_t size)
{
  m_largest_channel = (std::max)(m_largest_channel, *std::max_element(color, color + 3));
  if(size >= 4)
    m_smallest_alpha = (std::min)(m_smallest_alpha, color[3]);
}

void Off_attributes::complete(Polygon_soup& soup) const
{
  complete_colors(soup);
  complete_face_colors(soup);
  if(m_smallest_alpha < (m_largest_channel > 1 ? 255 : 1))
    soup.kinds.insert(Data_kind::TRANSPARENCY);
  if(!soup.normals.empty())
    soup.corner_normals = soup.corners;
  complete_normals(soup);
  if(!m_uvs.empty())
    set_corner_uvs(m_uvs, soup);
}
