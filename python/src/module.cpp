// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// The extension module, which the functions in Python call with arguments that they have checked.

#include "connect.h"
#include "conversions.h"
#include "cut_surface.h"
#include "find_steiner_tree.h"
#include "pack.h"
#include "supervise.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/rotation_of.h>
#include <CGAL/Surface_mesh_cutting/internal/run/effort_of.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/symmetry_of.h>

#include <optional>
#include <string>
#include <utility>

namespace {

using namespace binding;

SMC::Connection connection_of(const std::string& name)
{
  return name == "metric_closure" ? SMC::Connection::METRIC_CLOSURE
       : name == "shortest_path_heuristic" ? SMC::Connection::SHORTEST_PATH_HEURISTIC
       : name == "greedy" ? SMC::Connection::GREEDY
       : name == "exact" ? SMC::Connection::EXACT : SMC::Connection::BEST;
}

std::string read_name(const Call& call, const char* key)
{
  std::string name;
  read(call, key, name);
  return name;
}

Cutting_options read_cutting_options(const Call& call)
{
  Cutting_options options;
  options.effort = SMC::internal::effort_of(read_name(call, "effort"));
  options.connection = connection_of(read_name(call, "connection"));
  read(call, "faithful", options.use_published_method);
  read(call, "bijective", options.do_bijective);
  read(call, "maximum_average_distortion", options.maximum_average_distortion);
  read(call, "maximum_face_distortion", options.maximum_face_distortion);
  read(call, "face_distortion_quantile", options.face_distortion_quantile);
  read(call, "maximum_chart_distortion", options.maximum_chart_distortion);
  read(call, "minimum_distortion_decrease", options.minimum_distortion_decrease);
  read(call, "minimum_length_decrease", options.minimum_length_decrease);
  read(call, "minimum_area_ratio", options.minimum_area_ratio);
  read(call, "influence_threshold", options.influence_threshold);
  read(call, "forbidden_radius", options.forbidden_radius);
  read(call, "maximum_number_of_states", options.maximum_number_of_states);
  read(call, "seed", options.random_seed);
  options.symmetry = SMC::internal::symmetry_of(read_name(call, "symmetry"));
  if(call.contains("seam_smoothness"))
    read(call, "seam_smoothness", options.seam_smoothness.emplace());
  const std::string output = read_name(call, "output");
  options.output = output == "features" ? Output_kind::FEATURES : output == "cut" ? Output_kind::CUT : Output_kind::MAP;
  return options;
}

Packing_options read_packing_options(const Call& call)
{
  Packing_options options;
  read(call, "margin", options.margin);
  read(call, "texture_size", options.texture_size);
  options.effort = SMC::internal::effort_of(read_name(call, "effort"));
  options.rotation = SMC::internal::rotation_of(read_name(call, "rotate"));
  options.symmetry = SMC::internal::symmetry_of(read_name(call, "symmetry"));
  read(call, "texels_per_unit", options.texels_per_unit);
  read(call, "pages", options.pages);
  return options;
}

bool is_bijective(const Call& call)
{
  bool result = true;
  read(call, "bijective", result);
  return result;
}

py::tuple to_tuple(const std::vector<double>& numbers)
{
  py::list result;
  for(const double number : numbers)
    result.append(number);
  return py::tuple(result);
}

py::object to_object(const std::optional<SMC::Reflection_plane>& plane)
{
  if(!plane)
    return py::none();
  return py::make_tuple(py::make_tuple(plane->normal[0], plane->normal[1], plane->normal[2]), plane->offset, plane->matched);
}

py::dict describe(Cut_surface surface)
{
  const SMC::Unwrap_soup_result& found = surface.found;
  py::dict result;
  add_status(found.status, result);
  result["has_result"] = found.has_result;
  result["interpreted"] = to_list(found.interpreted);
  result["components"] = found.components;
  result["genus"] = found.genus;
  result["borders"] = found.borders;
  result["number_of_candidates"] = found.number_of_candidates;
  result["number_of_auxiliary_points"] = found.number_of_auxiliary_points;
  result["feature_points"] = to_array(found.feature_points);
  result["bounding_box_diagonal"] = found.bounding_box_diagonal;
  result["cut_edges"] = to_array(surface.cut_edges);
  result["cut_length"] = found.cut_length;
  result["cut_cost"] = found.cut_cost;
  result["lower_bound"] = found.lower_bound ? py::object(py::float_(*found.lower_bound)) : py::none();
  result["is_optimal"] = found.is_optimal ? py::object(py::bool_(*found.is_optimal)) : py::none();
  result["trade_offs"] = to_array(found.trade_offs);
  result["symmetry"] = to_object(found.symmetry);
  result["seconds"] = to_dict(surface.profile.seconds, surface.packing_seconds);
  result["cpu_seconds"] = to_dict(surface.profile.cpu_seconds, surface.packing_cpu_seconds);
  result["average_distortion"] = found.average_distortion;
  result["largest_face_distortion"] = found.largest_face_distortion;
  py::dict quantiles;
  for(const auto& [share, energy] : found.distortion_quantiles)
    quantiles[py::float_(share)] = energy;
  result["distortion_quantiles"] = quantiles;
  py::list charts;
  for(const CGAL::Surface_mesh_cutting::Chart_distortion& chart : found.charts)
    charts.append(py::dict(py::arg("mean") = chart.average, py::arg("max") = chart.largest,
                           py::arg("faces") = chart.number_of_faces));
  result["charts_distortion"] = charts;
  result["number_of_charts"] = surface.number_of_charts;
  result["uv_scale"] = surface.uv_scale;
  result["fill"] = surface.fill ? py::object(py::float_(*surface.fill)) : py::none();
  result["page_fills"] = to_tuple(surface.page_fills);
  result["uv"] = to_array(std::move(surface.map.uv), 2);
  result["uv_corners"] = to_array(std::move(surface.map.corners));
  result["uv_points"] = to_array(std::move(surface.map.points));
  return result;
}

py::dict cut(const Call& call)
{
  const Surface_arguments arguments = read_surface_arguments(call);
  const Cutting_options options = read_cutting_options(call);
  std::optional<Packing_options> packing;
  if(call.contains("margin"))
    packing = read_packing_options(call);
  Cut_surface surface;
  const bool was_interrupted = supervise(
    call, [&](Run_monitor& monitor) { surface = cut_surface(arguments, options, packing, monitor); });
  py::dict result = describe(std::move(surface));
  result["was_interrupted"] = was_interrupted;
  return result;
}

py::dict describe(const Found_cut& found, bool was_interrupted)
{
  py::dict result;
  add_status(found.status, result);
  result["has_result"] = found.has_result;
  result["was_interrupted"] = was_interrupted;
  result["interpreted"] = to_list(found.interpreted);
  result["cut_edges"] = to_array(found.cut_edges);
  result["cut_length"] = found.length;
  return result;
}

py::dict connect(const Call& call)
{
  const Surface_arguments arguments = read_surface_arguments(call);
  Connection_options options;
  options.connection = connection_of(read_name(call, "connection"));
  read(call, "maximum_number_of_states", options.maximum_number_of_states);
  Connected_points found;
  const bool was_interrupted = supervise(
    call, [&](Run_monitor& monitor) { found = connect_points(arguments, options, monitor); });
  py::dict result = describe(found, was_interrupted);
  result["lower_bound"] = found.lower_bound;
  result["is_optimal"] = found.is_optimal;
  result["number_of_auxiliary_points"] = found.number_of_auxiliary_points;
  return result;
}

py::dict find_handles(const Call& call)
{
  const Surface_arguments arguments = read_surface_arguments(call);
  Cut_handles found;
  const bool was_interrupted
    = supervise(call, [&](Run_monitor& monitor) { found = cut_handles(arguments, monitor); });
  py::dict result = describe(found, was_interrupted);
  py::list loops;
  for(std::vector<std::int64_t>& loop : found.loops)
    loops.append(to_array(std::move(loop)));
  result["loops"] = loops;
  return result;
}

py::dict pack_charts(const Call& call)
{
  const Surface_arguments arguments = read_surface_arguments(call);
  const Numbers corner_uv = read_array<double>(call, "corner_uv");
  const Packing_options options = read_packing_options(call);
  const bool do_bijective = is_bijective(call);
  Packed_surface packed;
  const bool was_interrupted = supervise(call, [&](Run_monitor& monitor)
                                         { packed = pack_surface(arguments, corner_uv, options, do_bijective, monitor); });
  py::dict result;
  add_status(packed.status, result);
  result["has_result"] = packed.has_result;
  result["was_interrupted"] = was_interrupted;
  result["corner_uv"] = to_array(std::move(packed.corner_uv), 2);
  result["scale"] = packed.scale;
  result["fill"] = packed.fill;
  result["page_fills"] = to_tuple(packed.page_fills);
  result["number_of_charts"] = packed.number_of_charts;
  return result;
}

py::dict certify(const Call& call)
{
  const Surface_arguments arguments = read_surface_arguments(call);
  const Numbers corner_uv = read_array<double>(call, "corner_uv");
  const bool do_bijective = is_bijective(call);
  Result_status status;
  py::dict result;
  result["was_interrupted"]
    = supervise(call, [&](Run_monitor&) { status = certify_surface(arguments, corner_uv, do_bijective); });
  add_status(status, result);
  return result;
}

Steiner_options read_steiner_options(const Call& call)
{
  using Method = CGAL::internal::Steiner_tree::Method;
  Steiner_options result;
  const std::string method = read_name(call, "method");
  result.options.method = method == "metric_closure" ? Method::metric_closure
                        : method == "shortest_path_heuristic" ? Method::shortest_path_heuristic
                        : method == "greedy" ? Method::greedy_auxiliary_points
                        : method == "local_search" ? Method::local_search : Method::exact;
  result.needs_proof = method == "exact";
  read(call, "minimum_length_decrease", result.options.minimum_length_decrease);
  read(call, "maximum_number_of_states", result.options.maximum_number_of_states);
  return result;
}

py::dict describe(Steiner_outcome outcome)
{
  py::dict result = to_dict(Finding());
  switch(outcome)
  {
  case Steiner_outcome::OK:
    break;
  case Steiner_outcome::TERMINALS_NOT_CONNECTED:
    result["status"] = "terminals_not_connected";
    result["message"] = "terminals lie in several components of the graph";
    break;
  case Steiner_outcome::BUDGET_EXCEEDED:
    result["status"] = "bound_not_reached";
    result["message"] = "the budget does not suffice to prove that the tree is shortest";
    break;
  case Steiner_outcome::STOPPED:
    result["status"] = "stopped";
    result["message"] = "the search was ended; the tree is the best found by then";
    break;
  }
  return result;
}

py::dict connect_terminals(const Call& call)
{
  Graph_view graph{};
  read(call, "number_of_vertices", graph.number_of_vertices);
  graph.edges = read_array<std::int64_t>(call, "edges");
  graph.weights = read_array<double>(call, "weights");
  const Indices terminals = read_array<std::int64_t>(call, "terminals");
  const Steiner_options options = read_steiner_options(call);
  Steiner_result found;
  py::dict result;
  result["was_interrupted"]
    = supervise(call, [&](Run_monitor& monitor) { found = find_steiner_tree(graph, terminals, options, monitor); });
  result["finding"] = describe(found.outcome);
  result["has_result"] = found.outcome != Steiner_outcome::TERMINALS_NOT_CONNECTED;
  result["edges"] = to_array(std::move(found.edges));
  result["length"] = found.length;
  result["lower_bound"] = found.lower_bound;
  result["is_optimal"] = found.is_optimal;
  result["number_of_auxiliary_points"] = found.number_of_auxiliary_points;
  return result;
}

} // namespace

PYBIND11_MODULE(_extension, module)
{
  module.doc() = "What the functions of surface_mesh_cutting call. Each takes a dict of checked arguments.";
  module.attr("__version__") = SURFACE_MESH_CUTTING_VERSION;
  module.def("cut", &cut);
  module.def("connect", &connect);
  module.def("find_handles", &find_handles);
  module.def("pack_charts", &pack_charts);
  module.def("certify", &certify);
  module.def("connect_terminals", &connect_terminals);
  module.def("stop_all_calls", &stop_all_calls);
  module.def("forget_calls", &forget_calls);
}
