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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_INDEXED_HEAP_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_INDEXED_HEAP_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// A 4-ary heap of items 0..n-1 with keys that can decrease. Equal keys leave in the order of their items, so
// that whatever is built on top depends on the input only.
class Indexed_heap
{
  struct Entry
  {
    double key;
    int item;
    bool operator<(const Entry& other) const
    {
      return key < other.key || (key == other.key && item < other.item);
    }
  };

  std::vector<Entry> m_entries;
  std::vector<int> m_positions;

public:
  explicit Indexed_heap(int number_of_items = 0) : m_positions(number_of_items, -1) {}

  bool empty() const { return m_entries.empty(); }
  double top_key() const { return m_entries.front().key; }
  int top() const { return m_entries.front().item; }
  bool contains(int item) const { return m_positions[item] >= 0; }

  void clear()
  {
    for(const Entry& e : m_entries)
      m_positions[e.item] = -1;
    m_entries.clear();
  }

  // inserts the item, or lowers its key
  void push_or_decrease(int item, double key)
  {
    int position = m_positions[item];
    if(position < 0) {
      position = int(m_entries.size());
      m_entries.push_back(Entry{key, item});
    }
    move_up(position, Entry{key, item});
  }

  int pop()
  {
    const int result = m_entries.front().item;
    m_positions[result] = -1;
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if(!m_entries.empty())
      move_down(last);
    return result;
  }

private:
  void place(int position, const Entry& entry)
  {
    m_entries[position] = entry;
    m_positions[entry.item] = position;
  }

  void move_up(int position, const Entry& entry)
  {
    while(position > 0) {
      const int parent = (position - 1) / 4;
      if(!(entry < m_entries[parent]))
        break;
      place(position, m_entries[parent]);
      position = parent;
    }
    place(position, entry);
  }

  void move_down(const Entry& entry)
  {
    const int size = int(m_entries.size());
    int position = 0;
    for(;;) {
      const int first = 4 * position + 1;
      if(first >= size)
        break;
      int best = first;
      for(int child = first + 1; child < size && child < first + 4; ++child)
        if(m_entries[child] < m_entries[best])
          best = child;
      if(!(m_entries[best] < entry))
        break;
      place(position, m_entries[best]);
      position = best;
    }
    place(position, entry);
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_INDEXED_HEAP_H
