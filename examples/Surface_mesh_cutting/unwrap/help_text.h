// What --help and --help-all print.

#ifndef UNWRAP_HELP_TEXT_H
#define UNWRAP_HELP_TEXT_H

#include <CLI/CLI.hpp>

#include <string>

extern const char* const program_description;

// --help shows what most people need, on two screens; --help-all everything.
class Help_formatter : public CLI::Formatter
{
public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
};

#endif // UNWRAP_HELP_TEXT_H
