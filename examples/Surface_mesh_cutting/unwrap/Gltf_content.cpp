#include "Gltf_content.h"

#include "base64.h"
#include "byte_order.h"
#include "outcome.h"

#include <cstdint>
#include <utility>

namespace gltf {

namespace {

// The buffer is the first one, of which the file may say more.
Json& set_length(Content& content)
{
  Json& buffers = content.description["buffers"];
  if(!buffers.is_array() || buffers.empty())
    buffers = Json::array({Json::object()});
  buffers[0]["byteLength"] = content.buffer.size();
  return buffers[0];
}

std::string to_text(const Json& description, int indentation)
{
  return description.dump(indentation, ' ', false, Json::error_handler_t::replace); // names may be no UTF-8
}

} // namespace

void pad(std::string& bytes, char with, std::size_t size)
{
  bytes.resize((bytes.size() + size - 1) / size * size, with);
}

// Header, text, buffer.
std::string to_binary_file(Content content)
{
  constexpr std::size_t header = 12, chunk_header = 8;
  const auto append = [](std::size_t number, std::string& bytes) { store(std::uint32_t(number), false, bytes); };
  set_length(content);
  std::string text = to_text(content.description, -1);
  pad(text, ' ');
  pad(content.buffer, '\0');
  const std::size_t size = header + 2 * chunk_header + text.size() + content.buffer.size();
  if(size > UINT32_MAX)
    throw Failure(Exit_code::UNSUPPORTED, "binary glTF holds at most four gigabytes; .gltf has no limit");
  std::string file = "glTF";
  file.reserve(size);
  append(2, file);
  append(size, file);
  append(text.size(), file);
  file += "JSON" + text;
  append(content.buffer.size(), file);
  file.append("BIN\0", 4);
  return file + content.buffer;
}

std::string to_text_file(Content content)
{
  set_length(content)["uri"] = "data:application/octet-stream;base64," + to_base64(content.buffer);
  return to_text(content.description, 2) + "\n";
}

} // namespace gltf
