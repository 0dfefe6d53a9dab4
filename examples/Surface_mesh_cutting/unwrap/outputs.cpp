#include "outputs.h"

#include "Output_files.h"
#include "json_report.h"
#include "obj_writer.h"
#include "svg_writer.h"
#include "texture.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

constexpr const char* standard_output = "-";

// The material file beside the mesh, if there is to be one.
fs::path material_file(const Options& options)
{
  return options.texture.empty() ? fs::path() : fs::path(options.output).replace_extension(".mtl");
}

// The image's name as seen from the folder of the material file.
std::string image_from_material(const Options& options)
{
  const fs::path folder = fs::absolute(options.output).parent_path();
  return fs::absolute(options.texture).lexically_relative(folder).generic_string();
}

void write_standard_output(const std::string& text)
{
  errno = 0;
  if(std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw Failure(Exit_code::USAGE,
                  std::string("cannot write the report: ") + std::strerror(errno));
}

} // namespace

void check_outputs(const Options& options)
{
  std::vector<fs::path> places;
  for(const std::string& file : {options.input, options.must_cut, options.never_cut, options.initial_cut,
                                 options.terminals, options.edge_weights})
    if(!file.empty())
      places.push_back(Output_files::place_of(file));
  for(const std::string& file : {options.output, options.svg, options.texture, options.obj_cut,
                                 options.json, material_file(options).string()})
  {
    if(file.empty() || (file == options.json && file == standard_output))
      continue;
    Output_files::check(file);
    const fs::path place = Output_files::place_of(file);
    if(Output_files::is_replaced(place)
       && std::find(places.begin(), places.end(), place) != places.end())
      throw Failure(Exit_code::USAGE, file + " would be written twice or replace an input");
    places.push_back(place);
  }
}

void write_outputs(const Options& options, const Layout& layout, const Outcome& outcome)
{
  Output_files files;
  files.write(options.output, to_obj(layout, material_file(options).filename().string()));
  if(!options.svg.empty())
    files.write(options.svg, to_svg(layout, outcome));
  if(!options.obj_cut.empty())
    files.write(options.obj_cut, cut_to_obj(layout));
  if(!options.texture.empty())
  {
    files.write(options.texture, checkerboard_png());
    files.write(material_file(options).string(), to_mtl(layout, image_from_material(options)));
  }
  if(options.json == standard_output)
    write_standard_output(to_json(outcome));
  else if(!options.json.empty())
    files.write(options.json, to_json(outcome));
  files.publish();
}

void write_report(const Options& options, const Outcome& outcome)
{
  if(options.json == standard_output)
    write_standard_output(to_json(outcome));
  else if(!options.json.empty())
  {
    Output_files files;
    files.write(options.json, to_json(outcome));
    files.publish();
  }
}
