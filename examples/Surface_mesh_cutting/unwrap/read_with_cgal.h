#ifndef UNWRAP_READ_WITH_CGAL_H
#define UNWRAP_READ_WITH_CGAL_H

#include "Polygon_soup.h"

#include <optional>
#include <string>

// Reads what CGAL reads beyond the formats of `mesh_file.h`; nothing if the format is unknown or the file is damaged.
// Throws a `Failure` with `Exit_code::UNREADABLE` where an index is negative.
std::optional<Polygon_soup> read_with_cgal(const std::string& path);

#endif // UNWRAP_READ_WITH_CGAL_H
