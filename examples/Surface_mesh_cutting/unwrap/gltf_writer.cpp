#include "gltf_writer.h"

#include "Mesh_parts.h"
#include "byte_order.h"
#include "corner_normals.h"
#include "outcome.h"
#include "texture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

template <typename Number>
void append(Number number, std::string& bytes)
{
  store(number, false, bytes);
}

// Parts of a file begin at multiples of four.
void pad(std::string& bytes, char with) { bytes.resize((bytes.size() + 3) / 4 * 4, with); }

// A vertex for each different corner of each part, as attributes share indices.
struct Glb_vertex
{
  int part, uv, point;
  Unit_normal normal;

  friend bool operator<(const Glb_vertex& v, const Glb_vertex& w)
  {
    return std::tie(v.part, v.uv, v.point, v.normal) < std::tie(w.part, w.uv, w.point, w.normal);
  }
  friend bool operator==(const Glb_vertex& v, const Glb_vertex& w) { return !(v < w) && !(w < v); }
};

class Glb_writer
{
public:
  Glb_writer(const Layout& layout, const std::string& png)
    : m_layout(layout), m_png(png), m_parts(find_parts(layout))
  {}

  std::string run()
  {
    collect_vertices();
    add_positions();
    add_attribute("TEXCOORD_0", 2, [&](const Glb_vertex& v)
    {
      const std::array<double, 2>& uv = m_layout.uv_points[std::size_t(v.uv)];
      return std::array<float, 2>{{float(uv[0]), float(1 - uv[1])}}; // images begin at the top
    });
    add_attribute("NORMAL", 3, [](const Glb_vertex& v) { return v.normal; });
    if(!m_layout.colors.empty())
      add_attribute("COLOR_0", 3, [&](const Glb_vertex& v)
      {
        const std::array<double, 3>& color = m_layout.colors[std::size_t(v.point)];
        return std::array<float, 3>{{float(color[0]), float(color[1]), float(color[2])}};
      });
    add_indices();
    collect_meshes();

    Json nodes = Json::array(), roots = Json::array();
    for(std::size_t i = 0; i < m_meshes.size(); ++i)
    {
      nodes.push_back({{"mesh", i}});
      if(m_meshes[i].contains("name"))
        nodes.back()["name"] = m_meshes[i]["name"];
      roots.push_back(i);
    }
    Json file = {{"asset", {{"version", "2.0"}, {"generator", "Surface_mesh_cutting unwrap"}}},
                 {"scene", 0},
                 {"scenes", {{{"nodes", roots}}}},
                 {"nodes", nodes},
                 {"meshes", m_meshes},
                 {"materials", m_materials}};
    if(!m_png.empty())
    {
      file["images"] = {{{"bufferView", add_view(m_png)}, {"mimeType", "image/png"}}};
      file["samplers"] = Json::array({Json::object()}); // repeats the image
      file["textures"] = {{{"source", 0}, {"sampler", 0}}};
    }
    file["accessors"] = m_accessors;
    file["bufferViews"] = m_views;
    file["buffers"] = {{{"byteLength", m_buffer.size()}}};
    return assemble(file.dump(-1, ' ', false, Json::error_handler_t::replace)); // names may be no UTF-8
  }

private:
  static constexpr int array_buffer = 34962, element_array_buffer = 34963; // what the format calls them
  static constexpr int unsigned_int = 5125, single = 5126;

  void collect_vertices()
  {
    const std::vector<Unit_normal> normals = corner_normals(m_layout);
    std::vector<int> owners; // per corner, the part of its polygon
    for(std::size_t polygon = 0; polygon < m_layout.polygon_ends.size(); ++polygon)
      owners.resize(m_layout.polygon_ends[polygon], m_parts.polygon_parts[polygon]);
    for(const Layout::Triangle& triangle : m_layout.triangle_corners)
      for(const int corner : triangle)
      {
        const std::size_t c = std::size_t(corner);
        m_vertices.push_back({owners[c], m_layout.corner_uvs[c], m_layout.corners[c], normals[c]});
      }
    m_corners = m_vertices;
    std::sort(m_vertices.begin(), m_vertices.end());
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());

    m_primitives.assign(m_parts.parts.size(), Json::object());
    m_first_vertices.assign(m_parts.parts.size() + 1, 0);
    for(const Glb_vertex& vertex : m_vertices)
      ++m_first_vertices[std::size_t(vertex.part) + 1];
    std::partial_sum(m_first_vertices.begin(), m_first_vertices.end(), m_first_vertices.begin());
  }

  int add_view(const std::string& bytes)
  {
    pad(m_buffer, '\0');
    m_views.push_back({{"buffer", 0}, {"byteOffset", m_buffer.size()}, {"byteLength", bytes.size()}});
    m_buffer += bytes;
    return int(m_views.size()) - 1;
  }

  int add_accessor(const Json& accessor)
  {
    m_accessors.push_back(accessor);
    return int(m_accessors.size()) - 1;
  }

  // Numbers of each vertex, for all parts that have any.
  template <typename Numbers>
  void add_attribute(const char* name, std::size_t number, Numbers numbers)
  {
    std::string bytes;
    for(const Glb_vertex& vertex : m_vertices)
      for(const float x : numbers(vertex))
        append(x, bytes);
    const int view = add_view(bytes);
    m_views[std::size_t(view)]["byteStride"] = number * sizeof(float);
    m_views[std::size_t(view)]["target"] = array_buffer;
    for(std::size_t part = 0; part < m_primitives.size(); ++part)
      if(const std::size_t first = m_first_vertices[part], count = m_first_vertices[part + 1] - first; count > 0)
        m_primitives[part]["attributes"][name]
          = add_accessor({{"bufferView", view}, {"byteOffset", first * number * sizeof(float)},
                          {"componentType", single}, {"count", count}, {"type", number == 2 ? "VEC2" : "VEC3"}});
  }

  // The format wants to know how far they reach.
  void add_positions()
  {
    const auto position = [&](const Glb_vertex& vertex)
    {
      const std::array<double, 3>& p = m_layout.points[std::size_t(vertex.point)];
      return std::array<float, 3>{{float(p[0]), float(p[1]), float(p[2])}};
    };
    add_attribute("POSITION", 3, position);
    for(std::size_t part = 0; part < m_primitives.size(); ++part)
    {
      if(m_primitives[part].empty())
        continue;
      std::array<float, 3> low = position(m_vertices[m_first_vertices[part]]), high = low;
      for(std::size_t v = m_first_vertices[part]; v < m_first_vertices[part + 1]; ++v)
        for(std::size_t i = 0; i < 3; ++i)
        {
          const float x = position(m_vertices[v])[i];
          if(!std::isfinite(x))
            throw Failure(Exit_code::UNSUPPORTED, "a coordinate is too large for the single precision of glTF");
          low[i] = (std::min)(low[i], x);
          high[i] = (std::max)(high[i], x);
        }
      Json& accessor = m_accessors[m_primitives[part]["attributes"]["POSITION"].get<std::size_t>()];
      accessor["min"] = low;
      accessor["max"] = high;
    }
  }

  void add_indices()
  {
    std::vector<std::string> bytes(m_parts.parts.size());
    for(const Glb_vertex& corner : m_corners)
    {
      const auto vertex = std::lower_bound(m_vertices.begin(), m_vertices.end(), corner) - m_vertices.begin();
      const std::size_t part = std::size_t(corner.part);
      append(std::uint32_t(std::size_t(vertex) - m_first_vertices[part]), bytes[part]);
    }
    std::string all;
    for(std::size_t part = 0; part < bytes.size(); ++part)
      if(!bytes[part].empty())
      {
        m_primitives[part]["indices"]
          = add_accessor({{"bufferView", m_views.size()}, {"byteOffset", all.size()}, {"componentType", unsigned_int},
                          {"count", bytes[part].size() / sizeof(std::uint32_t)}, {"type", "SCALAR"}});
        all += bytes[part];
      }
    m_views[std::size_t(add_view(all))]["target"] = element_array_buffer;
  }

  // Parts with the same name are one mesh. With an image, there is no other material.
  void collect_meshes()
  {
    std::map<std::string, int> materials;
    for(std::size_t part = 0; part < m_primitives.size(); ++part)
    {
      if(m_primitives[part].empty())
        continue;
      const Mesh_parts::Part& names = m_parts.parts[part];
      const std::string material = m_png.empty() ? names.material : material_name;
      const auto inserted = materials.emplace(material, int(m_materials.size()));
      if(inserted.second)
        add_material(material);
      m_primitives[part]["material"] = inserted.first->second;
      if(m_meshes.empty() || m_meshes.back().value("name", "") != names.name)
      {
        m_meshes.push_back({{"primitives", Json::array()}});
        if(!names.name.empty())
          m_meshes.back()["name"] = names.name;
      }
      m_meshes.back()["primitives"].push_back(m_primitives[part]);
    }
  }

  void add_material(const std::string& name)
  {
    Json material = {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"doubleSided", true}};
    if(!name.empty())
      material["name"] = name;
    if(!m_png.empty())
      material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    m_materials.push_back(material);
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
  const Mesh_parts m_parts;
  std::vector<Glb_vertex> m_vertices; // of one part after the other
  std::vector<Glb_vertex> m_corners;  // of the triangles
  std::vector<std::size_t> m_first_vertices;
  std::vector<Json> m_primitives; // per part, empty without triangles
  std::string m_buffer;
  Json m_views = Json::array(), m_accessors = Json::array(), m_materials = Json::array(), m_meshes = Json::array();
};

} // namespace

Data_kinds kinds_in_glb(const Layout& layout, bool has_own_material)
{
  Data_kinds kinds = {Data_kind::NORMALS, Data_kind::GROUPS};
  if(!layout.colors.empty())
    kinds.insert(Data_kind::COLORS);
  if(!has_own_material)
    kinds.insert(Data_kind::MATERIALS);
  return kinds;
}

std::string to_glb(const Layout& layout, const std::string& png)
{
  return Glb_writer(layout, png).run();
}
