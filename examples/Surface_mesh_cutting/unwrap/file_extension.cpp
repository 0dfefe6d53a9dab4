#include "file_extension.h"

namespace {

bool is_in(const std::vector<std::string>& list, const std::string& ending)
{
  return std::find(list.begin(), list.end(), ending) != list.end();
}

// Of formats of the same kind, which somebody may expect instead.
const std::vector<std::string>& alternatives_to(Output_format format)
{
  static const std::vector<std::string> meshes
    = {".ply", ".glb", ".gltf", ".off", ".stl", ".fbx", ".dae", ".3ds", ".usd", ".usdz", ".dxf"};
  static const std::vector<std::string> pictures = {".svg", ".html", ".htm", ".png", ".jpg", ".jpeg", ".gif", ".bmp", ".tif",
                                                    ".tiff", ".tga", ".webp", ".pdf", ".eps", ".ps"};
  static const std::vector<std::string> texts = {".csv", ".xml", ".yaml", ".yml", ".toml", ".html"};
  return format == Output_format::REPORT ? texts : format == Output_format::LINES ? meshes : pictures;
}

} // namespace

std::string find_wrong_ending(const std::string& path, Output_format format)
{
  const std::string ending = extension_of(path);
  const std::vector<std::string>& endings = endings_of(format);
  if(ending.empty() || is_in(endings, ending))
    return "";
  const bool decides = format == Output_format::MESH || format == Output_format::IMAGE;
  if(!decides && !is_in(alternatives_to(format), ending))
    return "";
  std::string list;
  for(const std::string& known : endings)
    list += (list.empty() ? "" : ", ") + known;
  return path + ": " + ending + " is not written here; what is written ends in " + list;
}
