#include "Output_files.h"

#include "outcome.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason)
{
  throw Failure(Exit_code::USAGE, "cannot write " + path.string() + ": " + reason);
}

fs::path temporary_beside(const fs::path& place, std::size_t number = 0)
{
  return place.parent_path()
         / (".unwrap_" + std::to_string(getpid()) + "_" + std::to_string(number) + ".tmp");
}

// Writes to `file`; for the user, it is about `place`.
void write_file(const fs::path& file, const char* mode, const std::string& content,
                const fs::path& place)
{
  errno = 0;
  std::FILE* const stream = std::fopen(file.c_str(), mode);
  if(stream == nullptr)
    fail(place, std::strerror(errno));
  const bool is_written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
  if(std::fclose(stream) != 0 || !is_written)
    fail(place, std::strerror(errno));
}

} // namespace

Output_files::~Output_files()
{
  std::error_code error;
  for(const auto& file : m_files)
    fs::remove(file.first, error);
}

fs::path Output_files::place_of(const std::string& path)
{
  std::error_code error;
  fs::path place = fs::absolute(path);
  for(int links = 0; links < 40 && fs::is_symlink(place, error); ++links)
    place = place.parent_path() / fs::read_symlink(place, error);
  const fs::path canonical = fs::weakly_canonical(place, error);
  return error ? place : canonical;
}

bool Output_files::is_replaced(const fs::path& place)
{
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  return !fs::exists(status) || fs::is_regular_file(status);
}

void Output_files::check(const std::string& path)
{
  const fs::path place = place_of(path);
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  if(status.type() == fs::file_type::none)
    fail(place, error.message());
  if(fs::is_directory(status))
    fail(place, "it is a folder");
  if(!is_replaced(place))
    return;
  const fs::path temporary = temporary_beside(place);
  write_file(temporary, "wx", "", place);
  fs::remove(temporary, error);
}

void Output_files::write(const std::string& path, const std::string& content)
{
  const fs::path place = place_of(path);
  if(!is_replaced(place))
  {
    write_file(place, "w", content, place);
    return;
  }
  m_files.emplace_back(temporary_beside(place, m_files.size()), place);
  write_file(m_files.back().first, "wx", content, place);
}

void Output_files::publish()
{
  for(const auto& file : m_files)
  {
    std::error_code error;
    fs::rename(file.first, file.second, error);
    if(error)
      fail(file.second, error.message());
  }
  m_files.clear();
}
