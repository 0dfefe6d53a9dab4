// Bytes as text, for pictures and pages that hold all of their data.

#ifndef UNWRAP_BASE64_H
#define UNWRAP_BASE64_H

#include <string>
#include <string_view>

std::string to_base64(std::string_view bytes);

#endif // UNWRAP_BASE64_H
