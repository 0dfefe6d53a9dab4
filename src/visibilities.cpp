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

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/visibilities.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

template std::optional<std::vector<double> > visibilities<Sequential_tag>(const Indexed_mesh&, const View&, Run_control&);
#ifdef CGAL_LINKED_WITH_TBB
template std::optional<std::vector<double> > visibilities<Parallel_tag>(const Indexed_mesh&, const View&, Run_control&);
#endif

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL
