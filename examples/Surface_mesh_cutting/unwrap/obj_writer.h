#ifndef UNWRAP_OBJ_WRITER_H
#define UNWRAP_OBJ_WRITER_H

#include "Layout.h"

#include <string>

// The mesh with its texture coordinates. `material_file`, if not empty, is the file that
// defines the material.
std::string to_obj(const Layout& layout, const std::string& material_file);

// What that keeps of the input.
Data_kinds kinds_in_obj(const Layout& layout, bool has_own_material);

// The edges of the cut as lines, and the feature points.
std::string cut_to_obj(const Layout& layout);

#endif // UNWRAP_OBJ_WRITER_H
