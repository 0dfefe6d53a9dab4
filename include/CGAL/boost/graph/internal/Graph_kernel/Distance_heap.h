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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_DISTANCE_HEAP_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_DISTANCE_HEAP_H

#include <boost/graph/detail/d_ary_heap.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <vector>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// A distance that knows its vertex. Equal ones are in the order of the vertices' indices: a search whose heap
// compares these settles vertices in an order that depends on the graph alone, whichever way the heap is built.
struct Indexed_distance
{
  double distance;
  int index;

  friend bool operator<(const Indexed_distance& a, const Indexed_distance& b)
  {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
  }
};

// the distances in an array, each with the index of its vertex
template <typename VertexIndexMap>
class Distance_map
{
  double* m_distances;
  VertexIndexMap m_index;

public:
  typedef typename boost::property_traits<VertexIndexMap>::key_type key_type;
  typedef Indexed_distance value_type;
  typedef Indexed_distance reference;
  typedef boost::read_write_property_map_tag category;

  Distance_map(std::vector<double>& distances, VertexIndexMap index) : m_distances(distances.data()), m_index(index) {}

  friend value_type get(const Distance_map& map, const key_type& v)
  {
    using boost::get;
    const int i = int(get(map.m_index, v));
    return value_type{map.m_distances[i], i};
  }

  friend void put(const Distance_map& map, const key_type& v, const value_type& d)
  {
    using boost::get;
    map.m_distances[get(map.m_index, v)] = d.distance;
  }
};

typedef boost::typed_identity_property_map<int> Identity_map;

// A heap of vertices by their distances, which are in an array. The array of their positions in the heap holds -1 for
// those outside; whoever leaves vertices in the heap resets it.
class Distance_heap
  : public boost::d_ary_heap_indirect<int, 4, boost::iterator_property_map<int*, Identity_map>,
                                      Distance_map<Identity_map>, std::less<Indexed_distance>>
{
public:
  Distance_heap(std::vector<double>& distances, std::vector<int>& positions)
    : d_ary_heap_indirect(Distance_map<Identity_map>(distances, Identity_map()),
                          boost::make_iterator_property_map(positions.data(), Identity_map()))
  {}

  int extract_top()
  {
    const int v = top();
    pop();
    return v;
  }
};

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_DISTANCE_HEAP_H
