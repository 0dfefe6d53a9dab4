// What CLI11 does not find wrong with a command line, or does not say well.

#ifndef UNWRAP_COMMAND_LINE_CHECKS_H
#define UNWRAP_COMMAND_LINE_CHECKS_H

#include <CLI/CLI.hpp>

#include <string>

// Refuses options that are unknown, and those without a value. Before parsing.
void check_options(const CLI::App& app, int argc, char** argv);

// An empty name of a file is that of an unset variable of a shell, and not no file. After parsing.
void check_no_value_is_empty(const CLI::App& app);

// Where the report goes if the command line cannot be understood as a whole.
std::string find_json_file(int argc, char** argv);

#endif // UNWRAP_COMMAND_LINE_CHECKS_H
