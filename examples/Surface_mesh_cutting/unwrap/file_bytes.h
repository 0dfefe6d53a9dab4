// Files as a whole.

#ifndef UNWRAP_FILE_BYTES_H
#define UNWRAP_FILE_BYTES_H

#include <string>

// Throws a `Failure` with `Exit_code::UNREADABLE` unless it is a file that can be read, or with
// `Exit_code::STOPPED`.
std::string read_bytes(const std::string& path);

// The standard input, to its end. The same failures.
std::string read_standard_input();

#endif // UNWRAP_FILE_BYTES_H
