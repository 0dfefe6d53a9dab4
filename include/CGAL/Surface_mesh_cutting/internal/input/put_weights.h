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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_PUT_WEIGHTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_PUT_WEIGHTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// From the smallest factor, where `value` is 0, to 1, where it is 1.
inline double interpolated_factor(double smallest_factor, double value)
{
  return smallest_factor + (1 - smallest_factor) * value;
}

inline Indexed_status check_factor(const char* name, double factor)
{
  if(factor >= 0 && factor <= 1)
    return Indexed_status();
  return Indexed_status(Status_code::WRONG_PARAMETER, std::string(name) + " must be between 0 and 1");
}

// What is never cut stays so, and what may be cut too, even if the product is too large for a number.
inline double weight_times_factor(double weight, double factor)
{
  if(std::isinf(weight))
    return weight;
  return (std::min)(weight * factor, (std::numeric_limits<double>::max)());
}

template <typename Adapter>
double factored_weight(const Adapter& adapter, internal_np::Param_not_found, int e, double factor)
{
  return adapter.to_original_scale(adapter.mesh().length(e) * factor);
}

template <typename Adapter, typename EdgeWeightMap>
double factored_weight(const Adapter& adapter, EdgeWeightMap given_weights, int e, double factor)
{
  return weight_times_factor(CGAL::to_double(get(given_weights, adapter.to_edge(e))), factor);
}

// Gives each edge its length, or what the named parameter `edge_weight_map` has for it, times a factor.
// `find_factors(adapter, factors)` computes one for each edge, unless it returns that it failed; those of
// border edges are not used. The two maps of weights may be the same.
template <typename TriangleMesh, typename EdgeWeightMap, typename NamedParameters, typename FindFactors>
Result_status<TriangleMesh> put_weights(const TriangleMesh& tmesh, EdgeWeightMap edge_weight_map, const NamedParameters& np,
                                        FindFactors find_factors)
{
  using parameters::get_parameter;

  const auto adapter = make_mesh_adapter(tmesh, np);
  Indexed_status status = adapter.status();
  std::vector<double> factors;
  if(status)
    status.finding = find_factors(adapter, factors).finding;
  if(status)
    for(int e = 0; e < adapter.mesh().number_of_edges(); ++e)
      if(!adapter.is_diagonal(e))
        put(edge_weight_map, adapter.to_edge(e),
            factored_weight(adapter, get_parameter(np, internal_np::edge_weight), e,
                            adapter.mesh().is_border_edge(e) ? 1 : factors[e]));
  return adapter.translate(status);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_PUT_WEIGHTS_H
