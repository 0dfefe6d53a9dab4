// The command line.

#ifndef UNWRAP_OPTIONS_H
#define UNWRAP_OPTIONS_H

#include "mesh_file.h"
#include "weight_choice.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

struct Options
{
  std::string input;
  // Files to write; an empty name stands for none, for `json` "-" is the standard output.
  std::string output, json, svg, texture, obj_cut, html;
  std::string svg_style = "distortion"; // distortion, partners
  std::string up;                       // x, y, z; empty: z for formats of printing, else y
  bool has_tangents = false;
  std::string uv_scale = "unit";        // unit, surface
  std::string rotate;                   // any, quarter, none, upright; empty: quarter where that is cheap, else any
  double margin = 2;                    // texels
  int texture_size = 1024;
  std::optional<double> texels_per_unit; // none: as many as fit
  std::optional<int> most_pages;
  bool is_udim = false;
  bool has_page_files = false; // a mesh and a picture for each page
  bool is_pack_only = false;
  bool is_stacked = false;
  double stack_tolerance = 1e-4; // of the diagonal of a part
  std::optional<double> least_fill;
  int uv_set = 0;
  std::optional<int> lightmap; // texels along its side: a preset
  bool is_quiet = false;
  bool has_progress_lines = false; // instead of a bar

  bool is_strict = false;      // refuses what is otherwise interpreted
  std::string weld = "auto"; // auto, on, off
  double weld_tolerance = 0;

  std::string effort = "default"; // fast, default, best
  bool is_faithful = false;
  std::string symmetry = "off"; // auto, off, x, y, z
  std::optional<double> seam_smoothness;
  std::optional<std::string> connect; // mst, sph, greedy, exact, best
  bool is_bijective = false, may_overlap = false;
  std::optional<double> maximum_average_distortion, maximum_face_distortion, maximum_chart_distortion;
  double face_quantile = 1; // of the area
  std::optional<double> eps_iso, eps_len, alpha, beta;

  std::vector<std::string> must_cut; // files, or words for edges that the input tells, see `mark_known_edges()`
  // Files; an empty name stands for none. The first one may also be `seams_of_input`.
  std::string initial_cut, never_cut, terminals;
  std::vector<Weight_choice> edge_weights; // their factors multiply

  std::uint32_t seed = 0;
  int threads = 1;
  std::string solver;
  std::optional<double> time_limit; // in seconds
};

// Stands for the seams of the texture coordinates of the input. A file of this name is ./uv.
inline const std::string seams_of_input = "uv";

// Whether no two parts of the layout may overlap: unless they may, or the published method, whose maps may, is asked for.
bool is_injective(const Options& options);

// What the options need besides points and polygons.
Attributes wanted_attributes(const Options& options);

// The files of constraints and weights.
std::vector<std::string> constraint_files(const Options& options);

// What the command line asks for.
struct Command_line
{
  Options options;
  // Whether there is nothing to do but to end with `exit_code` and, if that is not 0, `message`.
  bool is_done = false;
  int exit_code = 0;
  std::string message;
};

// Answers `--help` and `--version` itself.
Command_line parse_command_line(int argc, char** argv);

#endif // UNWRAP_OPTIONS_H
