#include "help_text.h"

#include <sstream>
#include <utility>
#include <vector>

const char* const program_description =
  "Unwraps a mesh: finds a short cut along which the surface opens and flattens with little\n"
  "distortion, and writes the mesh with texture coordinates.\n";

namespace {

// The options that --help shows, under headings.
const std::vector<std::pair<const char*, std::vector<const char*> > > common_options = {
  {"Output", {"--output", "--html", "--svg", "--texture", "--json"}},
  {"Texture", {"--margin", "--texture-size", "--rotate"}},
  {"Where to cut", {"--must-cut", "--never-cut", "--initial-cut", "--edge-weights"}},
  {"How", {"--max-distortion", "--effort", "--time-limit", "--weld", "--quiet"}},
  {"More", {"--help-all", "--version"}}};

const char* const common_footer = R"(
Input: OFF, OBJ, PLY, STL, glTF. Any polygons will do; nothing is repaired, and vertices and faces
keep their number and order. Output: all charts lie in the unit square, at one scale, without
overlaps. Exit status: 0 done, 2 wrong usage, 3 input unreadable, 4 not supported, 5 no valid
result, 6 stopped, 7 a bound was not reached.

Examples:
  unwrap cow.off                              writes cow.uv.obj
  unwrap cow.off --html cow.html              and a page that shows it in any browser
  unwrap cow.off -o flat.obj --texture check.png
      open flat.obj in any viewer: where the squares are square, nothing is distorted
  unwrap cow.off --max-distortion 4.1         the shortest cut found at 12 % of stretch
  unwrap parts.stl --margin 4 --texture-size 2048
      charts at least 4 texels apart on a texture of 2048 by 2048
  unwrap cow.off --never-cut face.selection.txt --edge-weights visibility
      no cut across the face, and elsewhere where it is hard to see
)";

const char* const full_footer = R"(
Input: OFF, OBJ, PLY, STL, glTF, and whatever else CGAL reads; text may be UTF-8 or UTF-16, and - is the
standard input. Nothing is repaired, everything is interpreted: vertices and faces keep their number
and order. Equal points count as one in STL and glTF, where (nearly) no faces share a vertex, and
where small pieces meet at their borders (see --weld). Faces may have any number of corners; they
are never cut across. Edges
with more than two faces keep pairs of them connected and are open to the others; vertices of
several fans are as many vertices; where neighbors disagree about which side is up, as few
faces as possible are read backward; faces without area, and faces given again, get the
texture coordinates of the place where they lie. The report lists all this in "interpreted";
--strict refuses it.

Output: texture coordinates lie in the unit square, charts apart by the margin and all at the same
scale (uv_scale in the report), and no two triangles overlap (but with --allow-overlap, --faithful
and --pack-only). Corners share one unless a cut edge lies
between them. From OBJ to OBJ, PLY to PLY and glTF to glTF, all else stays; a warning names what
the format of the output cannot hold. A name may not end like that of another format. Files appear
when the run is complete.

Constraints: SEL is a CGAL .selection.txt file: three lines with vertices, faces, and edges as pairs
of vertices, all counted from 0. For --must-cut, angle:DEGREES stands for the edges where the
surface bends by at least so much, materials and groups for the borders of those of OBJ and
glTF. For --must-cut and --initial-cut, uv stands for the seams of the
texture coordinates in INPUT, the edges at which those of the two faces differ (vt of OBJ,
texcoord or s and t of PLY, TEXCOORD_0 of glTF, STOFF).

Weights: what a cut costs, by default its length, times the factors of all --edge-weights given:
  crease          0.2 at sharp edges, up to 1 where the surface is flat
  concave         the same, but 0.6 at sharp convex edges
  hard            0.2 where the surface bends by 60 degrees or more, else 1
  straight        0.2 along and across the direction in which the surface bends most, up to 1
                  between them and where it bends alike in all directions
  visibility      0.25 where the surface hides the edge from all sides, up to 1
  occlusion       the same, hidden only by what is within a tenth of the bounding box diagonal
  sky, sky:AXIS   the same, seen from above only; AXIS is x, y (default), z, -x, -y or -z
  colors          0.2 where the red channel of the vertex colors in INPUT is 0, up to 1 where it is
                  full
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
     is not triangles, not a manifold or inconsistently oriented), an option needs what the input
     lacks (such as texture coordinates), no cut satisfies the constraints, or charts find no room
     (margins, --texels-per-unit); the message says where, counting from 0
  5  no valid result was found
  6  stopped by the time limit, which counts from the start of the program, or by Ctrl-C (a second
     Ctrl-C ends at once); the best result so far is written if there is one, and the message says so
  7  the result is valid, but misses a requested bound, or the proof that --connect exact asks for
With 2 to 5, and with 6 without a result, only the JSON report is written. No output replaces an input or another output; if
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
  unwrap level.obj --texels-per-unit 256 --udim --stack
      as many UDIM tiles as that takes, equal parts on one place
  unwrap house.glb -o lit.glb --lightmap 512
      a second set of texture coordinates for a light map
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

} // namespace

std::string Help_formatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const
{
  if(mode == CLI::AppFormatMode::All)
    return Formatter::make_help(app, name, mode) + full_footer;
  std::ostringstream text;
  text << make_description(app) << make_usage(app, std::move(name));
  for(const auto& [heading, names] : common_options)
  {
    std::vector<const CLI::Option*> options;
    for(const char* const option : names)
      options.push_back(app->get_option(option));
    text << make_group(heading, false, options);
  }
  text << common_footer;
  return text.str();
}

// CLI11 puts the options first.
std::string Help_formatter::make_usage(const CLI::App*, std::string name) const
{
  return "Usage: " + name + " INPUT [OPTIONS]\n";
}
