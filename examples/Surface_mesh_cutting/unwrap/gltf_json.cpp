#include "gltf_json.h"

#include "outcome.h"
#include "stop_request.h"

#include <algorithm>

namespace gltf {

void fail(const std::string& reason) { throw Failure(Exit_code::UNREADABLE, reason); }

std::string quoted(const std::string& text)
{
  constexpr std::size_t longest = 60;
  std::string start = text.substr(0, longest);
  std::replace_if(start.begin(), start.end(), [](char c) { return c < 32 || c > 126; }, '?');
  return "'" + start + (text.size() > longest ? "...'" : "'");
}

Json parse(const std::string& text)
{
  constexpr int deepest = 200; // nesting, as objects are copied and written by recursion
  unsigned int number_of_events = 0;
  const auto check = [&](int depth, Json::parse_event_t, Json&)
  {
    if(depth > deepest)
      fail("damaged glTF: its description is nested too deeply");
    if(++number_of_events % 1024 == 0)
      end_if_stop_is_requested();
    return true;
  };
  try
  {
    return Json::parse(text, check);
  }
  catch(const Json::parse_error& error)
  {
    fail("damaged glTF: its description is no JSON from byte " + std::to_string(error.byte) + " on");
  }
  catch(const Json::exception&)
  {
    fail("damaged glTF: its description has a number that is too large");
  }
}

const Json* find(const Json& object, const char* key)
{
  if(!object.is_object())
    return nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

const Json& list(const Json& object, const char* key)
{
  static const Json none = Json::array();
  const Json* const found = find(object, key);
  if(found != nullptr && !found->is_array())
    fail(std::string("damaged glTF: ") + key + " is not a list");
  return found == nullptr ? none : *found;
}

const Json& item(const Json& description, const char* key, std::size_t index)
{
  const Json& items = list(description, key);
  if(index >= items.size() || !items[index].is_object())
    fail("damaged glTF: it refers to number " + std::to_string(index) + " of its " + key + ", of which it has "
         + std::to_string(items.size()));
  return items[index];
}

std::optional<std::size_t> find_number(const Json& object, const char* key)
{
  const Json* const found = find(object, key);
  if(found == nullptr)
    return std::nullopt;
  constexpr double limit = 1e15;
  const double number = found->is_number() ? found->get<double>() : -1;
  if(!(number >= 0 && number <= limit) || double(std::size_t(number)) != number)
    fail(std::string("damaged glTF: ") + key + " is not a whole number");
  return std::size_t(number);
}

std::size_t number_or(const Json& object, const char* key, std::size_t other)
{
  return find_number(object, key).value_or(other);
}

std::string text_of(const Json& object, const char* key)
{
  const Json* const found = find(object, key);
  return found != nullptr && found->is_string() ? found->get<std::string>() : "";
}

std::vector<double> numbers_of(const Json& object, const char* key, std::size_t count)
{
  const Json& found = list(object, key);
  std::vector<double> numbers;
  for(const Json& number : found)
    if(number.is_number())
      numbers.push_back(number.get<double>());
  if(found.size() != numbers.size() || (!numbers.empty() && numbers.size() != count))
    fail(std::string("damaged glTF: ") + key + " does not have " + std::to_string(count) + " numbers");
  return numbers;
}

void for_each_member(const Json& json, const std::function<void(const std::string& key, const Json& value)>& visit)
{
  if(json.is_array())
    for(const Json& element : json)
      for_each_member(element, visit);
  if(json.is_object())
    for(const auto& [key, value] : json.items())
    {
      visit(key, value);
      for_each_member(value, visit);
    }
}

} // namespace gltf
