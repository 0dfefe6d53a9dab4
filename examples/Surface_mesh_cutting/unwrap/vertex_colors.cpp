#include "vertex_colors.h"

#include <algorithm>
#include <string_view>

void complete_fractions(std::vector<std::array<double, 3> >& colors)
{
  constexpr double largest = 255;
  double maximum = 0;
  for(const std::array<double, 3>& color : colors)
    for(const double channel : color)
      maximum = (std::max)(maximum, channel);
  if(maximum > 1)
    for(std::array<double, 3>& color : colors)
      for(double& channel : color)
        channel /= largest;
}

void read_color(Text_scanner& scanner, Polygon_soup& soup)
{
  const std::string_view red = scanner.word_in_line();
  const std::string_view green = scanner.word_in_line(), blue = scanner.word_in_line();
  if(!red.empty() && !green.empty() && !blue.empty())
    soup.colors.push_back({{number_or_nan(red), number_or_nan(green), number_or_nan(blue)}});
}

void complete_colors(Polygon_soup& soup)
{
  if(soup.colors.size() != soup.points.size())
    soup.colors.clear();
  complete_fractions(soup.colors);
}

std::optional<int> find_wrong_color(const Polygon_soup& soup)
{
  const auto is_wrong = [](const std::array<double, 3>& color)
  { return !std::all_of(color.begin(), color.end(), [](double channel) { return channel >= 0 && channel <= 1; }); };
  const auto wrong = std::find_if(soup.colors.begin(), soup.colors.end(), is_wrong);
  return wrong == soup.colors.end() ? std::nullopt : std::make_optional(int(wrong - soup.colors.begin()));
}
