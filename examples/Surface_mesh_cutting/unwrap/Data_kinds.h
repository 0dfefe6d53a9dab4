// The kinds of data in mesh files besides points, polygons, and the texture coordinates that a run replaces.

#ifndef UNWRAP_DATA_KINDS_H
#define UNWRAP_DATA_KINDS_H

#include <set>
#include <string>

// In the order in which a warning lists them. A kind that only files of one format have needs no writer but that format's.
enum class Data_kind
{
  NORMALS,
  COLORS,       // of points
  FACE_COLORS,
  TRANSPARENCY, // of colors
  MATERIALS,
  MATERIAL_FILES,
  IMAGES, // of textures
  LOOKS_OF_MATERIALS, // of glTF, besides their names
  GROUPS, // and objects
  SMOOTHING_GROUPS,
  LINES,
  POINTS, // drawn as such
  CURVES_AND_SURFACES,
  POINT_WEIGHTS, // of rational curves and surfaces
  DISPLAY_SETTINGS,
  UNKNOWN_STATEMENTS,
  OTHER_PROPERTIES, // of points and polygons, and elements of other kinds
  ATTRIBUTE_BYTES,  // of STL, of which some programs make colors
  OTHER_UV_SETS,
  TANGENTS,
  MORPH_TARGETS,
  TANGENTS_OF_MORPH_TARGETS,
  SKINS,
  ANIMATIONS,
  CAMERAS,
  POINTS_AND_LINES, // of glTF
  EXTRAS, // of glTF: what users and extensions say
  UNKNOWN_CHUNKS, // of binary glTF
  COMMENTS
};

// Readers list what they met, writers what they write.
using Data_kinds = std::set<Data_kind>;

// The kinds that are in `met` but not in `written`, as words between commas; empty if there are none.
std::string list_lost(const Data_kinds& met, const Data_kinds& written);

#endif // UNWRAP_DATA_KINDS_H
