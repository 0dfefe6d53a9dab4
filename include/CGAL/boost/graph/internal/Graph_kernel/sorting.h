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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SORTING_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SORTING_H

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::internal::Graph_kernel {

// Sorts values and keeps one of those that are equal.
template <typename Value>
void sort_unique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// Adds values, which may be there already; sorted, each once.
template <typename Value>
void add_unique(const std::vector<Value>& added, std::vector<Value>& values)
{
  values.insert(values.end(), added.begin(), added.end());
  sort_unique(values);
}

// The places of the keys from the smallest to the largest; equal ones keep their order.
inline std::vector<int> ascending_places(const std::vector<double>& keys)
{
  std::vector<int> places(keys.size());
  std::iota(places.begin(), places.end(), 0);
  std::stable_sort(places.begin(), places.end(), [&](int i, int j) { return keys[i] < keys[j]; });
  return places;
}

// Sorts values that can be constructed without arguments by the number that `key` gives to each; equal ones keep their
// order. Each type that `std::stable_sort` sorts costs every program another instance of all its algorithms, which are
// long where values hold arrays; here all types share one, and each value moves once.
template <typename Value, typename Key>
void sort_by_key(std::vector<Value>& values, const Key& key)
{
  std::vector<double> keys;
  keys.reserve(values.size());
  for(const Value& value : values)
    keys.push_back(key(value));
  const std::vector<int> places = ascending_places(keys);
  std::vector<Value> sorted(values.size());
  for(std::size_t i = 0; i < places.size(); ++i)
    sorted[i] = std::move(values[places[i]]);
  values.swap(sorted);
}

} // namespace CGAL::internal::Graph_kernel

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SORTING_H
