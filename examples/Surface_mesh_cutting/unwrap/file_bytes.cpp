#include "file_bytes.h"

#include "outcome.h"

#include <filesystem>
#include <fstream>

std::string read_bytes(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if(!std::filesystem::exists(status))
    throw Failure(Exit_code::UNREADABLE, "there is no such file");
  if(!std::filesystem::is_regular_file(status))
    throw Failure(Exit_code::UNREADABLE, "not a file");

  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  if(file)
  {
    bytes.resize(std::size_t(std::filesystem::file_size(path)));
    file.read(&bytes[0], std::streamsize(bytes.size()));
  }
  if(!file)
    throw Failure(Exit_code::UNREADABLE, "the file cannot be read");
  return bytes;
}
