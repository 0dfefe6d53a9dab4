// Whether the writers of mesh files say what the readers understand.

#ifndef CHECK_FORMATS_H
#define CHECK_FORMATS_H

#include "Layout.h"

#include <string>

// Writes a layout in all formats, and reads those of text again. The return value says what got lost; empty if nothing
// did.
std::string find_format_fault(const Layout& layout);

#endif // CHECK_FORMATS_H
