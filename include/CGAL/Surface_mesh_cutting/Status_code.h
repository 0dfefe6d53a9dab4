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

#ifndef CGAL_SURFACE_MESH_CUTTING_STATUS_CODE_H
#define CGAL_SURFACE_MESH_CUTTING_STATUS_CODE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <string>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// how a call of this package ended.
enum class Status_code
{
  OK,                      ///< everything requested was computed.
  EMPTY_MESH,              ///< the mesh has no face.
  NOT_TRIANGULATED,        ///< a face has fewer than three different vertices or neighboring corners at the same vertex, or each
                           ///  of its triangulations repeats an edge of the surface or overlaps. Witness: faces.
  NON_MANIFOLD,            ///< an edge with more than two faces, a vertex whose faces form
                           ///  more than one fan, or a face given twice. Witness: vertices or faces.
  INVALID_POINT,           ///< a coordinate is infinite or not a number, or a part of the surface is too small for UVs
                           ///  next to those of the largest part. Witness: vertices.
  WRONG_PARAMETER,         ///< a parameter is out of its range, which the message names, or a weight is negative or
                           ///  not a number. Witness: the edges, vertices or faces concerned, if any.
  INFEASIBLE_CONSTRAINTS,  ///< no cut satisfies the constraints. Witness: the elements in conflict.
  NOT_CUT_TO_DISKS,        ///< the marked edges leave a part that is not a disk. Witness: the faces of such a part.
  NUMERICAL_FAILURE,       ///< no flip-free parameterization was found. Witness: faces.
  NOT_CERTIFIED,           ///< the result failed the exact check. Witness: faces.
  STOPPED,                 ///< the visitor or the time limit ended the run; `has_result` tells whether there is a result.
  BOUND_NOT_REACHED        ///< the result is valid but misses a bound on the distortion, or, with `Connection::EXACT`, lacks
                           ///  the proof that it is shortest. Witness: the faces above a bound on faces or charts.
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// returns the name of a status in lower case, such as `"bound_not_reached"`.
inline std::string to_string(Status_code code)
{
  switch(code)
  {
  case Status_code::OK:                     return "ok";
  case Status_code::EMPTY_MESH:             return "empty_mesh";
  case Status_code::NOT_TRIANGULATED:       return "not_triangulated";
  case Status_code::NON_MANIFOLD:           return "non_manifold";
  case Status_code::INVALID_POINT:          return "invalid_point";
  case Status_code::WRONG_PARAMETER:        return "wrong_parameter";
  case Status_code::INFEASIBLE_CONSTRAINTS: return "infeasible_constraints";
  case Status_code::NOT_CUT_TO_DISKS:       return "not_cut_to_disks";
  case Status_code::NUMERICAL_FAILURE:      return "numerical_failure";
  case Status_code::NOT_CERTIFIED:          return "not_certified";
  case Status_code::STOPPED:                return "stopped";
  case Status_code::BOUND_NOT_REACHED:      return "bound_not_reached";
  }
  return "";
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_STATUS_CODE_H
