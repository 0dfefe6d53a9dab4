#include "Image.h"

#include <png.h>

#include <stdexcept>

std::string Image::to_png() const
{
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = png_uint_32(m_width);
  header.height = png_uint_32(m_height);
  header.format = PNG_FORMAT_RGB_COLORMAP;
  header.colormap_entries = png_uint_32(m_palette.size());

  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if(png_image_write_to_memory(&header, &bytes[0], &size, 0, m_pixels.data(), 0, m_palette.data())
     == 0)
    throw std::runtime_error(std::string("libpng: ") + header.message);
  bytes.resize(size);
  return bytes;
}
