// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Arguments and results between Python and C++.

#ifndef SURFACE_MESH_CUTTING_PYTHON_CONVERSIONS_H
#define SURFACE_MESH_CUTTING_PYTHON_CONVERSIONS_H

#include "Named_surface.h"
#include "array_views.h"

#include <CGAL/Surface_mesh_cutting/Run_profile.h>
#include <CGAL/Surface_mesh_cutting/Trade_off.h>
#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace binding {

namespace py = pybind11;

// What a function was called with: names and values, which the functions in Python have checked.
using Call = py::dict;

// Changes `value` if the caller gave it.
template <typename T>
void read(const Call& call, const char* name, T& value)
{
  if(call.contains(name))
    value = call[name].cast<T>();
}

// The numbers of an array, which the call keeps alive; none if it is not given.
template <typename T>
Array_view<T> read_array(const Call& call, const char* name)
{
  if(!call.contains(name))
    return {};
  const py::object array = call[name];
  if(!py::isinstance<py::array_t<T, py::array::c_style> >(array))
    throw py::type_error(std::string(name) + " is not an array of the type that is expected");
  const auto numbers = py::reinterpret_borrow<py::array_t<T, py::array::c_style> >(array);
  return {numbers.data(), numbers.data() + numbers.size()};
}

Surface_arguments read_surface_arguments(const Call& call);

// An array with one or two columns that takes over the numbers without a copy.
template <typename T>
py::array_t<T> to_array(std::vector<T> values, py::ssize_t columns = 1)
{
  auto held = std::make_unique<std::vector<T> >(std::move(values));
  const T* const data = held->data();
  std::vector<py::ssize_t> shape{py::ssize_t(held->size()) / columns};
  if(columns > 1)
    shape.push_back(columns);
  const py::capsule owner(held.get(), [](void* vector) { delete static_cast<std::vector<T>*>(vector); });
  held.release();
  return py::array_t<T>(std::move(shape), data, owner);
}

py::array_t<std::int64_t> to_array(const std::vector<std::size_t>& indices);
py::array_t<std::int64_t> to_array(const std::vector<Edge>& edges);

py::dict to_dict(const Finding& finding);
// `packing` is the time of a phase that the library counts in the total only.
py::dict to_dict(const SMC::Phase_times& times, double packing);
py::list to_list(const std::vector<Finding>& findings);
py::list to_list(const std::vector<SMC::Interpretation>& interpreted);
py::array_t<double> to_array(const std::vector<SMC::Trade_off>& trade_offs); // one row each

// Adds what all results say about how the run ended.
void add_status(const Result_status& status, py::dict& result);

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_CONVERSIONS_H
