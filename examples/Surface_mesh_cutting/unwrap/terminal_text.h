#ifndef UNWRAP_TERMINAL_TEXT_H
#define UNWRAP_TERMINAL_TEXT_H

#include <string>
#include <string_view>

// A message as one line of a terminal: escape sequences instead of what the terminal would obey, which may come from names
// of files or from what they say.
std::string for_terminal(std::string_view text);

#endif // UNWRAP_TERMINAL_TEXT_H
