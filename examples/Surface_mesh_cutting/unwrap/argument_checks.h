// What CLI11 does not say about a command line.

#ifndef UNWRAP_ARGUMENT_CHECKS_H
#define UNWRAP_ARGUMENT_CHECKS_H

#include <CLI/CLI.hpp>

#include <string>

// Throws the error of a value that is wrong.
[[noreturn]] void refuse(const std::string& message);

// Refuses an option without its value.
void check_values(const CLI::App& app, int argc, char** argv);

// An empty name of a file is that of an unset variable of a shell, and not no file.
void check_no_value_is_empty(const CLI::App& app);

// Where the report goes if the command line cannot be understood as a whole.
std::string find_json_file(int argc, char** argv);

#endif // UNWRAP_ARGUMENT_CHECKS_H
