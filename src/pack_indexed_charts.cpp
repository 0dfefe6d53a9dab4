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

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/pack_indexed_charts.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

template Indexed_packing pack_indexed_charts<Sequential_tag>(const Corner_table&, const std::vector<Eigen::Vector2d>&,
                                                             const Packing_parameters&,
                                                             const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>&,
                                                             Run_control&);
#ifdef CGAL_LINKED_WITH_TBB
template Indexed_packing pack_indexed_charts<Parallel_tag>(const Corner_table&, const std::vector<Eigen::Vector2d>&,
                                                           const Packing_parameters&,
                                                           const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>&,
                                                           Run_control&);
#endif

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL
