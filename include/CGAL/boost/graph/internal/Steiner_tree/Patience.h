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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_PATIENCE_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_PATIENCE_H

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>


namespace CGAL {
namespace internal {
namespace Steiner_tree {

using Graph_kernel::Go_further;

// Asks whether to go on, for loops with short steps: only once in many of them. Once refused, always refused.
class Patience
{
  const Go_further& m_go_further;
  unsigned int m_number_of_steps = 0;
  bool m_is_over = false;

public:
  explicit Patience(const Go_further& go_further) : m_go_further(go_further) {}

  bool is_over() const { return m_is_over; }

  // to be called at each step
  bool lasts()
  {
    if(++m_number_of_steps % 1024 == 0) // well below a millisecond
      m_is_over = m_is_over || !m_go_further();
    return !m_is_over;
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_PATIENCE_H
