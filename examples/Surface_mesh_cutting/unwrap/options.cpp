#include "options.h"

#include "argument_checks.h"
#include "file_extension.h"
#include "outcome.h"
#include "run_unwrap.h"

#include <CGAL/Surface_mesh_cutting/internal/soup/Welding.h>
#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <limits>
#include <system_error>

namespace {

using CGAL::Surface_mesh_cutting::internal::Welding;

const char* const description =
  "Unwraps a mesh: finds a short cut along which the surface opens and flattens with little\n"
  "distortion, and writes the mesh with texture coordinates.\n";

const char* const footer = R"(
Input: OFF, OBJ, PLY, STL, glTF, and whatever else CGAL reads. Nothing is repaired, everything is
interpreted: vertices and faces keep their number and order (only STL and glTF, which repeat points,
get equal ones merged). Faces may have any number of corners; they are never cut across. Edges
with more than two faces keep pairs of them connected and are open to the others; vertices of
several fans are as many vertices; where neighbors disagree about which side is up, as few
faces as possible are read backward; faces without area, and faces given again, get the
texture coordinates of the place where they lie. The report lists all this in "interpreted";
--strict refuses it.

Output: texture coordinates lie in the unit square, charts apart by the margin and all at the same
scale (uv_scale in the report), and no two triangles overlap. Corners share one unless a cut edge lies
between them. From OBJ to OBJ and PLY to PLY, all else stays. Files appear when the run is complete.

Constraints: SEL is a CGAL .selection.txt file: three lines with vertices, faces, and edges as pairs
of vertices, all counted from 0. For --must-cut and --initial-cut, uv stands for the seams of the
texture coordinates in INPUT, the edges at which those of the two faces differ (vt of OBJ,
texcoord or s and t of PLY, TEXCOORD_0 of glTF, STOFF).

Weights: what a cut costs, by default its length, times the factors of all --edge-weights given:
  crease          0.2 at sharp edges, up to 1 where the surface is flat
  concave         the same, but 0.6 at sharp convex edges
  straight        0.2 along and across the direction in which the surface bends most, up to 1
                  between them and where it bends alike in all directions
  visibility      0.25 where the surface hides the edge from all sides, up to 1
  occlusion       the same, hidden only by what is within a tenth of the bounding box diagonal
  sky, sky:AXIS   the same, seen from above only; AXIS is x, y (default), z, -x, -y or -z
  colors          0.2 where the red channel of the vertex colors in INPUT is 0, up to 1 where it is
                  full (COFF; OBJ with red, green and blue behind coordinates; PLY with red)
  paint:FILE      the mean of the numbers at both ends; FILE has one number, at least 0, in each
                  line for each vertex, or a vertex and its number; other vertices have 1
  FILE            weight over length; FILE has the two vertices and the weight of an edge in each
                  line, at least 0, or inf for an edge never to cut; other edges have 1
A file whose name is one of these words can be given as ./NAME.

Exit status:
  0  done
  2  wrong usage, or an output cannot be written
  3  the input cannot be read, is truncated, or has indices out of range
  4  the mesh is not supported (coordinates that are not finite, no faces; with --strict, also what
     is not triangles, not a manifold or inconsistently oriented), no cut satisfies the constraints,
     or the margins leave no room for so many charts; the message says where, counting from 0
  5  no valid result was found
  6  stopped by the time limit, which counts from the start of the program, or by Ctrl-C (a second
     Ctrl-C ends at once); a valid result found by then is written, and the message says so
  7  the result is valid, but misses a requested bound, or the proof that --connect exact asks for
With 2 to 5, only the JSON report is written. No output replaces an input or another output; if
--json names such a place, there is no report. If the command line is not understood, the report
replaces at most a former report.

Examples:
  unwrap cow.off
      writes cow.uv.obj
Output:
  unwrap cow.off -o flat.obj --texture check.png
      open flat.obj in any viewer: where the squares are square, nothing is distorted
  unwrap cow.off --svg flat.svg --json -
      a picture, and the measures on the terminal
  unwrap cow.off --html cow.html
      a page to look at: the surface, its layout, the measures; open it in any browser
  unwrap parts.stl --margin 4 --texture-size 2048
      charts at least 4 texels apart on a texture of 2048 by 2048
Method:
  unwrap cow.off --max-distortion 4.1
      the shortest cut found that leaves barely visible distortion
Constraints:
  unwrap cow.off --never-cut face.selection.txt --edge-weights visibility
      no cut across the face, and elsewhere where it is hard to see
  unwrap cow.obj --initial-cut uv --edge-weights concave --edge-weights paint:cost.txt
      improves the seams that cow.obj has, in folds and where the user painted low costs
Computation:
  unwrap cow.off --effort best --time-limit 60
      the best result found within a minute
)";

// Whole decimal numbers, nothing else: CLI11 would take 010 for eight and NaN for in range.
template <typename Number>
bool parse_number(const std::string& word, Number& number)
{
  const char* const end = word.data() + word.size();
  const std::from_chars_result parsed = std::from_chars(word.data(), end, number);
  return !word.empty() && parsed.ptr == end && parsed.ec == std::errc();
}

template <typename Number>
Number parse_number(const std::string& option, const std::string& word, Number low, Number high)
{
  Number result = 0;
  if(!parse_number(word, result) || !(low <= result) || !(result <= high))
  {
    std::ostringstream message;
    message << option << ": '" << word << "' is not a number from " << low << " to " << high;
    refuse(message.str());
  }
  return result;
}

double parse_bound(const std::string& option, const std::string& word, double ideal, double high)
{
  double result = 0;
  if(!parse_number(word, result) || !(ideal < result) || !(result <= high))
  {
    std::ostringstream message;
    message << option << " must be greater than " << ideal << " and at most " << high << ", not '" << word << "'";
    refuse(message.str());
  }
  return result;
}

template <typename Number, typename Target>
CLI::Option* add_number(CLI::App& app, const std::string& name, Target& target,
                        const std::string& help, Number low, Number high)
{
  return app.add_option_function<std::string>(
    name, [=, &target](const std::string& word) { target = parse_number(name, word, low, high); },
    help);
}

void add_input_options(CLI::App& app, Options& options)
{
  const std::string group = "Input";
  app.add_flag("--strict", options.is_strict, "Refuse what is otherwise interpreted (see below)")->group(group);
  app.add_option("--weld", options.weld,
                 "Whether vertices at exactly the same point count as one;\nauto: for STL, where (nearly) no faces share a vertex, and\n"
                 "where pieces of a few faces nearly all meet at their borders")
    ->check(CLI::IsMember({"auto", "on", "off"}))->default_str(options.weld)->group(group);
  add_number<double>(app, "--weld-tolerance", options.weld_tolerance,
                     "Weld vertices within T bounding box diagonals, too", 0, Welding::maximal_tolerance)
    ->type_name("T")->default_str("0")->group(group);
}

void add_layout_options(CLI::App& app, Options& options, const std::string& group)
{
  constexpr double largest_margin = 16384;
  constexpr int largest_texture = 65536;
  app.add_option("--uv-scale", options.uv_scale,
                 "Texture coordinates in the unit square, or at the scale of\nthe surface with charts side by side")
    ->check(CLI::IsMember({"unit", "surface"}))->default_str(options.uv_scale)->group(group);
  add_number<double>(app, "--margin", options.margin, "Texels between charts and to the border of the square", 0, largest_margin)
    ->type_name("T")->default_str("2")->group(group);
  add_number<int>(app, "--texture-size", options.texture_size, "Texels along a side of the square", 1, largest_texture)
    ->type_name("N")->default_str("1024")->group(group);
}

void add_output_options(CLI::App& app, Options& options)
{
  const std::string group = "Output";
  app.add_option("-o,--output", options.output,
                 "Mesh with texture coordinates; OBJ, or by the name's end\nbinary glTF (.glb) or PLY (.ply) "
                 "(default: name of INPUT\nwith .uv.obj, in the current folder)")
    ->type_name("OUT")->group(group);
  app.add_option("--json", options.json, "Report of measures; - is the standard output")->type_name("FILE")->group(group);
  app.add_option("--svg", options.svg, "Picture of the layout, colored by distortion, and a\nplot of length against distortion")
    ->type_name("FILE")->group(group);
  app.add_option("--texture", options.texture,
                 "Checkerboard image, shown by OUT.obj\n(writes OUT.mtl beside it)")
    ->type_name("FILE.png")->group(group);
  app.add_option("--svg-style", options.svg_style, "How --svg colors: triangles by distortion, or the two\nsides of each cut alike")
    ->check(CLI::IsMember({"distortion", "partners"}))->default_str(options.svg_style)->group(group);
  app.add_option("--html", options.html, "Page that shows surface, layout and measures in a browser")
    ->type_name("FILE")->group(group);
  add_layout_options(app, options, group);
  app.add_option("--obj-cut", options.obj_cut, "The cut as lines and its feature points as points,\nin OBJ format")
    ->type_name("FILE")->group(group);
  app.add_flag("--quiet", options.is_quiet, "No progress and no summary, only errors and warnings")->group(group);
  app.add_flag("--progress", options.has_progress_lines,
               "Progress as lines \"PERCENT PHASE\" on the standard error,\nfor programs that run this one")->group(group);
}

void add_method_options(CLI::App& app, Options& options)
{
  const std::string group = "Method";
  constexpr double largest = 1e9, ideal = 4;
  app.add_option("--effort", options.effort,
                 "How hard to look for a short cut: fast does not shorten\nit without a bound, default tries a few starts, best\nmany more and "
                 "combinations of them")
    ->check(CLI::IsMember({"fast", "default", "best"}))->default_str(options.effort)->group(group);
  app.add_flag("--faithful", options.is_faithful, "The published method, for comparisons")->group(group);
  app.add_option("--connect", options.connect,
                 "How to connect the feature points: minimum spanning tree,\nshortest path heuristic, "
                 "auxiliary points added and exchanged\n(only added with --faithful), proven shortest, or the\nbest within a budget")
    ->check(CLI::IsMember({"mst", "sph", "greedy", "exact", "best"}))
    ->default_str("best; greedy if --faithful")->group(group);
  app.add_flag("--allow-overlap", options.may_overlap,
               "Parts of the layout may overlap (implied by --faithful):\nfaster, and a little less distortion")
    ->group(group);
  app.add_flag("--bijective", options.is_bijective, "No two parts of the layout overlap: the default, but for --faithful")
    ->excludes("--allow-overlap")->group(group);
  app.add_option_function<std::string>(
       "--max-distortion",
       [&options](const std::string& word)
       { options.maximum_average_distortion = parse_bound("--max-distortion", word, ideal, largest); },
       "Upper bound on the mean energy; 4 means no distortion,\n4.1 is barely visible")
    ->type_name("B")->default_str("none")->group(group);
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
  app.add_option("--must-cut", options.must_cut, "Edges to cut in any case; they may separate the mesh")
    ->type_name("SEL|uv")->group(group);
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
       "Cost of cutting an edge, instead of its length: low at\ncreases, low where hidden, painted or from a file (see\n"
       "below). Can be given several times: the factors multiply")
    ->option_text("WEIGHTS")->allow_extra_args(false)->group(group);
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
  app.add_option("--solver", options.solver, "Sparse linear solver")
    ->check(CLI::IsMember(available_solvers()))->default_str(options.solver)->group(group);
  add_number<double>(app, "--time-limit", options.time_limit, "Stop after S seconds", 0, 1e9)
    ->type_name("S")->default_str("none")->group(group);
}

// What the options mean together.
void complete(Options& options)
{
  if(options.uv_scale == "unit" && !(2 * options.margin < options.texture_size))
    refuse("--margin must be less than half of --texture-size");
  if(options.weld == "off" && options.weld_tolerance > 0)
    refuse("--weld-tolerance needs --weld on or auto");
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
  return {options.must_cut == seams_of_input || options.initial_cut == seams_of_input, options.weld != "off", true,
          is_ply(options.output)};
}

std::vector<std::string> constraint_files(const Options& options)
{
  std::vector<std::string> files = {options.never_cut, options.terminals};
  for(const std::string& selection : {options.must_cut, options.initial_cut})
    if(selection != seams_of_input)
      files.push_back(selection);
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

  CLI::App app(description, "unwrap");
  app.footer(footer);
  app.set_version_flag("--version", "unwrap (CGAL " CGAL_VERSION_STR ")");
  app.add_option("INPUT", options.input, "Mesh file; - is the standard input")->type_name("")->required();
  add_input_options(app, options);
  add_output_options(app, options);
  add_method_options(app, options);
  add_constraint_options(app, options);
  add_run_options(app, options);
  try
  {
    check_values(app, argc, argv);
    app.parse(argc, argv);
    check_no_value_is_empty(app);
    complete(options);
  }
  catch(const CLI::Success& success) // help or version
  {
    result.is_done = true;
    result.exit_code = app.exit(success);
  }
  catch(const CLI::ParseError& error)
  {
    result.is_done = true;
    result.exit_code = int(Exit_code::USAGE);
    result.message = error.what();
    options.json = find_json_file(argc, argv);
  }
  return result;
}
