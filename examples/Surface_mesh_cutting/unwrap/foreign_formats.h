#ifndef UNWRAP_FOREIGN_FORMATS_H
#define UNWRAP_FOREIGN_FORMATS_H

#include <string>
#include <string_view>

// Why a file in a well-known format that is not read is refused, and what to do; empty for other files. The format is
// told by how the bytes begin.
std::string refuse_foreign_content(std::string_view bytes);
// The same, also for glTF in text, which needs its ending.
std::string refuse_content(std::string_view bytes);
// The same, told by the ending of the name.
std::string refuse_ending(const std::string& path);

#endif // UNWRAP_FOREIGN_FORMATS_H
