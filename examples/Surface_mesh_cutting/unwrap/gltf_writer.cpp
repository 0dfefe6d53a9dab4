#include "gltf_writer.h"

#include "byte_order.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

// Numbers as bytes, the lowest first.
template <typename Number>
void append(Number number, std::string& bytes)
{
  char buffer[sizeof(Number)];
  std::memcpy(buffer, &number, sizeof(Number));
  if(is_big_endian_machine())
    std::reverse(buffer, buffer + sizeof(Number));
  bytes.append(buffer, sizeof(Number));
}

// Parts of a file begin at multiples of four.
void pad(std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

class Glb_writer
{
public:
  Glb_writer(const Layout& layout, const std::string& png) : m_layout(layout), m_png(png) {}

  std::string run()
  {
    collect_vertices();
    const int positions = add_positions(), uvs = add_uvs(), indices = add_indices();
    const Json primitive = {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}},
                            {"indices", indices}, {"material", 0}};
    Json material = {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"doubleSided", true}};
    Json file = {{"asset", {{"version", "2.0"}, {"generator", "Surface_mesh_cutting unwrap"}}},
                 {"scene", 0},
                 {"scenes", {{{"nodes", {0}}}}},
                 {"nodes", {{{"mesh", 0}}}},
                 {"meshes", {{{"primitives", {primitive}}}}}};
    if(!m_png.empty())
    {
      file["images"] = {{{"bufferView", add_view(m_png, 0)}, {"mimeType", "image/png"}}};
      file["samplers"] = Json::array({Json::object()}); // repeats the image
      file["textures"] = {{{"source", 0}, {"sampler", 0}}};
      material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    }
    file["materials"] = {material};
    file["accessors"] = m_accessors;
    file["bufferViews"] = m_views;
    file["buffers"] = {{{"byteLength", m_buffer.size()}}};
    return assemble(file.dump());
  }

private:
  static constexpr int array_buffer = 34962, element_array_buffer = 34963; // what the format calls them
  static constexpr int unsigned_int = 5125, single = 5126;

  // A vertex for each pair of point and UV vertex of the corners.
  void collect_vertices()
  {
    for(std::size_t t = 0; t < m_layout.triangles.size(); ++t)
      for(std::size_t k = 0; k < 3; ++k)
        m_vertices.emplace_back(m_layout.uv_triangles[t][k], m_layout.triangles[t][k]);
    m_corners = m_vertices;
    std::sort(m_vertices.begin(), m_vertices.end());
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
  }

  int add_view(const std::string& bytes, int target)
  {
    pad(m_buffer, '\0');
    m_views.push_back({{"buffer", 0}, {"byteOffset", m_buffer.size()}, {"byteLength", bytes.size()}});
    if(target != 0)
      m_views.back()["target"] = target;
    m_buffer += bytes;
    return int(m_views.size()) - 1;
  }

  int add_accessor(const Json& accessor)
  {
    m_accessors.push_back(accessor);
    return int(m_accessors.size()) - 1;
  }

  int add_positions()
  {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::array<float, 3> low = {{infinity, infinity, infinity}}, high = {{-infinity, -infinity, -infinity}};
    std::string bytes;
    for(const auto& vertex : m_vertices)
      for(std::size_t i = 0; i < 3; ++i)
      {
        const float x = float(m_layout.points[std::size_t(vertex.second)][i]);
        low[i] = (std::min)(low[i], x);
        high[i] = (std::max)(high[i], x);
        append(x, bytes);
      }
    return add_accessor({{"bufferView", add_view(bytes, array_buffer)}, {"componentType", single},
                         {"count", m_vertices.size()}, {"type", "VEC3"}, {"min", low}, {"max", high}});
  }

  int add_uvs()
  {
    std::string bytes;
    for(const auto& vertex : m_vertices)
    {
      const std::array<double, 2>& uv = m_layout.uv_points[std::size_t(vertex.first)];
      append(float(uv[0]), bytes);
      append(float(1 - uv[1]), bytes); // images begin at the top
    }
    return add_accessor({{"bufferView", add_view(bytes, array_buffer)}, {"componentType", single},
                         {"count", m_vertices.size()}, {"type", "VEC2"}});
  }

  int add_indices()
  {
    std::string bytes;
    for(const auto& corner : m_corners)
      append(std::uint32_t(std::lower_bound(m_vertices.begin(), m_vertices.end(), corner) - m_vertices.begin()), bytes);
    return add_accessor({{"bufferView", add_view(bytes, element_array_buffer)}, {"componentType", unsigned_int},
                         {"count", m_corners.size()}, {"type", "SCALAR"}});
  }

  // Header, text, buffer.
  std::string assemble(std::string text)
  {
    pad(text, ' ');
    pad(m_buffer, '\0');
    constexpr std::size_t header = 12, chunk_header = 8;
    std::string file = "glTF";
    append(std::uint32_t(2), file);
    append(std::uint32_t(header + 2 * chunk_header + text.size() + m_buffer.size()), file);
    append(std::uint32_t(text.size()), file);
    file += "JSON" + text;
    append(std::uint32_t(m_buffer.size()), file);
    file.append("BIN\0", 4);
    return file + m_buffer;
  }

  const Layout& m_layout;
  const std::string& m_png;
  std::vector<std::pair<int, int> > m_vertices, m_corners; // UV vertex and point
  std::string m_buffer;
  Json m_views = Json::array(), m_accessors = Json::array();
};

} // namespace

std::string to_glb(const Layout& layout, const std::string& png)
{
  return Glb_writer(layout, png).run();
}
