#ifndef UNWRAP_READ_BINARY_OFF_H
#define UNWRAP_READ_BINARY_OFF_H

#include "Off_header.h"
#include "mesh_file.h"

#include <string_view>

// The same as the other kind of OFF, in 32 bits for each number, the highest ones first. `bytes` are those behind the header.
Polygon_soup read_binary_off(std::string_view bytes, const Off_header& header, Attributes attributes);

#endif // UNWRAP_READ_BINARY_OFF_H
