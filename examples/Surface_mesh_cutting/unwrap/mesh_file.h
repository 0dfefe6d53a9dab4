// Reading of mesh files.
//
// The readers are our own because those of CGAL trust what a file says about itself: a header with
// wrong counts makes them allocate gigabytes, and several defects pass unnoticed or undescribed.
// Here nothing is allocated that the size of the file does not account for, and every error
// says where it is.

#ifndef UNWRAP_MESH_FILE_H
#define UNWRAP_MESH_FILE_H

#include "Polygon_soup.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

// The input of this name is the standard input.
inline const std::string standard_input = "-";

// How the input is called in messages and in names of outputs.
inline std::string name_of_input(const std::string& path) { return path == standard_input ? "stdin" : path; }

// What to read besides points and polygons, where the format has it.
struct Attributes
{
  bool has_uvs = false;
  bool has_merged_points = true; // of STL and glTF
  bool has_looks = false;        // colors, normals, groups and materials
  bool has_source = false;       // of PLY, all that it says
  bool has_gltf_source = false;  // the same of glTF, which shows a mesh at several places: each is read once
  int uv_set = 0;                // which to read, or the first one where it is missing, and which to replace
};

// Reads OFF, OBJ, PLY, STL, and what else CGAL reads. Points and polygons keep number and order;
// only for STL, which has no indices, exactly equal points become one unless asked otherwise.
// Throws a `Failure` with `Exit_code::UNREADABLE`.
Polygon_soup read_mesh_file(const std::string& path, Attributes attributes = {});

// Fails in the same way unless all indices are in range.
void check_indices(const Polygon_soup& soup);

// Readers of one format, given the bytes of the file. Indices may be out of range.
Polygon_soup read_off(std::string_view text, Attributes attributes = {});
Polygon_soup read_obj(std::string_view text, Attributes attributes = {});
Polygon_soup read_ply(std::string_view bytes, Attributes attributes = {});
Polygon_soup read_stl(std::string_view bytes, Attributes attributes = {});

// How many bytes a binary STL file with this header has; none if the header is not complete.
std::optional<std::size_t> size_of_binary_stl(std::string_view bytes);

// Whether the first word is the one with which an STL file of text starts.
bool starts_text_stl(std::string_view bytes);

#endif // UNWRAP_MESH_FILE_H
