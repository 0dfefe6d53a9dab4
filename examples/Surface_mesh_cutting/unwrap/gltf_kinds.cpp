#include "gltf_kinds.h"

#include <set>
#include <utility>

namespace gltf {

namespace {

template <typename Visit>
void for_each_primitive(const Json& description, Visit visit)
{
  for(const Json& mesh : list(description, "meshes"))
    for(const Json& primitive : list(mesh, "primitives"))
      visit(primitive);
}

std::set<std::string> names_of_attributes(const Json& description)
{
  std::set<std::string> names;
  for_each_primitive(description, [&](const Json& primitive)
  {
    if(const Json* const attributes = find(primitive, "attributes"); attributes != nullptr && attributes->is_object())
      for(const auto& attribute : attributes->items())
        names.insert(attribute.key());
  });
  return names;
}

Data_kinds kinds_of_attribute(const std::string& name)
{
  if(name == "POSITION" || name == "TEXCOORD_0")
    return {};
  if(name.compare(0, 9, "TEXCOORD_") == 0)
    return {Data_kind::OTHER_UV_SETS};
  if(name.compare(0, 7, "JOINTS_") == 0 || name.compare(0, 8, "WEIGHTS_") == 0)
    return {Data_kind::SKINS};
  return {name == "NORMAL" ? Data_kind::NORMALS
        : name == "COLOR_0" ? Data_kind::COLORS
        : name == "TANGENT" ? Data_kind::TANGENTS : Data_kind::OTHER_PROPERTIES};
}

bool has_alpha(const Json& description, const Json& primitive)
{
  const Json* const attributes = find(primitive, "attributes");
  const auto color = attributes == nullptr ? std::nullopt : find_number(*attributes, "COLOR_0");
  return color && text_of(item(description, "accessors", *color), "type") == "VEC4";
}

Data_kinds kinds_of_primitive(const Json& description, const Json& primitive)
{
  constexpr std::size_t triangles = 4;
  Data_kinds kinds;
  if(number_or(primitive, "mode", triangles) < triangles)
    kinds.insert(Data_kind::POINTS_AND_LINES);
  for(const Json& target : list(primitive, "targets"))
  {
    kinds.insert(Data_kind::MORPH_TARGETS);
    if(find(target, "TANGENT") != nullptr)
      kinds.insert(Data_kind::TANGENTS_OF_MORPH_TARGETS);
  }
  if(has_alpha(description, primitive))
    kinds.insert(Data_kind::TRANSPARENCY);
  return kinds;
}

} // namespace

Data_kinds kinds_of(const Document& document)
{
  const Json& description = document.description();
  Data_kinds kinds;
  if(document.has_unknown_chunks())
    kinds.insert(Data_kind::UNKNOWN_CHUNKS);
  for(const std::string& name : names_of_attributes(description))
    kinds.merge(kinds_of_attribute(name));
  for_each_primitive(description, [&](const Json& primitive) { kinds.merge(kinds_of_primitive(description, primitive)); });
  constexpr std::pair<const char*, Data_kind> lists[]
    = {{"materials", Data_kind::MATERIALS}, {"materials", Data_kind::LOOKS_OF_MATERIALS}, {"skins", Data_kind::SKINS},
       {"animations", Data_kind::ANIMATIONS}, {"cameras", Data_kind::CAMERAS}};
  for(const auto& [key, kind] : lists)
    if(!list(description, key).empty())
      kinds.insert(kind);
  for(const char* key : {"nodes", "meshes"})
    for(const Json& object : list(description, key))
      if(!text_of(object, "name").empty())
        kinds.insert(Data_kind::GROUPS);
  for_each_member(description, [&](const std::string& key, const Json& value)
  {
    if(key == "extras" || (key == "extensions" && value.is_object() && value.count("EXT_mesh_gpu_instancing") == 0))
      kinds.insert(Data_kind::EXTRAS);
  });
  return kinds;
}

namespace {

// Whether a texture of some material, also by an extension, is placed by the coordinates of a set.
bool has_textures_of(const Json& description, std::size_t set)
{
  bool has_found = false;
  for(const Json& material : list(description, "materials"))
    for_each_member(material, [&](const std::string&, const Json& value)
    {
      has_found = has_found || (value.is_object() && find_number(value, "index") && number_or(value, "texCoord", 0) == set);
    });
  return has_found;
}

} // namespace

std::string list_outdated(const Document& document, int uv_set, bool has_new_tangents)
{
  const Json& description = document.description();
  const std::set<std::string> attributes = names_of_attributes(description);
  const bool has_textures = attributes.count(name_of_uvs(uv_set)) != 0
                            && (uv_set == 0 ? !list(description, "textures").empty()
                                            : has_textures_of(description, std::size_t(uv_set)));
  const bool has_tangents = uv_set == 0 && attributes.count("TANGENT") != 0 && !has_new_tangents;
  return std::string(has_textures ? "textures" : "") + (has_textures && has_tangents ? " and " : "")
         + (has_tangents ? "tangents" : "");
}

} // namespace gltf
