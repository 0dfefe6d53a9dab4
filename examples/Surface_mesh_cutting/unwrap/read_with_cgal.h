#ifndef UNWRAP_READ_WITH_CGAL_H
#define UNWRAP_READ_WITH_CGAL_H

#include "Polygon_soup.h"

#include <string>

// Reads what CGAL reads beyond the formats of `mesh_file.h`.
// Throws a `Failure` with `Exit_code::UNREADABLE`.
Polygon_soup read_with_cgal(const std::string& path);

#endif // UNWRAP_READ_WITH_CGAL_H
