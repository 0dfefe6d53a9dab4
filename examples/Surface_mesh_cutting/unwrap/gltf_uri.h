// Where a glTF file says that other files are.

#ifndef UNWRAP_GLTF_URI_H
#define UNWRAP_GLTF_URI_H

#include <filesystem>
#include <string>

namespace gltf {

// Whether it holds the data itself.
bool is_data(const std::string& uri);

// Whether it begins like http: or file:.
bool has_scheme(const std::string& uri);

// With %20 and the like decoded.
std::filesystem::path path_of(const std::string& uri);

// The bytes of a data URI, or of a file in or below `folder`; those of other files are not for a glTF file to read.
// Fails if there are none. `what` names the buffer in messages.
std::string read_uri(const std::string& uri, const std::filesystem::path& folder, const std::string& what);

// The same file as seen from another folder; unchanged if it does not depend on the folder.
std::string moved_uri(const std::string& uri, const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace gltf

#endif // UNWRAP_GLTF_URI_H
