#include "gltf_writer.h"

#include "Mesh_parts.h"
#include "byte_order.h"
#include "corner_normals.h"
#include "edit_gltf.h"
#include "file_extension.h"
#include "outcome.h"
#include "tangents.h"
#include "texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numeric>
#include <tuple>
#include <vector>

namespace {

using gltf::Json;

template <typename Number>
void append(Number number, std::string& bytes)
{
  store(number, false, bytes);
}

Json plain_material() { return {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}, {"doubleSided", true}}; }

// A vertex for each different corner of each part, as attributes share indices.
struct Gltf_vertex
{
  int part, uv, point;
  Unit_normal normal;
  Tangent tangent;                // all 0 unless they are computed
  std::array<float, 2> former_uv; // of the first set, where another one is written

  friend bool operator<(const Gltf_vertex& v, const Gltf_vertex& w)
  {
    return std::tie(v.part, v.uv, v.point, v.normal, v.tangent, v.former_uv)
           < std::tie(w.part, w.uv, w.point, w.normal, w.tangent, w.former_uv);
  }
  friend bool operator==(const Gltf_vertex& v, const Gltf_vertex& w) { return !(v < w) && !(w < v); }
};

class Gltf_builder
{
public:
  Gltf_builder(const Layout& layout, const std::string& png, bool has_tangents)
    : m_layout(layout), m_png(png), m_has_tangents(has_tangents),
      m_parts(find_parts(layout.obj_statements, int(layout.polygon_ends.size())))
  {}

  gltf::Content run()
  {
    collect_vertices();
    add_positions();
    for(int set = 0; set <= m_layout.uv_set; ++set)
      add_attribute(gltf::name_of_uvs(set).c_str(), 2, [&](const Gltf_vertex& v)
      { return set == 0 && m_layout.uv_set > 0 ? v.former_uv : gltf_uv(m_layout.written_uv(std::size_t(v.uv))); });
    add_attribute("NORMAL", 3, [](const Gltf_vertex& v) { return v.normal; });
    if(m_has_tangents)
      add_attribute("TANGENT", 4, [](const Gltf_vertex& v) { return v.tangent; });
    if(!m_layout.colors.empty())
      add_attribute("COLOR_0", 3, [&](const Gltf_vertex& v)
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
    return {std::move(file), std::move(m_buffer)};
  }

private:
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
        m_vertices.push_back({owners[c], m_layout.corner_uvs[c], m_layout.corners[c], normals[c], Tangent{}, former_uv(c)});
      }
    if(m_has_tangents)
      add_tangents();
    m_corners = m_vertices;
    std::sort(m_vertices.begin(), m_vertices.end());
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());

    m_primitives.assign(m_parts.parts.size(), Json::object());
    m_first_vertices.assign(m_parts.parts.size() + 1, 0);
    for(const Gltf_vertex& vertex : m_vertices)
      ++m_first_vertices[std::size_t(vertex.part) + 1];
    std::partial_sum(m_first_vertices.begin(), m_first_vertices.end(), m_first_vertices.begin());
  }

  // That of the input, or the new one.
  std::array<float, 2> former_uv(std::size_t corner) const
  {
    if(m_layout.uv_set == 0)
      return {{0, 0}};
    const std::size_t uv = std::size_t(m_layout.corner_uvs[corner]);
    return gltf_uv(m_layout.former_uvs.empty() ? m_layout.written_uv(uv)
                                               : m_layout.former_uvs[corner].value_or(std::array<double, 2>{{0, 0}}));
  }

  // To the corners of all triangles.
  void add_tangents()
  {
    std::vector<Tangent_corner> corners;
    for(const Gltf_vertex& vertex : m_vertices)
    {
      const std::array<double, 3>& p = m_layout.points[std::size_t(vertex.point)];
      const std::array<double, 2>& uv = m_layout.uv_points[std::size_t(vertex.uv)];
      corners.push_back({{p[0], p[1], p[2]}, {vertex.normal[0], vertex.normal[1], vertex.normal[2]}, {uv[0], uv[1]}, vertex.uv});
    }
    const std::vector<Tangent> tangents = corner_tangents(corners);
    for(std::size_t c = 0; c < tangents.size(); ++c)
      m_vertices[c].tangent = tangents[c];
  }

  int add_view(const std::string& bytes)
  {
    gltf::pad(m_buffer, '\0');
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
    for(const Gltf_vertex& vertex : m_vertices)
      for(const float x : numbers(vertex))
        append(x, bytes);
    const int view = add_view(bytes);
    m_views[std::size_t(view)]["byteStride"] = number * sizeof(float);
    m_views[std::size_t(view)]["target"] = gltf::array_buffer;
    for(std::size_t part = 0; part < m_primitives.size(); ++part)
      if(const std::size_t first = m_first_vertices[part], count = m_first_vertices[part + 1] - first; count > 0)
        m_primitives[part]["attributes"][name]
          = add_accessor({{"bufferView", view}, {"byteOffset", first * number * sizeof(float)},
                          {"componentType", gltf::single}, {"count", count}, {"type", "VEC" + std::to_string(number)}});
  }

  // The format wants to know how far they reach.
  void add_positions()
  {
    const auto position = [&](const Gltf_vertex& vertex)
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
    for(const Gltf_vertex& corner : m_corners)
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
          = add_accessor({{"bufferView", m_views.size()}, {"byteOffset", all.size()}, {"componentType", gltf::unsigned_int},
                          {"count", bytes[part].size() / sizeof(std::uint32_t)}, {"type", "SCALAR"}});
        all += bytes[part];
      }
    m_views[std::size_t(add_view(all))]["target"] = gltf::element_array_buffer;
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
    Json material = m_png.empty() ? plain_material() : textured_material(0, m_layout.uv_set);
    if(!name.empty())
      material["name"] = name;
    m_materials.push_back(material);
  }

  const Layout& m_layout;
  const std::string& m_png;
  const bool m_has_tangents;
  const Mesh_parts m_parts;
  std::vector<Gltf_vertex> m_vertices; // of one part after the other
  std::vector<Gltf_vertex> m_corners;  // of the triangles
  std::vector<std::size_t> m_first_vertices;
  std::vector<Json> m_primitives; // per part, empty without triangles
  std::string m_buffer;
  Json m_views = Json::array(), m_accessors = Json::array(), m_materials = Json::array(), m_meshes = Json::array();
};

} // namespace

Data_kinds kinds_in_gltf(const Layout& layout, bool has_own_material, bool has_tangents)
{
  Data_kinds kept = layout.kinds;
  if(has_tangents)
    kept.erase(Data_kind::TANGENTS_OF_MORPH_TARGETS); // they move the former ones
  kept.erase(Data_kind::UNKNOWN_CHUNKS); // they may depend on what was changed
  if(layout.gltf_source)
    return kept;
  Data_kinds kinds = {Data_kind::NORMALS, Data_kind::GROUPS};
  if(!layout.colors.empty())
    kinds.insert(Data_kind::COLORS);
  if(!has_own_material)
    kinds.insert(Data_kind::MATERIALS);
  return kinds;
}

std::array<float, 2> gltf_uv(const std::array<double, 2>& uv) { return {{float(uv[0]), float(1 - uv[1])}}; }

Json textured_material(std::size_t texture, int uv_set)
{
  Json material = plain_material();
  material["name"] = material_name;
  material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture}};
  if(uv_set > 0)
    material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] = uv_set;
  return material;
}

std::string to_gltf(const Layout& layout, const std::string& png, bool has_tangents, const std::string& path)
{
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  gltf::Content content = layout.gltf_source ? edited_gltf(layout, png, has_tangents, folder)
                                             : Gltf_builder(layout, png, has_tangents).run();
  return is_glb(path) ? gltf::to_binary_file(std::move(content)) : gltf::to_text_file(std::move(content));
}
