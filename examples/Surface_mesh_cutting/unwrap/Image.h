#ifndef UNWRAP_IMAGE_H
#define UNWRAP_IMAGE_H

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// A raster image whose pixels name colors of a palette.
class Image
{
public:
  using Color = std::array<std::uint8_t, 3>;

  Image(int width, int height, std::vector<Color> palette)
    : m_width(width), m_height(height), m_palette(std::move(palette)),
      m_pixels(std::size_t(width) * std::size_t(height), 0)
  {}

  int width() const { return m_width; }
  int height() const { return m_height; }

  std::uint8_t& at(int x, int y)
  {
    return m_pixels[std::size_t(y) * std::size_t(m_width) + std::size_t(x)];
  }

  // The bytes of a PNG file.
  std::string to_png() const;

private:
  int m_width, m_height;
  std::vector<Color> m_palette;
  std::vector<std::uint8_t> m_pixels;
};

#endif // UNWRAP_IMAGE_H
