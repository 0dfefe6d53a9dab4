#include "Data_kinds.h"

namespace {

std::string name_of(Data_kind kind)
{
  switch(kind)
  {
    case Data_kind::NORMALS: return "normals";
    case Data_kind::COLORS: return "colors of vertices";
    case Data_kind::FACE_COLORS: return "colors of faces";
    case Data_kind::TRANSPARENCY: return "transparency of colors";
    case Data_kind::MATERIALS: return "materials";
    case Data_kind::MATERIAL_FILES: return "names of material files";
    case Data_kind::IMAGES: return "images of textures";
    case Data_kind::LOOKS_OF_MATERIALS: return "colors and textures of materials";
    case Data_kind::GROUPS: return "groups and objects";
    case Data_kind::SMOOTHING_GROUPS: return "smoothing groups";
    case Data_kind::LINES: return "lines";
    case Data_kind::POINTS: return "points";
    case Data_kind::CURVES_AND_SURFACES: return "curves and surfaces";
    case Data_kind::POINT_WEIGHTS: return "weights of vertices";
    case Data_kind::DISPLAY_SETTINGS: return "display settings";
    case Data_kind::UNKNOWN_STATEMENTS: return "unknown statements";
    case Data_kind::OTHER_PROPERTIES: return "other properties and elements";
    case Data_kind::ATTRIBUTE_BYTES: return "attribute bytes (colors)";
    case Data_kind::OTHER_UV_SETS: return "other sets of texture coordinates";
    case Data_kind::TANGENTS: return "tangents";
    case Data_kind::MORPH_TARGETS: return "morph targets";
    case Data_kind::TANGENTS_OF_MORPH_TARGETS: return "tangents of morph targets";
    case Data_kind::SKINS: return "skins";
    case Data_kind::ANIMATIONS: return "animations";
    case Data_kind::CAMERAS: return "cameras";
    case Data_kind::POINTS_AND_LINES: return "points and lines";
    case Data_kind::EXTRAS: return "extras and extensions";
    case Data_kind::UNKNOWN_CHUNKS: return "chunks of unknown kinds";
    case Data_kind::COMMENTS: return "comments";
  }
  return "";
}

} // namespace

std::string list_lost(const Data_kinds& met, const Data_kinds& written)
{
  std::string names;
  for(const Data_kind kind : met)
    if(written.count(kind) == 0)
      names += (names.empty() ? "" : ", ") + name_of(kind);
  return names;
}
