// Outputs that appear together, completely, or not at all.

#ifndef UNWRAP_OUTPUT_FILES_H
#define UNWRAP_OUTPUT_FILES_H

#include "Output_place.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

// Each file is written beside its place and renamed when all are complete. Then come pipes and
// devices, which cannot be taken back.
// Whatever goes wrong is a `Failure`: `Exit_code::USAGE`, or `Exit_code::STOPPED` if a stop is
// requested while a pipe takes nothing.
class Output_files
{
public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;
  // Unless all were published, the files are as before.
  ~Output_files();

  // The output appears at `place` with `publish()`.
  void add(const Output_place& place, std::string content);

  void publish();

private:
  struct File
  {
    std::filesystem::path place, temporary;
    std::filesystem::path former; // what was there, until all are published
    bool is_published = false;
  };

  static void publish(File& file);
  static void take_back(File& file);

  std::vector<File> m_files;
  std::vector<std::pair<Output_place, std::string> > m_streams;
};

#endif // UNWRAP_OUTPUT_FILES_H
