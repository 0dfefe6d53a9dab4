// Bytes as text (RFC 4648), for files that hold all of their data.

#ifndef UNWRAP_BASE64_H
#define UNWRAP_BASE64_H

#include <optional>
#include <string>
#include <string_view>

std::string to_base64(std::string_view bytes);

// Nothing if the text is none of this kind.
std::optional<std::string> from_base64(std::string_view text);

#endif // UNWRAP_BASE64_H
