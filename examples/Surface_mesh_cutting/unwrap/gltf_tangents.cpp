#include "gltf_tangents.h"

#include "Gltf_elements.h"
#include "Gltf_source.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace {

std::optional<gltf::Elements> elements_of(const gltf::Document& document, const gltf::Json& attributes, const char* name)
{
  const std::optional<std::size_t> accessor = gltf::find_number(attributes, name);
  return accessor ? std::make_optional<gltf::Elements>(document, *accessor) : std::nullopt;
}

} // namespace

std::vector<Tangent> gltf_tangents(const Layout& layout)
{
  const gltf::Document& document = layout.gltf_source->document;
  std::vector<Tangent_corner> corners;
  corners.reserve(layout.corners.size());
  for(const Gltf_source::Primitive& primitive : layout.gltf_source->primitives)
  {
    const gltf::Json& attributes
      = document.description()["meshes"][primitive.mesh]["primitives"][primitive.index]["attributes"];
    const std::optional<gltf::Elements> points = elements_of(document, attributes, "POSITION"),
                                        normals = elements_of(document, attributes, "NORMAL");
    for(std::size_t c = 0; c < primitive.vertices.size(); ++c)
    {
      const std::size_t v = std::size_t(primitive.vertices[c]);
      const int uv_vertex = layout.corner_uvs[primitive.first_corner + c];
      const std::array<double, 2>& uv = layout.uv_points[std::size_t(uv_vertex)];
      corners.push_back({points->vector<3>(v), normals ? normals->vector<3>(v) : Eigen::Vector3d(0, 0, 0),
                         {uv[0], uv[1]}, uv_vertex});
    }
  }
  return corner_tangents(corners);
}
