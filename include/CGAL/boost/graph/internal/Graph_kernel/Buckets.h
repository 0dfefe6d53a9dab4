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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_BUCKETS_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_BUCKETS_H

#include <CGAL/Iterator_range.h>

#include <numeric>
#include <vector>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// Entries of numbered buckets, one bucket after the other in a single list. In each, they keep the order in which they come.
template <typename Entry>
class Buckets
{
public:
  Buckets() = default;

  // `for_each_entry(visit)` calls `visit(bucket, entry)` for each entry: once to count, and once again in the same order.
  template <typename ForEachEntry>
  Buckets(int number_of_buckets, const ForEachEntry& for_each_entry) : m_starts(number_of_buckets + 1, 0)
  {
    for_each_entry([&](int bucket, const Entry&) { ++m_starts[bucket + 1]; });
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    m_entries.resize(m_starts.back());
    std::vector<int> ends(m_starts.begin(), m_starts.end() - 1); // of what has come so far
    for_each_entry([&](int bucket, const Entry& entry) { m_entries[ends[bucket]++] = entry; });
  }

  int number_of_buckets() const { return int(m_starts.size()) - 1; }
  int size(int bucket) const { return m_starts[bucket + 1] - m_starts[bucket]; }

  Iterator_range<const Entry*> operator[](int bucket) const
  { return make_range(m_entries.data() + m_starts[bucket], m_entries.data() + m_starts[bucket + 1]); }
  Iterator_range<Entry*> operator[](int bucket)
  { return make_range(m_entries.data() + m_starts[bucket], m_entries.data() + m_starts[bucket + 1]); }

private:
  std::vector<int> m_starts = {0};
  std::vector<Entry> m_entries;
};

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_BUCKETS_H
