#include "texture.h"

#include "Image.h"
#include "Number_writer.h"

#include <utility>

std::string checkerboard_png()
{
  constexpr int squares = 8, size = 512;
  const std::vector<Image::Color> palette = {{{245, 245, 240}}, {{70, 110, 150}},
                                             {{220, 220, 210}}, {{40, 70, 110}}};
  Image image(size, size, palette);
  for(int y = 0; y < size; ++y)
    for(int x = 0; x < size; ++x)
    {
      const int column = x * squares / size, row = y * squares / size;
      const bool is_marked = (column < squares / 2) == (row < squares / 2); // larger squares
      image.at(x, y) = std::uint8_t((column + row) % 2 + (is_marked ? 2 : 0));
    }
  return image.to_png();
}

std::string to_mtl(const Layout& layout, const std::string& image)
{
  // Show the image five times along the surface.
  const double scale = 5 / (layout.bounding_box_diagonal * layout.uv_scale);
  Number_writer out;
  out << "newmtl " << material_name << "\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nmap_Kd -s " << scale << " "
      << scale << " 1 " << image << "\n";
  return std::move(out).text();
}
