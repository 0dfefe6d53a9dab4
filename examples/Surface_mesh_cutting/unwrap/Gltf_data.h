// The data of a glTF file, of which parts are replaced.

#ifndef UNWRAP_GLTF_DATA_H
#define UNWRAP_GLTF_DATA_H

#include "Gltf_content.h"
#include "Gltf_document.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace gltf {

class Data
{
public:
  // Without compressed copies of the data, which would contradict it.
  explicit Data(const Document& document);

  // To be changed, but for accessors, views and buffers.
  Json& description() { return m_description; }

  // How many places of the file refer to an accessor.
  std::size_t number_of_uses(std::size_t accessor) const { return m_uses[accessor]; }

  // Adds an accessor, or replaces the one with this number. `stride`: from one element to the next. Returns its number.
  std::size_t put_accessor(std::optional<std::size_t> number, Json accessor, std::string bytes, std::size_t stride,
                           int target);

  // Adds a view of these bytes. Its number is valid until `content()`, for images.
  std::size_t add_view(std::string bytes, Json view = Json::object());

  // All data in one buffer, without what nothing refers to any more.
  Content content();

private:
  std::string place_former_views(const std::vector<char>& is_replaced);

  const Document& m_document;
  Json m_description;
  const std::size_t m_number_of_former_views;
  std::vector<std::size_t> m_uses;
  std::vector<char> m_was_used; // per view, before anything is replaced
  std::vector<std::string> m_new_bytes; // of views behind the former ones
};

} // namespace gltf

#endif // UNWRAP_GLTF_DATA_H
