// A glTF file that is to be written.

#ifndef UNWRAP_GLTF_CONTENT_H
#define UNWRAP_GLTF_CONTENT_H

#include "gltf_json.h"

#include <string>

namespace gltf {

// The format's numbers for the uses of a view of a buffer, and for types of components.
constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr int unsigned_byte = 5121, unsigned_short = 5123, unsigned_int = 5125, single = 5126;

struct Content
{
  Json description; // without the buffer
  std::string buffer;
};

// Parts of a buffer begin at multiples of `size`.
void pad(std::string& bytes, char with, std::size_t size = 4);

// A file that holds its buffer itself, binary or as text.
std::string to_binary_file(Content content);
std::string to_text_file(Content content);

} // namespace gltf

#endif // UNWRAP_GLTF_CONTENT_H
