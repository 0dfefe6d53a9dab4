// What options take for a value.

#ifndef UNWRAP_OPTION_VALUES_H
#define UNWRAP_OPTION_VALUES_H

#include "near_misses.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

[[noreturn]] inline void refuse(const std::string& message)
{
  throw CLI::ValidationError(message, CLI::ExitCodes::ValidationError);
}

// Whole decimal numbers, nothing else: CLI11 would take 010 for eight and NaN for in range.
template <typename Number>
bool parse_number(const std::string& word, Number& number)
{
  const char* const end = word.data() + word.size();
  const std::from_chars_result parsed = std::from_chars(word.data(), end, number);
  return !word.empty() && parsed.ptr == end && parsed.ec == std::errc();
}

template <typename Number>
Number parse_number(const std::string& option, const std::string& word, Number low, Number high)
{
  Number result = 0;
  if(!parse_number(word, result) || !(low <= result) || !(result <= high))
  {
    std::ostringstream message;
    message << option << ": '" << word << "' is not a number from " << low << " to " << high;
    refuse(message.str());
  }
  return result;
}

inline double parse_bound(const std::string& option, const std::string& word, double ideal, double high)
{
  double result = 0;
  if(!parse_number(word, result) || !(ideal < result) || !(result <= high))
  {
    std::ostringstream message;
    message << option << " must be greater than " << ideal << " and at most " << high << ", not '" << word << "'";
    refuse(message.str());
  }
  return result;
}

template <typename Number, typename Target>
CLI::Option* add_number(CLI::App& app, const std::string& name, Target& target,
                        const std::string& help, Number low, Number high)
{
  return app.add_option_function<std::string>(
    name, [=, &target](const std::string& word) { target = parse_number(name, word, low, high); },
    help);
}

// Makes an option take one of some words.
template <typename Target>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Target& target, const std::string& help,
                        const std::vector<std::string>& words)
{
  std::string list;
  for(const std::string& word : words)
    list += (list.empty() ? "" : "|") + word;
  CLI::Option* const option = app.add_option_function<std::string>(name, [=, &target](const std::string& word)
  {
    if(std::find(words.begin(), words.end(), word) == words.end())
      refuse(name + ": '" + word + "' is none of " + joined(words) + suggestion(word, words));
    target = word;
  }, help)->type_name(list);
  if constexpr(std::is_same_v<Target, std::string>)
    option->default_str(target);
  return option;
}

#endif // UNWRAP_OPTION_VALUES_H
