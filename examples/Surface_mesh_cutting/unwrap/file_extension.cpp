#include "file_extension.h"

namespace {

bool is_in(const std::vector<std::string>& list, const std::string& ending)
{
  return std::find(list.begin(), list.end(), ending) != list.end();
}

// Whether a file with this ending is surely something else.
bool stands_for_another_format(const std::string& ending)
{
  static const std::vector<std::string> others
    = {".off", ".stl", ".fbx", ".dae", ".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".tga", ".webp", ".pdf"};
  if(is_in(others, ending))
    return true;
  for(const Output_format format : {Output_format::MESH, Output_format::LINES, Output_format::MATERIAL, Output_format::PICTURE, Output_format::IMAGE,
                                    Output_format::PAGE, Output_format::REPORT})
    if(is_in(endings_of(format), ending))
      return true;
  return false;
}

} // namespace

std::string find_wrong_ending(const std::string& path, Output_format format)
{
  const std::string ending = extension_of(path);
  const std::vector<std::string>& endings = endings_of(format);
  if(ending.empty() || is_in(endings, ending))
    return "";
  const bool decides = format == Output_format::MESH || format == Output_format::IMAGE;
  if(!decides && !stands_for_another_format(ending))
    return "";
  std::string list;
  for(const std::string& known : endings)
    list += (list.empty() ? "" : ", ") + known;
  return path + ": " + ending + " is not written here; what is written ends in " + list;
}
