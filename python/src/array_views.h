// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// The caller's arrays as the ranges that the library reads. They are not copied, and must outlive what looks at them.

#ifndef SURFACE_MESH_CUTTING_PYTHON_ARRAY_VIEWS_H
#define SURFACE_MESH_CUTTING_PYTHON_ARRAY_VIEWS_H

#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/irange.hpp>
#include <boost/range/iterator_range.hpp>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

namespace binding {

template <typename T>
using Array_view = boost::iterator_range<const T*>;

using Indices = Array_view<std::int64_t>;
using Numbers = Array_view<double>;

struct Polygon_soup_view
{
  Numbers coordinates; // three per point
  Indices corners;     // of all polygons, one polygon after the other
  Indices offsets;     // where the corners of each polygon begin, and where those of the last one end

  std::size_t number_of_points() const { return coordinates.size() / 3; }
  std::size_t number_of_polygons() const { return offsets.size() - 1; }
  Indices polygon(std::size_t p) const
  {
    return {corners.begin() + offsets[std::ptrdiff_t(p)], corners.begin() + offsets[std::ptrdiff_t(p) + 1]};
  }

  auto points() const
  {
    return boost::irange(std::size_t(0), number_of_points()) | boost::adaptors::transformed([this](std::size_t v)
           { return Eigen::Vector3d(coordinates.begin() + 3 * v); });
  }
  auto polygons() const
  {
    return boost::irange(std::size_t(0), number_of_polygons()) | boost::adaptors::transformed([this](std::size_t p)
           { return polygon(p); });
  }
};

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_ARRAY_VIEWS_H
