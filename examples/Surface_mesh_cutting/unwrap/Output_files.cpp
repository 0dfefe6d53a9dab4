#include "Output_files.h"

#include "stop_request.h"
#include "temporary_files.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

constexpr int patience = 300; // milliseconds for which a stopped run waits for a reader

class Descriptor
{
public:
  explicit Descriptor(int number) : m_number(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  int number() const { return m_number; }
  // False, with `errno`, if what was written is lost.
  bool close() { return m_number < 0 || ::close(std::exchange(m_number, -1)) == 0; }

private:
  int m_number;
};

constexpr std::size_t most_for_pipes = PIPE_BUF; // bytes that a pipe that is ready takes without waiting for its reader
constexpr std::size_t most_for_files = 1 << 20;  // files never wait for long

// Writes at most so many bytes at a time. For the user, it is about `place`.
void write_to(int descriptor, std::string_view content, std::size_t most, const fs::path& place)
{
  while(!content.empty())
  {
    pollfd request = {descriptor, POLLOUT, 0};
    const int number_ready = poll(&request, 1, patience);
    if(number_ready == 0)
      end_if_stop_is_requested();
    if(number_ready <= 0)
      continue;
    const ssize_t written = write(descriptor, content.data(), (std::min)(content.size(), most));
    if(written >= 0)
      content.remove_prefix(std::size_t(written));
    else if(errno != EINTR && errno != EAGAIN)
      fail_to_write(place, std::strerror(errno));
  }
}

// Waits for a reader, if it is a pipe that has a name.
int open_stream(const fs::path& path)
{
  std::error_code error;
  for(;;)
  {
    const int descriptor = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if(descriptor >= 0)
      return descriptor;
    if(errno != EINTR && !(errno == ENXIO && fs::is_fifo(path, error)))
      fail_to_write(path, std::strerror(errno));
    end_if_stop_is_requested();
    poll(nullptr, 0, patience / 10);
  }
}

void write_stream(const Output_place& place, const std::string& content)
{
  if(place.kind == Output_place::Kind::OPEN_DESCRIPTOR)
    return write_to(place.descriptor, content, most_for_pipes, place.path);
  Descriptor stream(open_stream(place.path));
  write_to(stream.number(), content, most_for_pipes, place.path);
  if(!stream.close())
    fail_to_write(place.path, std::strerror(errno));
}

// Gives the file to the owner of the one that it will replace, or at least to its group. Not everybody may.
bool give_away(const Descriptor& file, const struct stat& former)
{
  constexpr uid_t same_user = uid_t(-1);
  return fchown(file.number(), former.st_uid, former.st_gid) == 0 || fchown(file.number(), same_user, former.st_gid) == 0;
}

// With the permissions and, where possible, the owner of the file that it will replace.
void write_file(Descriptor& file, const std::string& content, const fs::path& place)
{
  struct stat former = {};
  if(stat(place.c_str(), &former) == 0)
  {
    if(fchmod(file.number(), former.st_mode & 0777) != 0)
      fail_to_write(place, std::strerror(errno));
    give_away(file, former);
  }
  write_to(file.number(), content, most_for_files, place);
  if(!file.close())
    fail_to_write(place, std::strerror(errno));
}

} // namespace

Output_files::~Output_files()
{
  const Undisturbed undisturbed;
  std::for_each(m_files.rbegin(), m_files.rend(), take_back);
}

void Output_files::add(const Output_place& place, std::string content)
{
  if(place.kind != Output_place::Kind::REGULAR_FILE)
  {
    m_streams.emplace_back(place, std::move(content));
    return;
  }
  int descriptor = -1;
  const fs::path temporary = make_temporary_file(place.path, [&](const char* name) {
    descriptor = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return descriptor < 0 ? errno : 0;
  });
  Descriptor file(descriptor);
  m_files.push_back({place.path, temporary, {}});
  write_file(file, content, place.path);
}

void Output_files::publish()
{
  {
    const Undisturbed undisturbed;
    std::for_each(m_files.begin(), m_files.end(), static_cast<void (*)(File&)>(publish));
  }
  for(const auto& [place, content] : m_streams)
    write_stream(place, content);

  const Undisturbed undisturbed;
  for(const File& file : m_files)
    for(const fs::path& path : {file.temporary, file.former})
      remove_temporary_file(path);
  m_files.clear();
}

void Output_files::publish(File& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(file.place, error);
  if(fs::exists(status) && !fs::is_regular_file(status))
    fail_to_write(file.place, "it is not a file any more");
  if(fs::exists(status))
    file.former = make_temporary_file(file.place, [&](const char* name) {
      // As a second name, so that there is always a file; not every file system has them.
      if(link(file.place.c_str(), name) == 0)
        return 0;
      return errno == EEXIST || rename(file.place.c_str(), name) == 0 ? errno : 0;
    });
  if(rename(file.temporary.c_str(), file.place.c_str()) != 0)
    fail_to_write(file.place, std::strerror(errno));
  file.is_published = true;
}

void Output_files::take_back(File& file)
{
  if(!file.former.empty())
    rename(file.former.c_str(), file.place.c_str()); // does nothing to two names of one file
  else if(file.is_published)
    unlink(file.place.c_str());
  remove_temporary_file(file.former);
  remove_temporary_file(file.temporary);
}
