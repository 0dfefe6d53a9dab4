#include "options.h"

#include "command_line_checks.h"
#include "file_extension.h"
#include "help_text.h"
#include "known_edges.h"
#include "option_values.h"
#include "outcome.h"
#include "program_version.h"
#include "run_unwrap.h"

#include <CGAL/Surface_mesh_cutting/internal/soup/Welding.h>
#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>

namespace {

using CGAL::Surface_mesh_cutting::internal::Welding;

void add_input_options(CLI::App& app, Options& options)
{
  const std::string group = "Input";
  app.add_flag("--strict", options.is_strict, "Refuse what is otherwise interpreted (see below)")->group(group);
  add_choice(app, "--weld", options.weld,
             "Whether vertices at exactly the same point count as one;\nauto: for STL and glTF, where (nearly) no faces share a vertex, and\n"
             "where pieces of a few faces nearly all meet at their borders",
             {"auto", "on", "off"})->group(group);
  add_number<double>(app, "--weld-tolerance", options.weld_tolerance,
                     "Weld vertices within T bounding box diagonals, too", 0, Welding::maximal_tolerance)
    ->type_name("T")->default_str("0")->group(group);
}

void add_layout_options(CLI::App& app, Options& options, const std::string& group)
{
  constexpr double largest_margin = 16384;
  constexpr int largest_texture = 65536, largest_pages = 1000, largest_set = 7;
  constexpr double smallest_density = 1e-9, largest_density = 1e9, largest_tolerance = 0.01;
  add_choice(app, "--uv-scale", options.uv_scale,
             "Texture coordinates in the unit square, or at the scale of\nthe surface with charts side by side",
             {"unit", "surface"})->group(group);
  add_choice(app, "--rotate", options.rotate,
             "How charts may be turned: anyhow, by quarter turns from\nwhere they are aligned with the axes, or only aligned;\n"
             "upright: with vertical axes of symmetry",
             {"any", "quarter", "none", "upright"})
    ->default_str("quarter if that fills at least 97 % of any")->group(group);
  add_number<double>(app, "--margin", options.margin, "Texels between charts and to the border of the square", 0, largest_margin)
    ->type_name("T")->default_str("2")->group(group);
  add_number<int>(app, "--texture-size", options.texture_size, "Texels along a side of the square", 1, largest_texture)
    ->type_name("N")->default_str("1024")->group(group);
  add_number<double>(app, "--texels-per-unit", options.texels_per_unit,
                     "Texels per unit of length, on as many pages as that takes", smallest_density, largest_density)
    ->type_name("D")->default_str("as many as fit on the pages")->group(group);
  add_number<int>(app, "--pages", options.most_pages, "Pages to fill at one scale, or at most to take", 1, largest_pages)
    ->type_name("N")->default_str("1; with --texels-per-unit, any")->group(group);
  app.add_flag("--udim", options.is_udim,
               "Pages as UDIM tiles side by side, not on top of each\nother as groups")->group(group);
  app.add_flag("--page-files", options.has_page_files,
               "A mesh and a picture of each page: OUT.1001.obj and so on,\nwith its faces only")->excludes("--udim")->group(group);
  app.add_flag("--pack-only", options.is_pack_only,
               "Keep the charts of the input's texture coordinates: move,\nturn and scale them only")->group(group);
  app.add_flag("--stack", options.is_stacked,
               "Parts that are congruent, or mirror images, are cut once\nand share one place")
    ->excludes("--pack-only")->group(group);
  add_number<double>(app, "--stack-tolerance", options.stack_tolerance,
                     "How far their vertices may be off, in diagonals of a part", 0, largest_tolerance)
    ->type_name("T")->default_str("0.0001")->group(group);
  add_number<double>(app, "--min-fill", options.least_fill,
                     "Divide long charts until this share of the pages is filled,\nif that is worth it", 0, 1)
    ->type_name("F")->default_str("charts stay whole")->excludes("--texels-per-unit")->group(group);
  add_number<int>(app, "--uv-set", options.uv_set,
                  "The set of texture coordinates to write, in glTF and PLY;\nothers stay", 0, largest_set)
    ->type_name("N")->default_str("0")->group(group);
  add_number<int>(app, "--lightmap", options.lightmap,
                  "For a light map of so many texels along a side: set 1, and a\nmargin that lasts down to 128 of them", 1,
                  largest_texture)
    ->type_name("TEXELS")->group(group);
}

void add_output_options(CLI::App& app, Options& options)
{
  const std::string group = "Output";
  app.add_option("-o,--output", options.output,
                 "Mesh with texture coordinates; OBJ, or by the name's end\nglTF (.glb, .gltf) or PLY (.ply) "
                 "(default: name of INPUT\nwith .uv.obj, in the current folder)")
    ->type_name("OUT")->group(group);
  app.add_option("--json", options.json, "Report of measures; - is the standard output")->type_name("FILE")->group(group);
  app.add_option("--svg", options.svg, "Picture of the layout, colored by distortion, and a\nplot of length against distortion")
    ->type_name("FILE")->group(group);
  app.add_option("--texture", options.texture,
                 "Checkerboard image, shown by OUT.obj\n(writes OUT.mtl beside it)")
    ->type_name("FILE.png")->group(group);
  add_choice(app, "--svg-style", options.svg_style,
             "How --svg colors: triangles by distortion, or the two\nsides of each cut alike",
             {"distortion", "partners"})->group(group);
  app.add_option("--html", options.html, "Page that shows surface, layout and measures in a browser")
    ->type_name("FILE")->group(group);
  add_choice(app, "--up", options.up,
             "Which way is up on that page",
             {"x", "y", "z"})->default_str("z for STL, else y")->group(group);
  app.add_flag("--tangents", options.has_tangents,
               "Tangents for normal maps, computed from the new texture\ncoordinates, in glTF where there are normals")->group(group);
  add_layout_options(app, options, group);
  app.add_option("--obj-cut", options.obj_cut, "The cut as lines and its feature points as points,\nin OBJ format")
    ->type_name("FILE")->group(group);
  app.add_flag("--quiet", options.is_quiet, "No progress and no summary, only errors and warnings")->group(group);
  app.add_flag("--progress", options.has_progress_lines,
               "Progress as lines \"PERCENT PHASE\" on the standard error,\nfor programs that run this one")->group(group);
}

// Makes an option take an upper bound on an energy.
CLI::Option* add_bound(CLI::App& app, const std::string& name, std::optional<double>& bound, const std::string& help)
{
  constexpr double largest = 1e9, ideal = 4;
  return app.add_option_function<std::string>(
    name, [=, &bound](const std::string& word) { bound = parse_bound(name, word, ideal, largest); }, help)
    ->type_name("B")->default_str("none");
}

void add_method_options(CLI::App& app, Options& options)
{
  const std::string group = "Method";
  constexpr double least_quantile = 0.001;
  add_choice(app, "--effort", options.effort,
             "How hard to look for a short cut: fast improves\none start a little, default tries a few starts,\nbest many",
             {"fast", "default", "best"})->group(group);
  app.add_flag("--allow-overlap", options.may_overlap,
               "Parts of the layout may overlap (implied by --faithful):\nfaster, and a little less distortion")
    ->group(group);
  app.add_flag("--bijective", options.is_bijective, "No two parts of the layout overlap: the default, but for --faithful")
    ->excludes("--allow-overlap")->group(group);
  add_bound(app, "--max-distortion", options.maximum_average_distortion,
            "Upper bound on the mean energy: 4 is no distortion, 4.1\na stretch of 12 % on average, barely visible")->group(group);
  add_bound(app, "--max-face-distortion", options.maximum_face_distortion,
            "Upper bound on the energy of each triangle")->group(group);
  add_number<double>(app, "--face-quantile", options.face_quantile,
                     "Share of the area whose triangles keep that bound", least_quantile, 1)
    ->type_name("Q")->default_str("1")->group(group);
  add_bound(app, "--max-chart-distortion", options.maximum_chart_distortion,
            "Upper bound on the mean energy of each chart")->group(group);
  add_choice(app, "--symmetry", options.symmetry,
             "Cut symmetric objects symmetrically: at the best plane of\nsymmetry, or at one across an axis, wherever it lies",
             {"auto", "off", "x", "y", "z"})->group(group);
  add_number<double>(app, "--seam-smoothness", options.seam_smoothness,
                     "Percent by which seams may get longer to be straighter", 0, 100)
    ->type_name("S")->default_str("1; 0 if --effort fast or --faithful")->group(group);
}

Weight_choice parse_weights(const std::string& word)
{
  const std::optional<Weight_choice> choice = parse_weight_choice(word);
  if(!choice)
    refuse("--edge-weights: '" + word + "' is not sky:AXIS, with AXIS one of x, y, z, -x, -y and -z, or paint:FILE");
  return *choice;
}

void add_constraint_options(CLI::App& app, Options& options)
{
  const std::string group = "Constraints";
  app.add_option("--must-cut", options.must_cut,
                 "Edges to cut in any case; they may separate the mesh: a\nfile, uv, angle:DEGREES, materials or groups. Can be given\n"
                 "several times")
    ->option_text("EDGES")->allow_extra_args(false)->group(group);
  app.add_option("--never-cut", options.never_cut, "Edges never to cut")->type_name("SEL")->group(group);
  app.add_option("--initial-cut", options.initial_cut,
                 "Cut to start from, such as seams drawn by hand; it is connected,\nextended and shortened, and may lose edges")
    ->type_name("SEL|uv")->group(group);
  app.add_option("--terminals", options.terminals, "Vertices the cut must pass through")
    ->type_name("SEL")->group(group);
  app.add_option_function<std::vector<std::string> >(
       "--edge-weights", [&options](const std::vector<std::string>& words)
       {
         for(const std::string& word : words)
           options.edge_weights.push_back(parse_weights(word));
       },
       "Cost of cutting an edge, instead of its length: crease,\nvisibility, FILE and others (--help-all). Can be given\n"
       "several times: the factors multiply")
    ->option_text("WEIGHTS")->allow_extra_args(false)->group(group);
  app.add_flag_callback("--hard-surface", [&options]
                        {
                          for(const char* const word : {"hard", "straight"})
                            options.edge_weights.push_back(parse_weights(word));
                        },
                        "For modeled parts with flat sides: cuts along hard edges and\nstraight ones; short for "
                        "--edge-weights hard --edge-weights straight")->group(group);
}

void add_run_options(CLI::App& app, Options& options)
{
  const std::string group = "Computation";
  add_number<std::uint32_t>(app, "--seed", options.seed, "Seed of the random numbers", 0,
                            (std::numeric_limits<std::uint32_t>::max)())
    ->type_name("N")->default_str("0")->group(group);
  add_number<int>(app, "--threads", options.threads,
                  "Number of threads; the result does not depend on it", 1, 1024)
    ->type_name("N")->default_str("all cores")->group(group);
  add_choice(app, "--solver", options.solver,
             "Linear solver: the package's own, Eigen's SimplicialLDLT, CHOLMOD",
             available_solvers())->group(group);
  add_number<double>(app, "--time-limit", options.time_limit, "Stop S seconds after the start; 0 stops at once", 0, 1e9)
    ->type_name("S")->default_str("none")->group(group);
}

// The parameters of the paper, last in the help.
void add_published_options(CLI::App& app, Options& options)
{
  const std::string group = "Published method";
  constexpr double largest = 1e9;
  app.add_flag("--faithful", options.is_faithful, "The published method, for comparisons")->group(group);
  add_choice(app, "--connect", options.connect,
             "How to connect the feature points: minimum spanning tree,\nshortest path heuristic, auxiliary points added and exchanged\n(only added with --faithful), proven shortest, or the\nbest within a budget",
             {"mst", "sph", "greedy", "exact", "best"})
    ->default_str("best; greedy if --faithful")->group(group);
  add_number<double>(app, "--eps-iso", options.eps_iso,
                     "Decrease of the mean energy that justifies a feature point", 0, largest)
    ->type_name("X")->default_str("0.01")->group(group);
  add_number<double>(app, "--eps-len", options.eps_len,
                     "Decrease of the length, in bounding box diagonals, that\njustifies an auxiliary point "
                     "(greedy with --faithful); a\ntenth of it, the removal of a piece of the cut", 0, largest)
    ->type_name("X")->default_str("0.01")->group(group);
  add_number<double>(app, "--alpha", options.alpha,
                     "Least share of the area far from the first cut", 0, 1)
    ->type_name("X")->default_str("0.1")->group(group);
  add_number<double>(app, "--beta", options.beta,
                     "Influence radius, in mean edge lengths, above which a\ncandidate is a feature point from the start", 0, largest)
    ->type_name("X")->default_str("20")->group(group);
}

// A light map has a set of its own, if the format has several. Two texels are left of its margin in the level of the mipmap
// that has 128 along a side.
void apply_lightmap(const CLI::App& app, Options& options)
{
  constexpr double texels = 2, coarse_size = 128;
  const auto is_given = [&](const char* name) { return app.get_option(name)->count() > 0; };
  if(!is_given("--texture-size"))
    options.texture_size = *options.lightmap;
  if(!is_given("--margin"))
    options.margin = texels * (std::max)(1., *options.lightmap / coarse_size);
  if(!is_given("--uv-set"))
    options.uv_set = is_obj(options.output) ? 0 : 1;
}

// What the options mean together.
void complete(const CLI::App& app, Options& options)
{
  if(options.lightmap)
    apply_lightmap(app, options);
  if(options.uv_set > 0 && is_obj(options.output))
    refuse("--uv-set needs an output in glTF or PLY: OBJ has one set of texture coordinates");
  if(options.uv_set > 0 && options.has_tangents)
    refuse("--tangents needs --uv-set 0");
  if(options.uv_scale == "unit" && !(2 * options.margin < options.texture_size))
    refuse("--margin must be less than half of --texture-size");
  if(options.uv_scale != "unit" && (options.texels_per_unit || options.most_pages || options.is_udim || options.has_page_files))
    refuse("--texels-per-unit, --pages, --page-files and --udim need --uv-scale unit");
  if(options.is_stacked && options.lightmap)
    refuse("--stack: each part needs a place of its own in a light map");
  if(options.least_fill && options.uv_scale != "unit")
    refuse("--min-fill needs --uv-scale unit");
  if(options.is_pack_only && options.uv_scale != "unit")
    refuse("--pack-only needs --uv-scale unit");
  if(options.is_pack_only &&
     !(options.must_cut.empty() && (options.never_cut + options.initial_cut + options.terminals).empty()))
    refuse("--pack-only keeps the charts as they are: nothing is cut");
  if(options.weld == "off" && options.weld_tolerance > 0)
    refuse("--weld-tolerance needs --weld on or auto");
  for(const std::string& word : options.must_cut)
    is_word_for_edges(word); // or throws
  if(options.face_quantile < 1 && !options.maximum_face_distortion)
    refuse("--face-quantile needs --max-face-distortion");
  if(options.has_tangents && !is_gltf(options.output))
    refuse("--tangents needs an output in glTF: -o OUT.glb or OUT.gltf");
  if(options.output.empty())
    options.output = std::filesystem::path(name_of_input(options.input)).stem().string() + ".uv.obj";
}

} // namespace

bool is_injective(const Options& options)
{
  return options.is_bijective || !(options.may_overlap || options.is_faithful);
}

Attributes wanted_attributes(const Options& options)
{
  const std::vector<std::string>& must_cut = options.must_cut;
  const bool has_uvs = options.is_pack_only || options.initial_cut == seams_of_input ||
                       std::find(must_cut.begin(), must_cut.end(), seams_of_input) != must_cut.end();
  const bool has_source = !options.has_page_files; // which says where everything stands in one file
  return {has_uvs || (options.uv_set > 0 && is_gltf(options.output)), options.weld != "off", true,
          has_source && is_ply(options.output), has_source && is_gltf(options.output), options.uv_set};
}

std::vector<std::string> constraint_files(const Options& options)
{
  std::vector<std::string> files = {options.never_cut, options.terminals};
  if(options.initial_cut != seams_of_input)
    files.push_back(options.initial_cut);
  std::copy_if(options.must_cut.begin(), options.must_cut.end(), std::back_inserter(files),
               [](const std::string& word) { return !is_word_for_edges(word); });
  for(const Weight_choice& choice : options.edge_weights)
    files.push_back(choice.file);
  files.erase(std::remove(files.begin(), files.end(), ""), files.end());
  return files;
}

Command_line parse_command_line(int argc, char** argv)
{
  Command_line result;
  Options& options = result.options;
  options.threads = available_threads();
  options.solver = available_solvers().front();

  CLI::App app(program_description, "unwrap");
  app.formatter(std::make_shared<Help_formatter>());
  app.set_help_flag("-h,--help", "The most important options");
  app.set_help_all_flag("--help-all", "All options, how input is read, weights, exit status");
  app.set_version_flag("--version", std::string("unwrap ") + program_version + " (CGAL " CGAL_VERSION_STR ")",
                       "The version of this program, and of CGAL");
  app.add_option("INPUT", options.input, "Mesh file; - is the standard input")->type_name("")->required();
  add_input_options(app, options);
  add_output_options(app, options);
  add_method_options(app, options);
  add_constraint_options(app, options);
  add_run_options(app, options);
  add_published_options(app, options);
  try
  {
    check_options(app, argc, argv);
    app.parse(argc, argv);
    check_no_value_is_empty(app);
    complete(app, options);
  }
  catch(const CLI::Success& success) // help or version
  {
    result.is_done = true;
    result.exit_code = app.exit(success);
  }
  catch(const CLI::ParseError& error)
  {
    const bool has_second_input = error.get_exit_code() == int(CLI::ExitCodes::ExtrasError);
    result.is_done = true;
    result.exit_code = int(Exit_code::USAGE);
    result.message = error.what() + std::string(has_second_input ? "; the output is named with -o" : "");
    options.json = find_json_file(argc, argv);
  }
  return result;
}
