// A glTF file as it is: its description, and the bytes to which that refers.

#ifndef UNWRAP_GLTF_DOCUMENT_H
#define UNWRAP_GLTF_DOCUMENT_H

#include "gltf_json.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace gltf {

class Document
{
public:
  // Fails unless these are the bytes of a file, text or binary, of version 2 of the format, which requires nothing that
  // may hide its meshes. Other files, in `folder`, are read when they are asked for; none if that is empty.
  Document(const std::string& bytes, std::filesystem::path folder);

  const Json& description() const { return m_description; }
  const std::filesystem::path& folder() const { return m_folder; }

  // Chunks of a binary file that the standard says to ignore.
  bool has_unknown_chunks() const { return m_has_unknown_chunks; }

  // Valid as long as the document.
  std::string_view buffer(std::size_t index) const;
  std::string_view view(std::size_t index) const; // of a buffer

  // Reads all buffers that have views, so that none of these fails later.
  void read_all() const;

private:
  std::filesystem::path m_folder;
  std::optional<std::string> m_chunk; // the buffer inside a binary file
  Json m_description;
  mutable std::map<std::size_t, std::string> m_buffers;
  bool m_has_unknown_chunks = false;
};

Document read_document(const std::string& path);

// The description alone, whatever it says.
Json read_description(const std::string& bytes);

// Fails as data are there only in the form of this extension.
[[noreturn]] void fail_about_compression(const std::string& what, const std::string& extension);

// Whether what an extension says is only about looks, or about places in the scene: not about meshes, and without indices
// of accessors and views.
bool is_about_looks(const std::string& extension);

} // namespace gltf

#endif // UNWRAP_GLTF_DOCUMENT_H
