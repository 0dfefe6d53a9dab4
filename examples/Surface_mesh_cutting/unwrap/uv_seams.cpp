#include "uv_seams.h"

#include "outcome.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

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

bool is_finite(const Uv& uv) { return !uv || (std::isfinite((*uv)[0]) && std::isfinite((*uv)[1])); }

void check_uvs(const Polygon_soup& soup)
{
  Witness witness = {Witness::Kind::FACES, {}};
  for(int f = 0; f < soup.number_of_polygons(); ++f)
  {
    const auto first = soup.corner_uvs.begin() + std::ptrdiff_t(soup.first_corner(f));
    if(!std::all_of(first, first + soup.number_of_corners(f), is_finite))
      witness.indices.push_back(f);
  }
  if(!witness.indices.empty())
    throw Failure(Exit_code::UNREADABLE, "texture coordinates that are not finite, first at face "
                                           + std::to_string(witness.indices.front()), witness);
}

} // namespace

std::vector<Edge> uv_seams(const std::string& option, const Polygon_soup& soup, const Surface& surface)
{
  const auto has_value = [](const Uv& uv) { return uv.has_value(); };
  if(std::none_of(soup.corner_uvs.begin(), soup.corner_uvs.end(), has_value))
    throw Failure(Exit_code::UNSUPPORTED, option + " uv: the input has no texture coordinates of the corners of faces "
                                                   "(vt of OBJ, texcoord or s and t of PLY, TEXCOORD_0 of glTF, STOFF)");
  check_uvs(soup);
  std::vector<Edge> seams;
  for(const Edge e : surface.mesh.edges())
    if(is_seam(soup, surface, e))
      seams.push_back(e);
  return seams;
}
