// How the files of an output name each other.

#ifndef UNWRAP_OUTPUT_NAMES_H
#define UNWRAP_OUTPUT_NAMES_H

#include "options.h"

#include <string>

// The material file of an OBJ: beside it, with its name, but with _ where readers of OBJ take a character for something
// else than a part of a name.
std::string material_path(const Options& options);
bool is_material_renamed(const Options& options);

// The file of a page, which is called as its tile of UDIM: mesh.obj becomes mesh.1001.obj, mesh.1002.obj, and so on.
std::string file_of_page(const std::string& name, int page);

// The image's name as seen from the folder of the mesh, where the material is, too; empty without one.
std::string image_from_mesh(const Options& options);

// Throws a `Failure` with `Exit_code::USAGE` if a file of text must name the image and cannot.
void check_image_can_be_named(const Options& options);

#endif // UNWRAP_OUTPUT_NAMES_H
