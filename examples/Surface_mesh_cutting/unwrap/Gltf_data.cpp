#include "Gltf_data.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <tuple>
#include <utility>

namespace gltf {

namespace {

using Visit_number = std::function<void(std::size_t)>;

// Takes extensions with these names out of all objects.
void remove_extensions(Json& json, const std::vector<std::string>& names)
{
  if(json.is_object())
    if(const auto extensions = json.find("extensions"); extensions != json.end() && extensions->is_object())
    {
      for(const std::string& name : names)
        extensions->erase(name);
      if(extensions->empty())
        json.erase("extensions");
    }
  if(json.is_structured())
    for(Json& member : json)
      remove_extensions(member, names);
}

void remove_compression(Json& description)
{
  const std::vector<std::string> names = {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"};
  const Json* const used = find(description, "extensionsUsed");
  if(used == nullptr || !used->is_array())
    return;
  Json others = Json::array();
  for(const Json& name : *used)
    if(!name.is_string() || std::find(names.begin(), names.end(), name.get<std::string>()) == names.end())
      others.push_back(name);
  if(others.size() == used->size())
    return;
  remove_extensions(description, names);
  if(others.empty())
    description.erase("extensionsUsed");
  else
    description["extensionsUsed"] = others;
}

void visit_numbers(const Json& json, const Visit_number& visit)
{
  if(json.is_number() && json.get<double>() >= 0 && json.get<double>() <= double(UINT32_MAX))
    visit(json.get<std::size_t>());
  if(json.is_structured())
    for(const Json& member : json)
      visit_numbers(member, visit);
}

void visit_number(const Json& object, const char* key, const Visit_number& visit)
{
  if(const Json* const number = find(object, key))
    visit_numbers(*number, visit);
}

// Whatever extensions may refer to.
void visit_numbers_of_extensions(const Json& description, const Visit_number& visit)
{
  for_each_member(description, [&](const std::string& key, const Json& value)
  {
    if(key == "extensions" && value.is_object())
      for(const auto& [name, content] : value.items())
        if(!is_about_looks(name))
          visit_numbers(content, visit);
  });
}

void visit_accessors(const Json& description, const Visit_number& visit)
{
  for(const Json& mesh : list(description, "meshes"))
    for(const Json& primitive : list(mesh, "primitives"))
    {
      if(const Json* const attributes = find(primitive, "attributes"))
        visit_numbers(*attributes, visit);
      visit_numbers(list(primitive, "targets"), visit);
      visit_number(primitive, "indices", visit);
    }
  for(const Json& skin : list(description, "skins"))
    visit_number(skin, "inverseBindMatrices", visit);
  for(const Json& animation : list(description, "animations"))
    for(const Json& sampler : list(animation, "samplers"))
      for(const char* key : {"input", "output"})
        visit_number(sampler, key, visit);
  visit_numbers_of_extensions(description, visit);
}

void visit_views(const Json& description, const Visit_number& visit)
{
  for(const Json& accessor : list(description, "accessors"))
  {
    visit_number(accessor, "bufferView", visit);
    if(const Json* const sparse = find(accessor, "sparse"))
      for(const char* key : {"indices", "values"})
        if(const Json* const part = find(*sparse, key))
          visit_number(*part, "bufferView", visit);
  }
  for(const Json& image : list(description, "images"))
    visit_number(image, "bufferView", visit);
  visit_numbers_of_extensions(description, visit);
}

template <typename Visit_all>
std::vector<std::size_t> count(const Json& description, const char* key, Visit_all visit_all)
{
  std::vector<std::size_t> numbers(list(description, key).size(), 0);
  visit_all(description, [&](std::size_t number)
  {
    if(number < numbers.size())
      ++numbers[number];
  });
  return numbers;
}

} // namespace

Data::Data(const Document& document)
  : m_document(document), m_description(document.description()),
    m_number_of_former_views(list(m_description, "bufferViews").size())
{
  remove_compression(m_description);
  m_uses = count(m_description, "accessors", visit_accessors);
  for(const std::size_t number : count(m_description, "bufferViews", visit_views))
    m_was_used.push_back(number > 0);
}

std::size_t Data::put_accessor(std::optional<std::size_t> number, Json accessor, std::string bytes, std::size_t stride,
                               int target)
{
  Json& accessors = m_description["accessors"];
  Json view = {{"target", target}};
  if(target == array_buffer)
    view["byteStride"] = stride;
  accessor.erase("byteOffset");
  accessor.erase("sparse");
  accessor["bufferView"] = add_view(std::move(bytes), std::move(view));
  accessor["count"] = m_new_bytes.back().size() / stride;
  if(number)
    accessors[*number] = std::move(accessor);
  else
    accessors.push_back(std::move(accessor));
  return number.value_or(accessors.size() - 1);
}

std::size_t Data::add_view(std::string bytes, Json view)
{
  m_description["bufferViews"].push_back(std::move(view));
  m_new_bytes.push_back(std::move(bytes));
  return m_number_of_former_views + m_new_bytes.size() - 1;
}

// New views take the numbers of those that nothing refers to any more, as other numbers may be known to extensions.
Content Data::content()
{
  const std::vector<std::size_t> uses = count(m_description, "bufferViews", visit_views);
  std::vector<char> is_replaced(m_number_of_former_views, 0);
  std::vector<std::size_t> numbers; // of the new views
  for(std::size_t v = 0; v < m_number_of_former_views && numbers.size() < m_new_bytes.size(); ++v)
    if(m_was_used[v] && uses[v] == 0)
    {
      is_replaced[v] = 1;
      numbers.push_back(v);
    }
  const std::size_t number_of_replaced = numbers.size();
  for(std::size_t i = number_of_replaced; i < m_new_bytes.size(); ++i)
    numbers.push_back(m_number_of_former_views + i - number_of_replaced);

  Content result;
  result.buffer = place_former_views(is_replaced);
  Json views = m_description["bufferViews"];
  for(std::size_t i = 0; i < numbers.size(); ++i)
  {
    pad(result.buffer, '\0');
    Json view = {{"buffer", 0}, {"byteOffset", result.buffer.size()}, {"byteLength", m_new_bytes[i].size()}};
    view.update(m_description["bufferViews"][m_number_of_former_views + i]);
    views[numbers[i]] = std::move(view);
    result.buffer += m_new_bytes[i];
  }
  views.erase(views.begin() + std::ptrdiff_t(m_number_of_former_views + numbers.size() - number_of_replaced), views.end());
  m_description["bufferViews"] = std::move(views);
  for(const char* key : {"accessors", "images"})
    if(m_description.contains(key))
      for(Json& object : m_description[key])
        if(const Json* const view = find(object, "bufferView"); view != nullptr && view->is_number_unsigned()
           && view->get<std::size_t>() >= m_number_of_former_views)
          object["bufferView"] = numbers[view->get<std::size_t>() - m_number_of_former_views];

  Json buffer = list(m_description, "buffers").empty() ? Json::object() : m_description["buffers"][0];
  buffer.erase("uri");
  m_description["buffers"] = Json::array({std::move(buffer)});
  result.description = std::move(m_description);
  return result;
}

// One after the other in a single buffer; those that overlap stay so.
std::string Data::place_former_views(const std::vector<char>& is_replaced)
{
  constexpr std::size_t alignment = 8;
  using Range = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>; // buffer, begin, end, view
  std::vector<Range> ranges;
  Json& views = m_description["bufferViews"];
  for(std::size_t v = 0; v < is_replaced.size(); ++v)
    if(!is_replaced[v])
    {
      const std::size_t begin = number_or(views[v], "byteOffset", 0);
      ranges.emplace_back(number_or(views[v], "buffer", 0), begin, begin + number_or(views[v], "byteLength", 0), v);
    }
  std::sort(ranges.begin(), ranges.end());
  std::string bytes;
  for(std::size_t first = 0, last; first < ranges.size(); first = last)
  {
    const std::size_t buffer = std::get<0>(ranges[first]), begin = std::get<1>(ranges[first]) / alignment * alignment;
    std::size_t end = std::get<2>(ranges[first]);
    const auto is_next = [&](const Range& range) { return std::get<0>(range) == buffer && std::get<1>(range) <= end; };
    for(last = first + 1; last < ranges.size() && is_next(ranges[last]); ++last)
      end = (std::max)(end, std::get<2>(ranges[last]));
    pad(bytes, '\0', alignment);
    for(std::size_t i = first; i < last; ++i)
    {
      Json& view = views[std::get<3>(ranges[i])];
      view["buffer"] = 0;
      view["byteOffset"] = bytes.size() + std::get<1>(ranges[i]) - begin;
    }
    bytes += m_document.buffer(buffer).substr(begin, end - begin);
  }
  return bytes;
}

} // namespace gltf
