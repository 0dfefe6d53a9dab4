// The bytes of a mesh file through readers and writers alone, which is much faster than the whole program. The first
// byte chooses the format.

#include "check_formats.h"
#include "make_layout.h"
#include "mesh_file.h"
#include "outcome.h"
#include "read_gltf.h"
#include "soup_checks.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

Polygon_soup read(std::string_view bytes, unsigned format)
{
  const Attributes attributes = {true, true, true, true, true}; // glTF is edited
  switch(format)
  {
    case 0: return read_off(bytes, attributes);
    case 1: return read_obj(bytes, attributes);
    case 2: return read_ply(bytes, attributes);
    case 3: return read_stl(bytes, attributes);
    default: return read_glb(bytes, attributes);
  }
}

// Each corner has a UV of its own and is a vertex of its own; polygons are fans of triangles.
Layout layout_of_corners(const Polygon_soup& soup)
{
  Layout layout = layout_without_uvs(soup);
  for(int c = 0; c < int(soup.corners.size()); ++c)
  {
    layout.corner_uvs.push_back(c);
    layout.corner_vertices.push_back(c);
    layout.uv_points.push_back({{c * 0.125, c % 3 / 7.}});
  }
  for(int polygon = 0; polygon < soup.number_of_polygons(); ++polygon)
    for(int k = 1; k + 1 < soup.number_of_corners(polygon); ++k)
    {
      const int first = int(soup.first_corner(polygon));
      layout.triangle_corners.push_back({{first, first + k, first + k + 1}});
      layout.triangles.push_back(
        {{soup.corner(polygon, 0), soup.corner(polygon, k), soup.corner(polygon, k + 1)}});
    }
  layout.uv_triangles = layout.triangle_corners;
  return layout;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr unsigned number_of_formats = 5;
  if(size == 0)
    return 0;
  try
  {
    const Polygon_soup soup
      = read({reinterpret_cast<const char*>(data) + 1, size - 1}, data[0] % number_of_formats);
    check_indices(soup);
    check_points(soup);
    const std::string fault = find_format_fault(layout_of_corners(soup));
    if(!fault.empty())
    {
      std::fprintf(stderr, "%s\n", fault.c_str());
      std::abort();
    }
  }
  catch(const Failure&)
  {
    // refused with a reason
  }
  return 0;
}
