#include "command_line_checks.h"

#include "near_misses.h"
#include "option_values.h"

#include <cctype>
#include <string>
#include <vector>

namespace {

// As CLI11 would take the next option for the value of one that has none. A file of such a name can
// be given as ./--name or --option=--name.
bool looks_like_option(const std::string& argument)
{
  return argument.size() > 1 && argument[0] == '-'
         && (argument[1] == '-' || std::isalpha(static_cast<unsigned char>(argument[1])));
}

void check_is_known(const CLI::App& app, const std::string& argument)
{
  const std::string name = argument[1] == '-' ? argument.substr(0, argument.find('=')) : argument.substr(0, 2);
  if(app.get_option_no_throw(name) != nullptr)
    return;
  std::vector<std::string> names;
  for(const CLI::Option* const option : app.get_options([](const CLI::Option* other) { return other->nonpositional(); }))
    for(const std::string& long_name : option->get_lnames())
      names.push_back("--" + long_name);
  const std::string whole = argument.substr(0, argument.find('='));
  refuse("there is no option " + whole + suggestion(whole[1] == '-' ? whole : "-" + whole, names)); // -name may mean --name
}

} // namespace

void check_options(const CLI::App& app, int argc, char** argv)
{
  for(int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if(name == "--") // what follows are no options
      return;
    if(looks_like_option(name) && name.find('=') == name.size() - 1) // here, too
      refuse(name.substr(0, name.size() - 1) + ": the value is empty");
    if(looks_like_option(name))
      check_is_known(app, name);
    if(i + 1 == argc)
      return;
    const std::string value = argv[i + 1];
    const CLI::Option* const option = looks_like_option(name) ? app.get_option_no_throw(name) : nullptr;
    if(option == nullptr || option->get_expected_max() == 0)
      continue;
    if(looks_like_option(value))
      refuse(name + ": a value is missing before " + value);
    ++i;
  }
}

void check_no_value_is_empty(const CLI::App& app)
{
  for(const CLI::Option* const option : app.get_options())
    for(const std::string& value : option->results())
      if(value.empty())
        refuse(option->get_name() + ": the value is empty");
}

std::string find_json_file(int argc, char** argv)
{
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if(argument == "--json" && i + 1 < argc)
      return looks_like_option(argv[i + 1]) ? "" : argv[i + 1];
    if(argument.compare(0, 7, "--json=") == 0)
      return argument.substr(7);
  }
  return "";
}
