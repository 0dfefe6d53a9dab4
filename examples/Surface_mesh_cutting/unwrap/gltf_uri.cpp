#include "gltf_uri.h"

#include "base64.h"
#include "file_bytes.h"
#include "gltf_json.h"
#include "outcome.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace gltf {

namespace {

namespace fs = std::filesystem;

// RFC 3986 lets these stand as they are in a path.
bool is_plain(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || std::string_view("-._~/!$&'()*+,;=@").find(c) != std::string_view::npos;
}

std::string encoded(const std::string& path)
{
  constexpr const char* digits = "0123456789ABCDEF";
  std::string uri;
  for(const char c : path)
  {
    const unsigned char byte = static_cast<unsigned char>(c);
    uri += is_plain(c) ? std::string(1, c) : std::string{'%', digits[byte / 16], digits[byte % 16]};
  }
  return uri;
}

bool is_below_folder(const fs::path& path)
{
  return !path.empty() && !path.is_absolute() && std::find(path.begin(), path.end(), "..") == path.end();
}

std::string decoded_data(const std::string& uri, const std::string& what)
{
  const std::size_t comma = uri.find(',');
  const std::string_view marker = ";base64", head = std::string_view(uri).substr(0, comma);
  const bool is_base64 = comma != std::string::npos && head.size() >= marker.size()
                         && head.substr(head.size() - marker.size()) == marker;
  const std::optional<std::string> bytes
    = is_base64 ? from_base64(std::string_view(uri).substr(comma + 1)) : std::nullopt;
  if(!bytes)
    fail("damaged glTF: " + what + " is not written in base64: " + quoted(uri));
  return *bytes;
}

} // namespace

bool is_data(const std::string& uri) { return uri.compare(0, 5, "data:") == 0; }

bool has_scheme(const std::string& uri)
{
  const std::size_t end = uri.find_first_of(":/?#");
  return end != std::string::npos && uri[end] == ':';
}

fs::path path_of(const std::string& uri)
{
  const auto is_digit = [&](std::size_t i) { return i < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i])); };
  std::string path;
  for(std::size_t i = 0; i < uri.size(); ++i)
    if(uri[i] == '%' && is_digit(i + 1) && is_digit(i + 2))
    {
      path += char(std::strtol(uri.substr(i + 1, 2).c_str(), nullptr, 16));
      i += 2;
    }
    else
      path += uri[i];
  return path;
}

std::string read_uri(const std::string& uri, const fs::path& folder, const std::string& what)
{
  if(is_data(uri))
    return decoded_data(uri, what);
  const fs::path path = path_of(uri);
  if(folder.empty() || has_scheme(uri) || !is_below_folder(path) || path.string().find('\0') != std::string::npos)
    fail(what + " is " + quoted(uri) + ", which is not a file in the folder of the glTF file or below it, and so not read");
  try
  {
    return read_bytes((folder / path).string());
  }
  catch(const Failure& failure)
  {
    if(failure.code == Exit_code::STOPPED)
      throw;
    fail(what + " is " + quoted(uri) + ": " + failure.what());
  }
}

std::string moved_uri(const std::string& uri, const fs::path& from, const fs::path& to)
{
  const fs::path path = path_of(uri), absolute_from = fs::absolute(from).lexically_normal(),
                 absolute_to = fs::absolute(to).lexically_normal();
  if(uri.empty() || has_scheme(uri) || path.is_absolute() || absolute_from == absolute_to)
    return uri;
  return encoded((absolute_from / path).lexically_relative(absolute_to).generic_string());
}

} // namespace gltf
