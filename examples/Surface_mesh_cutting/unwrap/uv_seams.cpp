#include "uv_seams.h"

#include "outcome.h"

#include <algorithm>

namespace {

using Uv = std::optional<Polygon_soup::Texture_point>;

bool is_seam(const Polygon_soup& soup, const Surface& surface, Edge e)
{
  const Mesh& mesh = surface.mesh;
  if(mesh.is_border(e))
    return false;
  const Halfedge h = mesh.halfedge(e, 0), o = mesh.halfedge(e, 1);
  const auto uv = [&](Halfedge to_corner) { return soup.corner_uvs[std::size_t(surface.corners[to_corner])]; };
  return uv(h) != uv(mesh.prev(o)) || uv(mesh.prev(h)) != uv(o);
}

} // namespace

std::vector<Edge> uv_seams(const std::string& option, const Polygon_soup& soup, const Surface& surface)
{
  const auto has_value = [](const Uv& uv) { return uv.has_value(); };
  if(std::none_of(soup.corner_uvs.begin(), soup.corner_uvs.end(), has_value))
    throw Failure(Exit_code::UNSUPPORTED, option + " uv: the input has no texture coordinates of the corners of faces "
                                                   "(OBJ with vt; PLY with texcoord)");
  std::vector<Edge> seams;
  for(const Edge e : surface.mesh.edges())
    if(is_seam(soup, surface, e))
      seams.push_back(e);
  return seams;
}
