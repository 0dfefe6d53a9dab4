#include "uv_seams.h"

#include "outcome.h"

#include <algorithm>

namespace {

using Uv = std::optional<Polygon_soup::Texture_point>;

Uv uv_of_corner(const Polygon_soup& soup, Face f, Vertex v)
{
  int k = 0;
  while(soup.corner(int(f), k) != int(v))
    ++k;
  return soup.corner_uvs[soup.first_corner(int(f)) + std::size_t(k)];
}

bool is_seam(const Polygon_soup& soup, const Mesh& mesh, Edge e)
{
  if(mesh.is_border(e))
    return false;
  const Face first = mesh.face(mesh.halfedge(e, 0)), second = mesh.face(mesh.halfedge(e, 1));
  const auto differs = [&](Vertex v) { return uv_of_corner(soup, first, v) != uv_of_corner(soup, second, v); };
  return differs(mesh.vertex(e, 0)) || differs(mesh.vertex(e, 1));
}

} // namespace

std::vector<Edge> uv_seams(const std::string& option, const Polygon_soup& soup, const Mesh& mesh)
{
  const auto has_value = [](const Uv& uv) { return uv.has_value(); };
  if(std::none_of(soup.corner_uvs.begin(), soup.corner_uvs.end(), has_value))
    throw Failure(Exit_code::UNSUPPORTED, option + " uv: the input has no texture coordinates of the corners of faces "
                                                   "(OBJ with vt; PLY with texcoord)");
  std::vector<Edge> seams;
  for(const Edge e : mesh.edges())
    if(is_seam(soup, mesh, e))
      seams.push_back(e);
  return seams;
}
