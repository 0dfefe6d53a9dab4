// Where an output goes.

#ifndef UNWRAP_OUTPUT_PLACE_H
#define UNWRAP_OUTPUT_PLACE_H

#include <filesystem>
#include <string>

struct Output_place
{
  enum class Kind
  {
    REGULAR_FILE,   // appears when it is complete, and then replaces what is there
    DEVICE_OR_PIPE, // is opened and written to
    OPEN_DESCRIPTOR // the standard output and the like, written to where they stand
  };

  Kind kind = Kind::REGULAR_FILE;
  std::filesystem::path path; // links are followed instead of replaced
  int descriptor = -1;
};

Output_place find_output_place(const std::string& name);
Output_place standard_output_place();

// Whether an output at one of the places would replace or get into the other one. Two outputs may
// follow each other in a stream.
bool do_collide(const Output_place& place, const Output_place& other);

// Whether an output at `place` would replace or get into the file of this name, by whatever name or link.
bool is_file(const Output_place& place, const std::string& name);

// Finds out in advance whether a file can be written there. If not, throws a `Failure` with `Exit_code::USAGE`.
void check_output_place(const Output_place& place);

[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& reason);

#endif // UNWRAP_OUTPUT_PLACE_H
