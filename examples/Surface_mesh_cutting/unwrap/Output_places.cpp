#include "Output_places.h"

#include "file_extension.h"
#include "html_writer.h"
#include "json_report.h"
#include "outcome.h"
#include "output_names.h"
#include "read_gltf.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Named_output
{
  std::string name; // as the user calls it
  std::string file; // the same, but for files of a page
  Output_place place;
  Output_format format;
  std::optional<Output_place>* decision; // where the place goes if it is a good one
};

Output_place find_place_of_report(const std::string& name)
{
  return name == "-" ? standard_output_place() : find_output_place(name);
}

// The files that an output is written to: one for each page, or one for all.
std::vector<std::string> files_of_pages(const Options& options, int number_of_pages, const std::string& name)
{
  if(name.empty())
    return {};
  if(!options.has_page_files)
    return {name};
  std::vector<std::string> files;
  for(int page = 0; page < number_of_pages; ++page)
    files.push_back(file_of_page(name, page));
  return files;
}

// The report comes first: it tells what is wrong with the others.
std::vector<Named_output> find_places(const Options& options, int number_of_pages, Output_places& places)
{
  std::vector<Named_output> outputs;
  const auto add = [&](const std::string& name, Output_format format, std::optional<Output_place>& decision)
  {
    if(!name.empty())
      outputs.push_back({name, name, find_output_place(name), format, &decision});
  };
  const auto add_pages = [&](const std::string& name, Output_format format, std::vector<std::optional<Output_place> >& decisions)
  {
    const std::vector<std::string> files = files_of_pages(options, number_of_pages, name);
    decisions.assign(files.size(), std::nullopt);
    for(std::size_t i = 0; i < files.size(); ++i)
      outputs.push_back({name, files[i], find_output_place(files[i]), format, &decisions[i]});
  };
  if(!options.json.empty())
    outputs.push_back({options.json, options.json, find_place_of_report(options.json), Output_format::REPORT, &places.report});
  add_pages(options.output, Output_format::MESH, places.meshes);
  if(!options.texture.empty() && is_obj(options.output)) // only OBJ needs another file
    add(material_path(options), Output_format::MATERIAL, places.material);
  add(options.texture, Output_format::IMAGE, places.texture);
  add_pages(options.svg, Output_format::PICTURE, places.pictures);
  add(options.html, Output_format::PAGE, places.page);
  add(options.obj_cut, Output_format::LINES, places.cut);
  return outputs;
}

std::vector<std::string> inputs_of(const Options& options)
{
  std::vector<std::string> inputs = constraint_files(options);
  std::error_code error;
  if(options.input != standard_input)
    inputs.push_back(options.input);
  else if(const fs::path file = "/dev/stdin"; fs::is_regular_file(file, error))
    inputs.push_back(file.string());
  if(is_gltf(options.input))
    for(const std::string& file : files_of_gltf(options.input))
      inputs.push_back(file);
  return inputs;
}

// Whether nothing is lost if a report takes this place.
bool is_free_for_report(const fs::path& path)
{
  std::error_code error;
  if(!fs::exists(path, error))
    return true;
  const std::string_view start = start_of_report;
  std::ifstream file(path, std::ios::binary);
  std::string bytes(start.size(), '\0');
  file.read(&bytes[0], std::streamsize(bytes.size()));
  return file && bytes == start;
}

} // namespace

void decide_places(const Options& options, int number_of_pages, Output_places& places)
{
  if(!options.html.empty())
    check_page_can_be_made();
  const std::vector<std::string> inputs = inputs_of(options);
  const std::vector<Named_output> outputs = find_places(options, number_of_pages, places);
  places.names.clear();
  for(const Named_output& output : outputs)
  {
    const auto is_replaced
      = [&](const std::string& input) { return !input.empty() && is_file(output.place, input); };
    const auto is_in_the_way
      = [&](const Named_output& other) { return &other != &output && do_collide(output.place, other.place); };
    if(std::any_of(inputs.begin(), inputs.end(), is_replaced)
       || std::any_of(outputs.begin(), outputs.end(), is_in_the_way))
      throw Failure(Exit_code::USAGE, output.file + " would be written twice or replace an input");
    if(const std::string wrong = find_wrong_ending(output.name, output.format); !wrong.empty())
      throw Failure(Exit_code::USAGE, wrong);
    check_output_place(output.place);
    *output.decision = output.place;
    if(output.name != "-")
      places.names.push_back(output.file);
  }
  for(const std::string& name : {options.output, options.svg})
    if(options.has_page_files && !name.empty() && find_output_place(name).kind != Output_place::Kind::REGULAR_FILE)
      throw Failure(Exit_code::USAGE, name + " is not a file: --page-files makes several");
  check_image_can_be_named(options);
  if(places.material && places.meshes.front()->kind != Output_place::Kind::REGULAR_FILE)
    throw Failure(Exit_code::USAGE, options.output + " is not a file, so the material of --texture cannot be written beside it");
}

void decide_place_of_report(const std::string& name, Output_places& places)
{
  if(name.empty())
    return;
  const Output_place place = find_place_of_report(name);
  if(place.kind == Output_place::Kind::REGULAR_FILE && !is_free_for_report(place.path))
    return;
  check_output_place(place);
  places.report = place;
}
