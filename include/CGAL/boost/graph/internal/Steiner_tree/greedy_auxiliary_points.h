// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_GREEDY_AUXILIARY_POINTS_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_GREEDY_AUXILIARY_POINTS_H

#include <CGAL/boost/graph/internal/Steiner_tree/Key_points.h>

#include <algorithm>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// adds the auxiliary point that shortens the metric closure's spanning tree most as long as that is by more than
// `minimum_decrease` (paper, Section 3.2). What counts in the end is the union of the paths, which may share
// edges: the shortest union over all steps is returned.
inline Tree insert_auxiliary_points(Key_points& points, double minimum_decrease, const Go_further& go_further)
{
  Tree best = points.tree();
  while(go_further()) {
    const Key_points::Insertion insertion = points.best_insertion();
    // no gain below rounding errors, or it would go on for ever
    if(!(points.length() - insertion.length > (std::max)(minimum_decrease, 1e-12 * points.length())))
      break;
    points.insert(insertion.vertex);
    Tree tree = points.tree();
    if(tree.length < best.length)
      best = tree;
  }
  return best;
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_GREEDY_AUXILIARY_POINTS_H
