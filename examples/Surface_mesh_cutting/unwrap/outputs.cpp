#include "outputs.h"

#include "Gltf_source.h"
#include "Output_files.h"
#include "Thread_limit.h"
#include "file_extension.h"
#include "gltf_kinds.h"
#include "gltf_writer.h"
#include "html_writer.h"
#include "json_report.h"
#include "obj_writer.h"
#include "output_names.h"
#include "ply_writer.h"
#include "svg_writer.h"
#include "texture.h"

#include <filesystem>
#include <string>

namespace {

std::string material_file_name(const Output_places& places, const Options& options)
{
  return places.material ? std::filesystem::path(material_path(options)).filename().string() : "";
}

Data_kinds written_kinds(const Options& options, const Layout& layout)
{
  const bool has_own_material = !options.texture.empty();
  return is_gltf(options.output) ? kinds_in_gltf(layout, has_own_material, options.has_tangents)
       : is_ply(options.output) ? kinds_in_ply(layout) : kinds_in_obj(layout, has_own_material);
}

std::string list_outdated(const Options& options, const Layout& layout)
{
  return layout.gltf_source ? gltf::list_outdated(layout.gltf_source->document, layout.uv_set, options.has_tangents) : "";
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
  if(is_gltf(options.output))
    files.add(*places.mesh, to_gltf(layout, places.texture ? checkerboard_png() : "", options.has_tangents, options.output));
  else if(is_ply(options.output))
    files.add(*places.mesh, to_ply(layout, image_from_mesh(options)));
  else
    files.add(*places.mesh, to_obj(layout, material_file_name(places, options)));
  if(places.picture)
    files.add(*places.picture, to_svg(layout, outcome, options.svg_style));
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
