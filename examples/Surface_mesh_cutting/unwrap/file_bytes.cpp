#include "file_bytes.h"

#include "outcome.h"
#include "stop_request.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <poll.h>
#include <unistd.h>
#include <vector>

namespace {

[[noreturn]] void fail(const std::string& reason) { throw Failure(Exit_code::UNREADABLE, reason); }

void check_is_file(const std::string& path)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if(status.type() == std::filesystem::file_type::none)
    fail("the file cannot be read: " + error.message());
  if(!std::filesystem::exists(status))
    fail("there is no such file");
  if(!std::filesystem::is_regular_file(status))
    fail("not a file");
}

[[noreturn]] void fail_to_read(int error) { fail(std::string("the file cannot be read: ") + std::strerror(error)); }

// It may be a pipe, whose writer takes its time.
void wait_for_standard_input()
{
  constexpr int milliseconds = 100;
  pollfd request = {STDIN_FILENO, POLLIN, 0};
  while(poll(&request, 1, milliseconds) <= 0)
    end_if_stop_is_requested();
  end_if_stop_is_requested();
}

} // namespace

std::string read_standard_input()
{
  std::string bytes;
  std::vector<char> chunk(1 << 20);
  for(;;)
  {
    wait_for_standard_input();
    const ssize_t length = read(STDIN_FILENO, chunk.data(), chunk.size());
    if(length == 0)
      return bytes;
    if(length > 0)
      bytes.append(chunk.data(), std::size_t(length));
    else if(errno != EINTR && errno != EAGAIN)
      fail_to_read(errno);
  }
}

std::string read_bytes(const std::string& path)
{
  check_is_file(path);
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if(file == nullptr)
    fail_to_read(errno);
  std::error_code error;
  std::string bytes;
  const auto size = std::filesystem::file_size(path, error);
  if(!error)
    bytes.reserve(std::size_t(size));
  std::vector<char> chunk(1 << 20);
  while(const std::size_t length = std::fread(chunk.data(), 1, chunk.size(), file.get()))
  {
    end_if_stop_is_requested();
    bytes.append(chunk.data(), length);
  }
  if(std::ferror(file.get()) != 0)
    fail_to_read(errno);
  return bytes;
}
