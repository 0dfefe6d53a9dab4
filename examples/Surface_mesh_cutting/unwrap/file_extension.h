#ifndef UNWRAP_FILE_EXTENSION_H
#define UNWRAP_FILE_EXTENSION_H

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

// In lower case, with the dot.
inline std::string extension_of(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

// The outputs that are written, by the endings of their names.
enum class Output_format { MESH, LINES, MATERIAL, PICTURE, IMAGE, PAGE, REPORT };

inline const std::vector<std::string>& endings_of(Output_format format)
{
  static const std::vector<std::vector<std::string> > endings
    = {{".obj", ".glb", ".ply"}, {".obj"}, {".mtl"}, {".svg"}, {".png"}, {".html", ".htm"}, {".json"}};
  return endings[std::size_t(format)];
}

// Why a file of this name should not be written, or empty. A name may have no ending; but for meshes and images, whose
// ending decides how others read them, it may also be one that stands for nothing else.
std::string find_wrong_ending(const std::string& path, Output_format format);

inline bool is_glb(const std::string& path) { return extension_of(path) == ".glb"; } // the binary form of glTF
inline bool is_for_printing(const std::string& path) { return extension_of(path) == ".stl" || extension_of(path) == ".3mf"; }
inline bool is_ply(const std::string& path) { return extension_of(path) == ".ply"; }
inline bool is_obj(const std::string& path) { return !is_glb(path) && !is_ply(path); } // also without an ending

#endif // UNWRAP_FILE_EXTENSION_H
