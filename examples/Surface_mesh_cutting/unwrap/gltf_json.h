// The description of a glTF file, read with care: it says nothing that can be relied upon.

#ifndef UNWRAP_GLTF_JSON_H
#define UNWRAP_GLTF_JSON_H

#include <nlohmann/json.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gltf {

using Json = nlohmann::ordered_json;

// Throws a `Failure` with `Exit_code::UNREADABLE`.
[[noreturn]] void fail(const std::string& reason);

// A name from a file as messages quote it: short, and without control characters.
std::string quoted(const std::string& text);

// Fails if it is no JSON, or nested so deeply that nobody would write it. Ends if a stop is requested.
Json parse(const std::string& text);

// What an object has under a key, or null.
const Json* find(const Json& object, const char* key);

// An empty list if the object has none. Fails if there is something else.
const Json& list(const Json& object, const char* key);

// An object of one of the lists of a file, as `accessors`. Fails if there is none.
const Json& item(const Json& description, const char* key, std::size_t index);

// A whole number that is not negative. Fails if there is something else.
std::optional<std::size_t> find_number(const Json& object, const char* key);
std::size_t number_or(const Json& object, const char* key, std::size_t other);

// Empty if there is none, or something else.
std::string text_of(const Json& object, const char* key);

// So many numbers, or none.
std::vector<double> numbers_of(const Json& object, const char* key, std::size_t count);

// Visits all members of all objects in `json`.
void for_each_member(const Json& json, const std::function<void(const std::string& key, const Json& value)>& visit);

// The name of the attribute that holds a set of texture coordinates.
inline std::string name_of_uvs(int set) { return "TEXCOORD_" + std::to_string(set); }

} // namespace gltf

#endif // UNWRAP_GLTF_JSON_H
