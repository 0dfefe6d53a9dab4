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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_READ_PACKING_PARAMETERS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_READ_PACKING_PARAMETERS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Indexed_packing.h>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

template <typename NamedParameters>
Packing_parameters read_packing_parameters(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  constexpr double default_margin = 2;
  constexpr int default_texture_size = 1024;
  const double texels_per_unit = choose_parameter(get_parameter(np, internal_np::texels_per_unit), 0.);
  return {{double(choose_parameter(get_parameter(np, internal_np::margin), default_margin)),
           int(choose_parameter(get_parameter(np, internal_np::texture_size), default_texture_size))},
          bool(choose_parameter(get_parameter(np, internal_np::do_bijective), false)),
          choose_parameter(get_parameter(np, internal_np::effort), Effort::DEFAULT),
          choose_parameter(get_parameter(np, internal_np::chart_rotation), Chart_rotation::AUTOMATIC),
          int(choose_parameter(get_parameter(np, internal_np::number_of_pages), texels_per_unit > 0 ? 0 : 1)),
          texels_per_unit, bool(choose_parameter(get_parameter(np, internal_np::allow_flips), false))};
}

inline Indexed_status check_parameters(const Packing_parameters& parameters)
{
  const Packing_margin& margin = parameters.margin;
  if(margin.texture_size < 1)
    return Indexed_status(Status_code::WRONG_PARAMETER, "texture_size must be at least 1");
  if(!(margin.texels >= 0 && 2 * margin.texels < margin.texture_size))
    return Indexed_status(Status_code::WRONG_PARAMETER, "margin must be at least 0 and less than half of texture_size");
  if(!(parameters.texels_per_unit >= 0 && std::isfinite(parameters.texels_per_unit)))
    return Indexed_status(Status_code::WRONG_PARAMETER, "texels_per_unit must be finite and at least 0");
  if(parameters.most_pages < (parameters.texels_per_unit > 0 ? 0 : 1))
    return Indexed_status(Status_code::WRONG_PARAMETER, "number_of_pages must be at least 1");
  return Indexed_status();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_READ_PACKING_PARAMETERS_H
