#include "temporary_files.h"

#include "Output_place.h"
#include "stop_request.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

// Arrays, which are there even when a signal comes while the program exits. A run has at most two for each of its six outputs.
constexpr std::size_t capacity = 16;
constexpr std::size_t name_size = 4096;
char names[capacity][name_size];
std::array<std::atomic<bool>, capacity> is_used;

void remember(const std::string& name)
{
  for(std::size_t i = 0; i < capacity && name.size() < name_size; ++i)
    if(!is_used[i])
    {
      std::strcpy(names[i], name.c_str());
      is_used[i] = true;
      return;
    }
}

void forget(const std::string& name)
{
  for(std::size_t i = 0; i < capacity; ++i)
    if(is_used[i] && name == names[i])
      is_used[i] = false;
}

} // namespace

fs::path make_temporary_file(const fs::path& place, const std::function<int(const char*)>& create)
{
  const Undisturbed undisturbed;
  for(int number = 0;; ++number)
  {
    const fs::path name
      = place.parent_path() / (".unwrap_" + std::to_string(getpid()) + "_" + std::to_string(number) + ".tmp");
    const int error = create(name.c_str());
    if(error == 0)
    {
      remember(name.string());
      return name;
    }
    if(error != EEXIST)
      fail_to_write(place, std::strerror(error));
  }
}

void remove_temporary_file(const fs::path& name)
{
  const Undisturbed undisturbed;
  unlink(name.c_str());
  forget(name.string());
}

void remove_temporary_files()
{
  for(std::size_t i = 0; i < capacity; ++i)
    if(is_used[i])
      unlink(names[i]);
}
