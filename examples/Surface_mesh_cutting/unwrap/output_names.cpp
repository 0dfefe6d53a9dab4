#include "output_names.h"

#include "file_extension.h"
#include "outcome.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/Page_tile.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace {

namespace fs = std::filesystem;

bool is_control(unsigned char c) { return c < 32 || c == 127; }

bool is_more_than_a_letter(unsigned char c) { return is_control(c) || c == ' ' || c == '#' || c == '\\'; }

} // namespace

std::string material_path(const Options& options)
{
  const fs::path output = options.output;
  std::string name = output.stem().string();
  std::replace_if(name.begin(), name.end(), is_more_than_a_letter, '_');
  return (output.parent_path() / (name + ".mtl")).string();
}

bool is_material_renamed(const Options& options)
{
  return fs::path(material_path(options)).stem() != fs::path(options.output).stem();
}

std::string file_of_page(const std::string& name, int page)
{
  const fs::path path = name;
  const std::string tile = std::to_string(CGAL::Surface_mesh_cutting::internal::tile_of_page(page));
  return (path.parent_path() / (path.stem().string() + "." + tile + path.extension().string())).string();
}

std::string image_from_mesh(const Options& options)
{
  if(options.texture.empty())
    return "";
  const fs::path folder = fs::absolute(options.output).parent_path();
  return fs::absolute(options.texture).lexically_relative(folder).generic_string();
}

void check_image_can_be_named(const Options& options)
{
  const std::string name = image_from_mesh(options);
  if(!is_gltf(options.output) && std::any_of(name.begin(), name.end(), is_control))
    throw Failure(Exit_code::USAGE, "--texture: a mesh cannot refer to a file whose name has a control character");
}
