#include "outputs.h"

#include "Gltf_source.h"
#include "Output_files.h"
#include "Thread_limit.h"
#include "corner_normals.h"
#include "file_extension.h"
#include "gltf_kinds.h"
#include "gltf_writer.h"
#include "html_writer.h"
#include "json_report.h"
#include "layout_of_page.h"
#include "obj_writer.h"
#include "output_names.h"
#include "ply_writer.h"
#include "svg_writer.h"
#include "texture.h"

#include <cstddef>
#include <filesystem>
#include <numeric>
#include <string>

namespace {

std::string material_file_name(const Output_places& places, const Options& options)
{
  return places.material ? std::filesystem::path(material_path(options)).filename().string() : "";
}

Data_kinds kinds_in_mesh(const Options& options, const Layout& layout)
{
  const bool has_own_material = !options.texture.empty();
  return is_gltf(options.output) ? kinds_in_gltf(layout, has_own_material, options.has_tangents)
       : is_ply(options.output) ? kinds_in_ply(layout) : kinds_in_obj(layout, has_own_material);
}

Data_kinds written_kinds(const Options& options, const Layout& layout)
{
  Data_kinds kinds = kinds_in_mesh(options, layout);
  if(options.has_page_files)
    for(const Data_kind left_out : kinds_not_on_pages())
      kinds.erase(left_out);
  return kinds;
}

std::string list_outdated(const Options& options, const Layout& layout)
{
  return layout.gltf_source ? gltf::list_outdated(layout.gltf_source->document, layout.uv_set, options.has_tangents) : "";
}

std::string to_mesh(const Options& options, const Output_places& places, const Layout& layout)
{
  if(is_gltf(options.output))
    return to_gltf(layout, places.texture ? checkerboard_png() : "", options.has_tangents, options.output);
  return is_ply(options.output) ? to_ply(layout, image_from_mesh(options))
                                : to_obj(layout, material_file_name(places, options));
}

// With the normals that glTF has in any case, as pages know nothing of faces on others.
Layout with_normals(Layout layout)
{
  const std::vector<Unit_normal> normals = corner_normals(layout);
  layout.normals.clear();
  for(const Unit_normal& normal : normals)
    layout.normals.push_back({{normal[0], normal[1], normal[2]}});
  layout.corner_normals.resize(normals.size());
  std::iota(layout.corner_normals.begin(), layout.corner_normals.end(), 0);
  return layout;
}

void add_files_of_pages(const Options& options, const Output_places& places, const Layout& layout, const Outcome& outcome,
                        Output_files& files)
{
  const Layout whole = is_gltf(options.output) ? with_normals(layout) : layout;
  for(std::size_t page = 0; page < places.meshes.size(); ++page)
    files.add(*places.meshes[page], to_mesh(options, places, mesh_of_page(whole, int(page))));
  for(std::size_t page = 0; page < places.pictures.size(); ++page)
    files.add(*places.pictures[page], to_svg(picture_of_page(layout, int(page)), outcome, options.svg_style, int(page)));
}

void add_files_of_all(const Options& options, const Output_places& places, const Layout& layout, const Outcome& outcome,
                      Output_files& files)
{
  files.add(*places.meshes.front(), to_mesh(options, places, layout));
  if(!places.pictures.empty())
    files.add(*places.pictures.front(), to_svg(layout, outcome, options.svg_style));
}

} // namespace

std::vector<std::string> warnings_about_outputs(const Options& options, const Output_places& places, const Layout& layout)
{
  std::vector<std::string> warnings;
  if(const std::string outdated = list_outdated(options, layout); !outdated.empty())
    warnings.push_back(outdated + " of the file stay as they are, but belong to its former texture coordinates");
  if(const std::string lost = list_lost(layout.kinds, written_kinds(options, layout)); !lost.empty())
    warnings.push_back("these data of the input are not in " + options.output + ": " + lost);
  if(places.material && is_material_renamed(options))
    warnings.push_back("the material of --texture is in " + material_path(options) + ", as OBJ cannot refer to another name");
  return warnings;
}

void write_outputs(const Options& options, const Output_places& places, const Layout& layout, const Outcome& outcome)
{
  const Thread_limit limit(options.threads);
  const std::string report = to_json(outcome); // once, as what it says of memory changes
  Output_files files;
  const auto add_layout = options.has_page_files ? add_files_of_pages : add_files_of_all;
  add_layout(options, places, layout, outcome, files);
  if(places.cut)
    files.add(*places.cut, cut_to_obj(layout));
  if(places.texture)
    files.add(*places.texture, checkerboard_png());
  if(places.material)
    files.add(*places.material, to_mtl(layout, image_from_mesh(options)));
  if(places.page)
    files.add(*places.page, to_html(layout, report, options));
  if(places.report)
    files.add(*places.report, report);
  files.publish();
}

void write_report(const Output_places& places, const Outcome& outcome)
{
  Output_files files;
  if(places.report)
    files.add(*places.report, to_json(outcome));
  files.publish();
}
