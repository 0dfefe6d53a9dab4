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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_CUT_SYMMETRICALLY_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_CUT_SYMMETRICALLY_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Mesh_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Mesh_cutter.h>
#include <CGAL/Surface_mesh_cutting/internal/halves/Half_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/halves/Symmetric_cutter.h>

#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A cut that the first of the symmetries which can do so maps to itself; none if there is none.
inline std::optional<Mesh_result> symmetric_result(const Indexed_mesh& mesh, Output_kind output, const Round& round,
                                                   const Cutting_constraints& constraints, const Context& context,
                                                   const std::vector<Indexed_symmetry>& symmetries)
{
  for(const Indexed_symmetry& symmetry : symmetries)
  {
    if(!symmetry.is_symmetry() || !symmetry.is_exact || !context.control.go_further())
      continue;
    const Half_mesh half(mesh, symmetry);
    if(!half.is_divided())
      continue;
    Mesh_result result = Symmetric_cutter(mesh, round, constraints, context, half).run(output);
    if(!result.has_result)
      continue;
    result.symmetry = symmetry;
    return result;
  }
  return std::nullopt;
}

// Why a cut is not symmetric.
inline std::string reason_for_asymmetry(const std::vector<Indexed_symmetry>& symmetries)
{
  if(symmetries.empty())
    return "the cut is not symmetric, since the surface has no area";
  const Indexed_symmetry& best = symmetries.front();
  if(!best.is_symmetry())
  {
    constexpr int digits = 3;
    std::ostringstream text;
    text.precision(digits);
    text << "the cut is not symmetric, since the surface is not: the best plane matches " << 100 * best.matched
         << " % of the vertices, and 98 % are needed";
    return text.str();
  }
  return best.is_exact ? "the cut is not symmetric: the plane of symmetry crosses faces, or constraints prevent it"
                       : "the cut is not symmetric, since only the shape of the surface is: edges are not mirrored by edges";
}

// Cuts as the symmetry that is asked for allows, and as usual where there is none.
inline Mesh_result cut_symmetrically(const Indexed_mesh& mesh, Output_kind output, const Round& round,
                                     const Cutting_constraints& constraints, const Context& context)
{
  const std::vector<Indexed_symmetry> symmetries
    = find_indexed_symmetries(mesh, constraints.edges.diagonals, context.parameters.symmetry, context.execution);
  if(std::optional<Mesh_result> result = symmetric_result(mesh, output, round, constraints, context, symmetries))
    return *std::move(result);
  Mesh_result result = Mesh_cutter(mesh, round, constraints, context).run(output);
  result.status.warnings.push_back(Finding{Status_code::OK, reason_for_asymmetry(symmetries), Element_kind::NONE, {}});
  if(!symmetries.empty() && symmetries.front().is_symmetry())
    result.symmetry = symmetries.front();
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_CUT_SYMMETRICALLY_H
