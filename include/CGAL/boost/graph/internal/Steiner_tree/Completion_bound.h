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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_COMPLETION_BOUND_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_COMPLETION_BOUND_H

#include <CGAL/boost/graph/internal/Steiner_tree/Dual_ascent.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Terminal_set.h>

#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// Lower bounds for what a subtree at a vertex v that connects the terminals of a set I still needs: a tree that
// connects v and the other terminals R (the future costs of Hougardy, Silvanus and Vygen 2017), from a dual solution.
// Let r be its root.
//  - If r is in R, the rest is a tree directed away from r that enters all sets of the dual solution that hold v or a
//    terminal of R, and its path to v costs at least the distance by reduced weights on top.
//  - If r is in I, the rest is directed away from v and enters all sets that hold a terminal of R but not v.
template <int Words>
class Completion_bound
{
  using Set = Terminal_set<Words>;

  const Dual_ascent* m_dual;
  std::vector<Set> m_groups;

public:
  explicit Completion_bound(const Dual_ascent& dual) : m_dual(&dual)
  {
    for(const Dual_ascent::Group& group : dual.groups()) {
      m_groups.emplace_back();
      for(int t : group.terminals)
        m_groups.back().insert(t);
    }
  }

  // the value of all sets that hold a terminal of R
  double base(const Set& rest) const
  {
    double sum = 0.;
    for(std::size_t g = 0; g < m_groups.size(); ++g)
      if(m_groups[g].intersects(rest))
        sum += m_dual->groups()[g].value;
    return sum;
  }

  double operator()(int v, const Set& rest, double base_of_rest) const
  {
    const bool holds_root = rest.contains(m_dual->root());
    double sum = base_of_rest + (holds_root ? m_dual->distance_from_root(v) : m_dual->distance_to_terminal(v));
    for(const Dual_ascent::Share& share : m_dual->shares(v))
      if(m_groups[share.group].intersects(rest) != holds_root)
        sum += holds_root ? share.value : -share.value;
    return sum;
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_COMPLETION_BOUND_H
