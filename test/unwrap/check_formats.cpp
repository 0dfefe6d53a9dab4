#include "check_formats.h"

#include "gltf_writer.h"
#include "mesh_file.h"
#include "obj_writer.h"
#include "outcome.h"
#include "ply_writer.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace {

bool is_same(const Polygon_soup& soup, const Layout& layout)
{
  if(soup.points != layout.points || soup.corners != layout.corners || soup.polygon_ends != layout.polygon_ends
     || soup.corner_uvs.size() != layout.corner_uvs.size())
    return false;
  for(std::size_t c = 0; c < layout.corner_uvs.size(); ++c)
    if(soup.corner_uvs[c] != layout.uv_points[std::size_t(layout.corner_uvs[c])])
      return false;
  return true;
}

bool has_single_precision(const Layout& layout)
{
  for(const std::array<double, 3>& point : layout.points)
    for(const double x : point)
      if(!(std::abs(x) <= double((std::numeric_limits<float>::max)())))
        return false;
  return true;
}

bool can_write_gltf(const Layout& layout)
{
  try
  {
    return !to_gltf(layout, "", false, "out.glb").empty();
  }
  catch(const Failure&)
  {
    return !has_single_precision(layout);
  }
}

} // namespace

std::string find_format_fault(const Layout& layout)
{
  Attributes attributes;
  attributes.has_uvs = attributes.has_looks = true;
  if(!is_same(read_obj(to_obj(layout, ""), attributes), layout))
    return "OBJ is not what was written";
  if(!is_same(read_ply(to_ply(layout, ""), attributes), layout))
    return "PLY is not what was written";
  return can_write_gltf(layout) ? "" : "glTF cannot be written";
}
