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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_MAPPING_POLICY_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_MAPPING_POLICY_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::First_map;
using Surface_mesh_parameterization::internal::Newton_options;
using Surface_mesh_parameterization::internal::Solvers;

// How maps are solved while cuts are compared.
struct Mapping_policy
{
  explicit Mapping_policy(const Solvers& source) : linear_solvers(source) {}

  const Solvers& linear_solvers;
  First_map first_map = First_map::HIERARCHY;
  // See `Newton_options::decrement`. An accuracy well below epsilon_iso suffices: what the last step leaves
  // is far less than the decrement before it.
  double precision = 1e-4;
  // The same for the map that is returned: about as close, relatively, its energy comes to the least.
  double final_precision = 1e-5;
  // Whether estimates may reject a slit. A slit is always accepted as soon as a map is found that gains
  // enough, since the best map gains no less.
  bool uses_estimates = true;
};

// The paper starts from Tutte's embedding (Section 3.4) and solves each map to the end (Section 4).
inline Mapping_policy mapping_policy(const Cutting_parameters& parameters)
{
  Mapping_policy policy(*parameters.linear_solvers);
  if(parameters.use_published_method)
  {
    policy.first_map = First_map::TUTTE;
    policy.precision = policy.final_precision = Newton_options().decrement;
    policy.uses_estimates = false;
  }
  return policy;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_MAPPING_POLICY_H
