#include "distortion_image.h"

#include "layout_energies.h"
#include "stretch.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using Point = std::array<double, 2>;

constexpr int number_of_shades = 250;

// The background, then the shades.
std::vector<Image::Color> make_palette()
{
  std::vector<Image::Color> palette = {{{255, 255, 255}}};
  for(int shade = 0; shade < number_of_shades; ++shade)
  {
    const double position = double(shade) / (number_of_shades - 1) * (distortion_colors.size() - 1);
    const std::size_t i = (std::min)(std::size_t(position), distortion_colors.size() - 2);
    Image::Color color;
    for(std::size_t channel = 0; channel < 3; ++channel)
    {
      const double from = distortion_colors[i][channel], to = distortion_colors[i + 1][channel];
      color[channel] = std::uint8_t(std::lround(from + (position - double(i)) * (to - from)));
    }
    palette.push_back(color);
  }
  return palette;
}

// Fills the pixels whose center is inside, row by row. Coordinates are in pixels.
void fill_triangle(const std::array<Point, 3>& corners, std::uint8_t color, Image& image)
{
  const auto y_range = std::minmax({corners[0][1], corners[1][1], corners[2][1]});
  const int last = (std::min)(image.height() - 1, int(std::floor(y_range.second - 0.5)));
  for(int row = (std::max)(0, int(std::ceil(y_range.first - 0.5))); row <= last; ++row)
  {
    const double y = row + 0.5;
    double left = image.width(), right = 0;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Point &a = corners[k], &b = corners[(k + 1) % 3];
      if((a[1] <= y) == (b[1] <= y))
        continue;
      const double x = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      left = (std::min)(left, x);
      right = (std::max)(right, x);
    }
    const int end = (std::min)(image.width() - 1, int(std::floor(right - 0.5)));
    for(int column = (std::max)(0, int(std::ceil(left - 0.5))); column <= end; ++column)
      image.at(column, row) = color;
  }
}

} // namespace

double position_on_scale(double energy)
{
  return (std::min)(1., std::log(stretch_of(energy)) / std::log(4.));
}

Image draw_distortion(const Layout& layout, const Point& low, double pixel, int width, int height)
{
  Image image(width, height, make_palette());
  const std::vector<double> energies = layout_energies(layout);
  for(std::size_t f = 0; f < layout.uv_triangles.size(); ++f)
  {
    std::array<Point, 3> corners;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Point& uv = layout.uv_points[std::size_t(layout.uv_triangles[f][k])];
      corners[k] = {{(uv[0] - low[0]) / pixel, height - (uv[1] - low[1]) / pixel}};
    }
    const double position = position_on_scale(energies[f]);
    fill_triangle(corners, std::uint8_t(1 + std::lround(position * (number_of_shades - 1))), image);
  }
  return image;
}
