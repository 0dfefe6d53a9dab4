#include "Output_place.h"

#include "outcome.h"
#include "temporary_files.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

// The descriptor behind a name like /proc/self/fd/1, to which /dev/stdout leads.
std::optional<int> descriptor_of(const fs::path& path)
{
  std::error_code error;
  const fs::path folder = fs::canonical(path.parent_path(), error);
  if(error || folder != fs::canonical("/proc/self/fd", error))
    return {};
  const std::string name = path.filename().string();
  const char* const end = name.data() + name.size();
  int descriptor = 0;
  const std::from_chars_result parsed = std::from_chars(name.data(), end, descriptor);
  return parsed.ec == std::errc() && parsed.ptr == end ? std::optional<int>(descriptor) : std::nullopt;
}

struct Identity
{
  bool exists = false;
  struct stat status = {};
  fs::path path;

  bool operator==(const Identity& other) const
  {
    if(!exists || !other.exists)
      return exists == other.exists && path == other.path;
    return status.st_dev == other.status.st_dev && status.st_ino == other.status.st_ino;
  }
};

Identity identity_of(const Output_place& place)
{
  Identity identity;
  identity.path = place.path;
  identity.exists = (place.kind == Output_place::Kind::OPEN_DESCRIPTOR
                       ? fstat(place.descriptor, &identity.status)
                       : stat(place.path.c_str(), &identity.status)) == 0;
  return identity;
}

// Renaming onto it fails, as is common in containers.
bool is_mount_point(const fs::path& path)
{
#ifdef STATX_ATTR_MOUNT_ROOT
  struct statx status = {};
  return statx(AT_FDCWD, path.c_str(), 0, 0, &status) == 0
         && (status.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
#else
  (void)path;
  return false;
#endif
}

// In a folder with the sticky bit, such as /tmp, a file belongs to its owner.
bool is_kept_by_sticky_folder(const fs::path& path)
{
  struct stat folder = {}, file = {};
  if(stat(path.parent_path().c_str(), &folder) != 0 || stat(path.c_str(), &file) != 0)
    return false;
  const uid_t user = geteuid();
  return (folder.st_mode & S_ISVTX) != 0 && user != 0 && user != folder.st_uid && user != file.st_uid;
}

bool is_read_only(const fs::path& path)
{
  struct stat file = {};
  return stat(path.c_str(), &file) == 0 && (file.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;
}

void check_existing_file(const fs::path& path)
{
  if(faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
    fail_to_write(path, std::strerror(errno));
  if(is_read_only(path)) // which does not stop root
    fail_to_write(path, "it is read-only");
  if(is_mount_point(path))
    fail_to_write(path, "it is a mount point, which cannot be replaced");
  if(is_kept_by_sticky_folder(path))
    fail_to_write(path, "only its owner can replace it in this folder");
}

void check_regular_file(const fs::path& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if(status.type() == fs::file_type::none)
    fail_to_write(path, error.message());
  if(fs::is_directory(status))
    fail_to_write(path, "it is a folder");
  if(fs::exists(status))
    check_existing_file(path);
  remove_temporary_file(make_temporary_file(path, [](const char* name) {
    const int descriptor = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    return descriptor < 0 || close(descriptor) != 0 ? errno : 0;
  }));
}

void check_device_or_pipe(const fs::path& path)
{
  if(faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
    fail_to_write(path, std::strerror(errno));
  std::error_code error;
  if(fs::is_block_file(path, error))
    fail_to_write(path, "it is a disk");
}

void check_descriptor(const Output_place& place)
{
  const int flags = fcntl(place.descriptor, F_GETFL);
  if(flags < 0)
    fail_to_write(place.path, std::strerror(errno));
  if((flags & O_ACCMODE) == O_RDONLY)
    fail_to_write(place.path, "it is open for reading only");
}

} // namespace

Output_place find_output_place(const std::string& name)
{
  std::error_code error;
  Output_place place;
  place.path = fs::absolute(name, error);
  for(int links = 0; links < 40; ++links)
  {
    if(const std::optional<int> descriptor = descriptor_of(place.path))
    {
      place.kind = Output_place::Kind::OPEN_DESCRIPTOR;
      place.path = name;
      place.descriptor = *descriptor;
      return place;
    }
    if(!fs::is_symlink(place.path, error))
      break;
    place.path = place.path.parent_path() / fs::read_symlink(place.path, error);
  }
  const fs::path canonical = fs::weakly_canonical(place.path, error);
  if(!error)
    place.path = canonical;
  const fs::file_status status = fs::status(place.path, error);
  if(fs::is_other(status))
    place.kind = Output_place::Kind::DEVICE_OR_PIPE;
  return place;
}

Output_place standard_output_place()
{
  return {Output_place::Kind::OPEN_DESCRIPTOR, "the standard output", STDOUT_FILENO};
}

bool do_collide(const Output_place& place, const Output_place& other)
{
  using Kind = Output_place::Kind;
  return (place.kind == Kind::REGULAR_FILE || other.kind == Kind::REGULAR_FILE)
         && identity_of(place) == identity_of(other);
}

bool is_file(const Output_place& place, const std::string& name)
{
  return identity_of(place) == identity_of(find_output_place(name));
}

void check_output_place(const Output_place& place)
{
  switch(place.kind)
  {
    case Output_place::Kind::REGULAR_FILE: return check_regular_file(place.path);
    case Output_place::Kind::DEVICE_OR_PIPE: return check_device_or_pipe(place.path);
    case Output_place::Kind::OPEN_DESCRIPTOR: return check_descriptor(place);
  }
}

void fail_to_write(const fs::path& path, const std::string& reason)
{
  throw Failure(Exit_code::USAGE, "cannot write " + path.string() + ": " + reason);
}
