// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_RANDOM_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_RANDOM_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <cstdint>
#include <random>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Numbers that are the same everywhere, which the distributions of the standard library are not, and cheaper than those
// of CGAL::Random: searches for places draw hundreds of thousands.
class Packing_random
{
public:
  explicit Packing_random(unsigned int seed) : m_random(seed + 1) {}

  // From 0 to `end` - 1.
  int below(int end) { return int((std::uint64_t(m_random()) * std::uint64_t(end)) >> bits); }
  // From 0 to 1.
  double share() { return double(m_random()) / double(std::uint64_t(1) << bits); }

private:
  static constexpr int bits = 31; // of the numbers that are drawn

  std::minstd_rand m_random;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_RANDOM_H
