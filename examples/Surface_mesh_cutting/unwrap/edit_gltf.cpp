#include "edit_gltf.h"

#include "Gltf_data.h"
#include "Gltf_elements.h"
#include "Gltf_source.h"
#include "Split_vertices.h"
#include "byte_order.h"
#include "gltf_tangents.h"
#include "gltf_uri.h"
#include "gltf_writer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace {

using gltf::Elements;
using gltf::Json;
using Primitive = Gltf_source::Primitive;

constexpr const char *normal_attribute = "NORMAL", *tangent_attribute = "TANGENT";
constexpr std::size_t triangles_mode = 4;

class Gltf_editor
{
public:
  Gltf_editor(const Layout& layout, const std::string& png, bool has_new_tangents)
    : m_layout(layout), m_source(*layout.gltf_source), m_data(m_source.document), m_uv_attribute(gltf::name_of_uvs(layout.uv_set))
  {
    if(!png.empty())
      add_material(png);
    if(has_new_tangents)
      m_tangents = gltf_tangents(layout);
  }

  gltf::Content run(const std::filesystem::path& folder)
  {
    // Primitives with the same attributes share vertices.
    std::map<std::string, std::vector<const Primitive*> > groups;
    for(const Primitive& primitive : m_source.primitives)
    {
      const Json& json = json_of(primitive);
      groups[json["attributes"].dump() + gltf::list(json, "targets").dump()].push_back(&primitive);
    }
    for(const auto& [attributes, members] : groups)
      edit(members);
    if(m_data.description().contains("images"))
      for(Json& image : m_data.description()["images"])
        if(const std::string uri = gltf::text_of(image, "uri"); !uri.empty())
          image["uri"] = gltf::moved_uri(uri, m_source.document.folder(), folder);
    return m_data.content();
  }

private:
  Json& json_of(const Primitive& primitive)
  {
    return m_data.description()["meshes"][primitive.mesh]["primitives"][primitive.index];
  }

  void edit(const std::vector<const Primitive*>& members)
  {
    Json attributes = json_of(*members.front())["attributes"], targets = gltf::list(json_of(*members.front()), "targets");
    const std::optional<Elements> normals = normals_for_tangents(attributes);
    Split_vertices vertices(members.front()->number_of_vertices);
    std::vector<std::vector<int> > corners;
    for(const Primitive* primitive : members)
    {
      corners.emplace_back();
      for(std::size_t c = primitive->first_corner; c < primitive->first_corner + primitive->vertices.size(); ++c)
        corners.back().push_back(vertices.find(primitive->vertices[c - primitive->first_corner], m_layout.corner_uvs[c],
                                               normals ? m_tangents[c] : Tangent{}));
    }
    if(normals)
      for(Json& target : targets)
        target.erase(tangent_attribute); // how the former one moves
    repeat_attributes(attributes, targets, vertices, members.size(), normals.has_value());
    put_uvs(vertices, members.size(), attributes);
    if(normals)
      put_tangents(vertices, *normals, members.size(), attributes);
    for(std::size_t i = 0; i < members.size(); ++i)
    {
      Json& json = json_of(*members[i]);
      put_indices(*members[i], corners[i], vertices.uvs.size(), json);
      json["attributes"] = attributes;
      if(!targets.empty())
        json["targets"] = targets;
      if(m_material)
        json["material"] = *m_material;
    }
  }

  // None unless tangents are computed.
  std::optional<Elements> normals_for_tangents(const Json& attributes) const
  {
    const std::optional<std::size_t> accessor = gltf::find_number(attributes, normal_attribute);
    return accessor && !m_tangents.empty() ? std::make_optional<Elements>(m_source.document, *accessor) : std::nullopt;
  }

  // The number of an accessor to replace: itself unless others refer to it, too.
  std::optional<std::size_t> replaceable(std::size_t accessor, std::size_t uses) const
  {
    return m_data.number_of_uses(accessor) == uses ? std::make_optional(accessor) : std::nullopt;
  }

  // All but those that are replaced. `number_of_members`: how many primitives have these attributes.
  void repeat_attributes(Json& attributes, Json& targets, const Split_vertices& vertices, std::size_t number_of_members,
                         bool has_new_tangents)
  {
    if(vertices.origins.empty())
      return;
    std::map<std::size_t, std::size_t> uses, numbers; // by accessor; its number with repeated vertices
    const auto for_each_reference = [&](auto visit)
    {
      for(auto attribute = attributes.begin(); attribute != attributes.end(); ++attribute)
        if(attribute.key() != m_uv_attribute && !(has_new_tangents && attribute.key() == tangent_attribute))
          visit(attribute.value());
      for(Json& target : targets)
        for(Json& reference : target)
          visit(reference);
    };
    for_each_reference([&](Json& reference) { uses[reference.get<std::size_t>()] += number_of_members; });
    for(const auto& [accessor, number] : uses)
      numbers[accessor] = put_repeated(accessor, number, vertices.origins);
    for_each_reference([&](Json& reference) { reference = numbers[reference.get<std::size_t>()]; });
  }

  std::size_t put_repeated(std::size_t accessor, std::size_t uses, const std::vector<std::size_t>& origins)
  {
    const Elements elements(m_source.document, accessor);
    std::string bytes;
    const auto append = [&](std::size_t i)
    {
      bytes += elements.bytes(i);
      gltf::pad(bytes, '\0');
    };
    for(std::size_t i = 0; i < elements.number(); ++i)
      append(i);
    for(const std::size_t origin : origins)
      append(origin);
    const std::size_t stride = (elements.size() + 3) / 4 * 4;
    return m_data.put_accessor(replaceable(accessor, uses), m_source.document.description()["accessors"][accessor],
                               std::move(bytes), stride, gltf::array_buffer);
  }

  // The format wants all sets before, too, and some readers want them in order.
  void put_uvs(const Split_vertices& vertices, std::size_t uses, Json& attributes)
  {
    std::vector<std::string> missing;
    for(int set = 0; set < m_layout.uv_set; ++set)
      if(attributes.emplace(gltf::name_of_uvs(set), nullptr).second)
        missing.push_back(gltf::name_of_uvs(set));
    put_attribute(m_uv_attribute, "VEC2", vertices.uvs.size(), uses, attributes, [&](std::size_t v)
    {
      const int uv = vertices.uvs[v];
      return uv < 0 ? std::array<float, 2>{{0, 0}} : gltf_uv(m_layout.written_uv(std::size_t(uv)));
    });
    for(const std::string& name : missing)
      attributes[name] = attributes[m_uv_attribute];
  }

  void put_tangents(const Split_vertices& vertices, const Elements& normals, std::size_t uses, Json& attributes)
  {
    put_attribute(tangent_attribute, "VEC4", vertices.uvs.size(), uses, attributes, [&](std::size_t v)
                  { return vertices.uvs[v] < 0 ? any_tangent(normals.vector<3>(v)) : vertices.tangents[v]; });
  }

  // At its place among the others: some readers want it there.
  template <typename Numbers>
  void put_attribute(const std::string& name, const char* type, std::size_t count, std::size_t uses, Json& attributes,
                     Numbers numbers)
  {
    std::string bytes;
    for(std::size_t v = 0; v < count; ++v)
      for(const float number : numbers(v))
        store(number, false, bytes);
    const std::optional<std::size_t> former = gltf::find_number(attributes, name.c_str());
    attributes[name] = m_data.put_accessor(former ? replaceable(*former, uses) : std::nullopt,
                                           {{"componentType", gltf::single}, {"type", type}}, std::move(bytes),
                                           sizeof(numbers(0)), gltf::array_buffer);
  }

  // Unless the corners are what the primitive says already.
  void put_indices(const Primitive& primitive, const std::vector<int>& corners, std::size_t number_of_vertices, Json& json)
  {
    const bool are_triangles = gltf::number_or(json, "mode", triangles_mode) == triangles_mode;
    if(are_triangles && corners == primitive.vertices)
      return;
    json.erase("mode");
    const std::optional<std::size_t> former = gltf::find_number(json, "indices");
    const int type = number_of_vertices <= UINT16_MAX ? gltf::unsigned_short : gltf::unsigned_int;
    std::string bytes;
    for(const int vertex : corners)
      if(type == gltf::unsigned_short)
        store(std::uint16_t(vertex), false, bytes);
      else
        store(std::uint32_t(vertex), false, bytes);
    Json accessor = former ? m_source.document.description()["accessors"][*former] : Json::object();
    accessor.erase("min");
    accessor.erase("max");
    accessor["componentType"] = type;
    accessor["type"] = "SCALAR";
    json["indices"] = m_data.put_accessor(former ? replaceable(*former, 1) : std::nullopt, accessor, std::move(bytes),
                                          type == gltf::unsigned_short ? sizeof(std::uint16_t) : sizeof(std::uint32_t),
                                          gltf::element_array_buffer);
  }

  void add_material(const std::string& png)
  {
    const auto add = [&](const char* key, const Json& object)
    {
      Json& objects = m_data.description()[key];
      objects.push_back(object);
      return objects.size() - 1;
    };
    const std::size_t image = add("images", {{"bufferView", m_data.add_view(png)}, {"mimeType", "image/png"}});
    const std::size_t sampler = add("samplers", Json::object()); // repeats the image
    const std::size_t texture = add("textures", {{"source", image}, {"sampler", sampler}});
    m_material = add("materials", textured_material(texture, m_layout.uv_set));
  }

  const Layout& m_layout;
  const Gltf_source& m_source;
  gltf::Data m_data;
  const std::string m_uv_attribute;
  std::vector<Tangent> m_tangents; // per corner of the soup, if they are computed
  std::optional<std::size_t> m_material;
};

} // namespace

gltf::Content edited_gltf(const Layout& layout, const std::string& png, bool has_new_tangents,
                          const std::filesystem::path& folder)
{
  return Gltf_editor(layout, png, has_new_tangents).run(folder);
}
