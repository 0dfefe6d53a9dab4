// The bytes of a mesh file through the whole program. The first byte chooses the format and how meshes are read that
// are none of triangles, the second one the other options.

#include "check_formats.h"
#include "check_layout.h"
#include "mesh_file.h"
#include "read_gltf.h"
#include "svg_writer.h"
#include "unwrap_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

constexpr int largest = 400; // faces: larger ones only take longer

constexpr unsigned number_of_formats = 5;

Options options_of(unsigned reading, unsigned bits)
{
  Options options;
  options.output = "out.ply"; // keeps most of what the input says
  options.is_strict = reading % 8 == 7;
  options.weld = reading % 3 == 0 ? "auto" : reading % 3 == 1 ? "on" : "off";
  options.is_quiet = true;
  options.solver = "supernodal";
  options.effort = (bits & 1) != 0 ? "fast" : "default";
  options.is_faithful = (bits & 6) == 6;
  options.is_bijective = (bits & 8) != 0;
  if((bits & 16) != 0)
    options.maximum_average_distortion = 4.05;
  if((bits & 32) != 0)
    options.must_cut = {seams_of_input};
  if((bits & 64) != 0)
    options.edge_weights = {*parse_weight_choice("colors")};
  return options;
}

Polygon_soup read(std::string_view bytes, unsigned format, Attributes attributes)
{
  const Polygon_soup soup = format == 0 ? read_off(bytes, attributes) : format == 1 ? read_obj(bytes, attributes)
                          : format == 2 ? read_ply(bytes, attributes) : format == 3 ? read_stl(bytes, attributes)
                          : read_glb(bytes, attributes);
  check_indices(soup);
  return soup;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size < 2)
    return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 2, size - 2);
  try
  {
    const Options options = options_of(data[0] / number_of_formats, data[1]);
    const Polygon_soup soup = read(bytes, data[0] % number_of_formats, wanted_attributes(options));
    if(soup.number_of_polygons() > largest)
      return 0;
    Outcome outcome;
    const Layout layout = unwrap_soup(soup, options, outcome);
    if(!outcome.has_result)
      return 0;
    std::string fault = find_fault(layout, soup, is_injective(options));
    if(fault.empty())
      fault = find_format_fault(layout);
    if(!fault.empty())
    {
      std::fprintf(stderr, "%s\n", fault.c_str());
      std::abort();
    }
    to_svg(layout, outcome, options.svg_style);
  }
  catch(const Failure&)
  {
    // refused with a reason
  }
  return 0;
}
