// Files that no end of the program leaves behind.

#ifndef UNWRAP_TEMPORARY_FILES_H
#define UNWRAP_TEMPORARY_FILES_H

#include <filesystem>
#include <functional>

// Finds a new name beside `place` for which `create(name)`, which returns 0 or an error number, does
// not say that there is such a file. `remove_temporary_files()` knows it from then on.
// Throws the error as a `Failure` about `place`.
std::filesystem::path make_temporary_file(const std::filesystem::path& place,
                                          const std::function<int(const char*)>& create);

// Removes it, if it is still there.
void remove_temporary_file(const std::filesystem::path& name);

// Removes all. A signal handler may call it.
void remove_temporary_files();

#endif // UNWRAP_TEMPORARY_FILES_H
