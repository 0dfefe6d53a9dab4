#include "Gltf_document.h"

#include "byte_order.h"
#include "file_bytes.h"
#include "foreign_formats.h"
#include "gltf_uri.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace gltf {

namespace {

constexpr std::string_view magic = "glTF";

[[noreturn]] void fail_about_version_1() { fail("glTF 1 is not supported; 'gltf-pipeline -i IN -o OUT.glb' makes it glTF 2"); }

// An error in a buffer names its number.
std::string name_of(const char* kind, std::size_t index) { return kind + (" " + std::to_string(index)); }

void check_version(const Json& description)
{
  const Json* const asset = find(description, "asset");
  const std::string version = asset == nullptr ? "" : text_of(*asset, "version");
  if(version.compare(0, 2, "1.") == 0)
    fail_about_version_1();
  if(version.compare(0, 2, "2.") != 0)
    fail("damaged glTF: its asset.version is " + quoted(version) + " instead of '2.0'");
}

// Advice about meshes that cannot be read.
std::string advice(const std::string& extension)
{
  return extension == "KHR_draco_mesh_compression" ? "; 'gltf-transform copy IN.glb OUT.glb' decodes it"
       : extension == "EXT_meshopt_compression" || extension == "KHR_meshopt_compression"
           ? "; 'gltfpack -i IN.glb -o OUT.glb -noq' decodes it"
           : "; write the file without it";
}

void check_required(const Json& description)
{
  static const std::array<std::string, 3> supported
    = {{"KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_techniques_webgl"}};
  for(const Json& name : list(description, "extensionsRequired"))
  {
    const std::string extension = name.is_string() ? name.get<std::string>() : "";
    if(!is_about_looks(extension) && std::find(supported.begin(), supported.end(), extension) == supported.end())
      fail("the file requires the extension " + quoted(extension) + ", which is not supported" + advice(extension));
  }
}

bool is_binary(const std::string& bytes) { return bytes.compare(0, magic.size(), magic) == 0; }

struct Chunk
{
  std::uint32_t kind;
  std::string_view bytes;
};

constexpr std::uint32_t json_kind = 0x4e4f534a, binary_kind = 0x004e4942;

std::vector<Chunk> chunks_of(std::string_view bytes)
{
  constexpr std::size_t header = 12, chunk_header = 8;
  const auto number = [&](std::size_t at) -> std::size_t
  {
    if(bytes.size() < at + 4)
      fail("damaged glTF: the file is cut off");
    return load<std::uint32_t>(bytes.substr(at), false);
  };
  if(number(4) == 1)
    fail_about_version_1();
  if(number(4) != 2)
    fail("glTF " + std::to_string(number(4)) + " is not supported, only version 2");
  if(number(8) > bytes.size())
    fail("damaged glTF: the file is cut off");
  bytes = bytes.substr(0, number(8));
  std::vector<Chunk> chunks;
  for(std::size_t at = header; at + chunk_header <= bytes.size();)
  {
    const std::size_t size = number(at), begin = at + chunk_header;
    if(size > bytes.size() - begin)
      fail("damaged glTF: the chunk at byte " + std::to_string(at) + " should have " + std::to_string(size)
           + " bytes, but only " + std::to_string(bytes.size() - begin) + " follow");
    chunks.push_back({std::uint32_t(number(at + 4)), bytes.substr(begin, size)});
    at = begin + size;
  }
  return chunks;
}

// A buffer may stand for data that an extension has in another form.
[[noreturn]] void fail_about_missing(const Json& buffer, const std::string& name)
{
  if(const Json* const extensions = find(buffer, "extensions"))
    for(const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
      if(find(*extensions, extension) != nullptr)
        fail_about_compression(name, extension);
  fail("damaged glTF: " + name + " has no data");
}

} // namespace

bool is_about_looks(const std::string& extension)
{
  static const std::array<std::string_view, 10> beginnings
    = {{"KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_node_", "KHR_animation_", "KHR_xmp", "EXT_texture_",
        "EXT_lights_", "EXT_materials_", "MSFT_texture_"}};
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return extension.compare(0, beginning.size(), beginning) == 0; });
}

Document::Document(const std::string& bytes, std::filesystem::path folder)
  : m_folder(std::move(folder)), m_description(read_description(bytes))
{
  for(const Chunk& chunk : is_binary(bytes) ? chunks_of(bytes) : std::vector<Chunk>())
  {
    if(chunk.kind == binary_kind && !m_chunk)
      m_chunk = chunk.bytes;
    m_has_unknown_chunks = m_has_unknown_chunks || (chunk.kind != binary_kind && chunk.kind != json_kind);
  }
  if(!m_description.is_object())
    fail("damaged glTF: its description is no object");
  check_version(m_description);
  check_required(m_description);
}

std::string_view Document::buffer(std::size_t index) const
{
  const Json& buffer = item(m_description, "buffers", index);
  const std::string name = name_of("buffer", index);
  const std::size_t length = number_or(buffer, "byteLength", 0);
  const bool is_chunk = index == 0 && m_chunk && find(buffer, "uri") == nullptr;
  auto found = m_buffers.find(index);
  if(!is_chunk && found == m_buffers.end())
  {
    if(find(buffer, "uri") == nullptr)
      fail_about_missing(buffer, name);
    found = m_buffers.emplace(index, read_uri(text_of(buffer, "uri"), m_folder, name)).first;
  }
  const std::string_view bytes = is_chunk ? *m_chunk : found->second;
  if(bytes.size() < length)
    fail("damaged glTF: " + name + " has " + std::to_string(bytes.size()) + " bytes instead of " + std::to_string(length));
  return bytes.substr(0, length);
}

std::string_view Document::view(std::size_t index) const
{
  const Json& view = item(m_description, "bufferViews", index);
  const std::string_view bytes = buffer(number_or(view, "buffer", 0));
  const std::size_t first = number_or(view, "byteOffset", 0), length = number_or(view, "byteLength", 0);
  if(first > bytes.size() || length > bytes.size() - first)
    fail("damaged glTF: " + name_of("buffer view", index) + " reaches beyond its buffer");
  return bytes.substr(first, length);
}

void Document::read_all() const
{
  for(std::size_t i = 0; i < list(m_description, "bufferViews").size(); ++i)
    view(i);
}

Json read_description(const std::string& bytes)
{
  if(!is_binary(bytes))
    return parse(bytes);
  const std::vector<Chunk> chunks = chunks_of(bytes);
  return chunks.empty() || chunks.front().kind != json_kind ? Json() : parse(std::string(chunks.front().bytes));
}

void fail_about_compression(const std::string& what, const std::string& extension)
{
  fail(what + " is there only as compressed by " + extension + advice(extension));
}

Document read_document(const std::string& path)
{
  const std::string bytes = read_bytes(path);
  if(bytes.empty())
    fail("the file is empty");
  if(const std::string reason = refuse_foreign_content(bytes); !reason.empty())
    fail(reason);
  return Document(bytes, "." / std::filesystem::path(path).parent_path());
}

} // namespace gltf
