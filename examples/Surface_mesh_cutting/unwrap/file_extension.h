#ifndef UNWRAP_FILE_EXTENSION_H
#define UNWRAP_FILE_EXTENSION_H

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

// In lower case, with the dot.
inline std::string extension_of(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

inline bool is_glb(const std::string& path) { return extension_of(path) == ".glb"; } // the binary form of glTF
inline bool is_ply(const std::string& path) { return extension_of(path) == ".ply"; }

#endif // UNWRAP_FILE_EXTENSION_H
