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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_STATUS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_STATUS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Status_code.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The kind of element that the indices of a finding name.
enum class Element_kind { NONE, VERTEX, EDGE, FACE };

// Names an event and its place, in indices of the index arrays. The public `Result_status` translates the
// indices into descriptors of the caller's mesh.
struct Finding
{
  Status_code code = Status_code::OK;
  std::string message;
  Element_kind kind = Element_kind::NONE;
  std::vector<int> indices;
};

struct Indexed_status
{
  Finding finding;
  std::vector<Finding> warnings;

  Indexed_status() = default;
  Indexed_status(Status_code code, std::string message,
                 Element_kind kind = Element_kind::NONE, std::vector<int> indices = {})
    : finding{code, std::move(message), kind, std::move(indices)}
  {}

  // Whether a valid result was computed: a stopped run and a missed bound leave one, too.
  bool has_result() const
  {
    return finding.code == Status_code::OK || finding.code == Status_code::BOUND_NOT_REACHED;
  }
  explicit operator bool() const { return finding.code == Status_code::OK; }
};

inline Indexed_status stopped_status()
{
  return Indexed_status(Status_code::STOPPED, "stopped before all was done");
}

inline Indexed_status bound_missed(double reached, double bound)
{
  std::ostringstream message;
  message.precision(6);
  message << "no cut was found whose map keeps the bound on the distortion: the mean energy is " << reached << ", the bound "
          << bound;
  return Indexed_status(Status_code::BOUND_NOT_REACHED, message.str());
}

// `of`: what the bound holds for; `missed_by`: what `faces` stand for.
inline Indexed_status local_bound_missed(const std::string& of, const std::string& missed_by, std::vector<int> faces, double bound)
{
  std::ostringstream message;
  message.precision(6);
  message << "no cut was found whose map keeps the bound of " << bound << " on the energy of " << of << ": missed by "
          << missed_by;
  return Indexed_status(Status_code::BOUND_NOT_REACHED, message.str(), Element_kind::FACE, std::move(faces));
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_STATUS_H
