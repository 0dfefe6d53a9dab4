// Files that appear together, completely, or not at all.

#ifndef UNWRAP_OUTPUT_FILES_H
#define UNWRAP_OUTPUT_FILES_H

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

// Each file is written beside its place and renamed when all are complete.
// Whatever goes wrong is a `Failure` with `Exit_code::USAGE`.
class Output_files
{
public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;
  // Removes what was not published.
  ~Output_files();

  // Checks that a file can be written at `path`.
  static void check(const std::string& path);

  // Where the file of this name really is: a link is followed instead of replaced.
  static std::filesystem::path place_of(const std::string& path);
  // Devices and pipes are not replaced but written to.
  static bool is_replaced(const std::filesystem::path& place);

  // Writes `content`, which appears at `path` with `publish()`.
  void write(const std::string& path, const std::string& content);

  void publish();

private:
  // Temporary file and place
  std::vector<std::pair<std::filesystem::path, std::filesystem::path> > m_files;
};

#endif // UNWRAP_OUTPUT_FILES_H
