// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "conversions.h"

#include <CGAL/Surface_mesh_cutting/internal/soup/name_of_interpretation.h>

#include <string>

namespace binding {

namespace {

SMC::internal::Welding::Mode mode_of(const std::string& name)
{
  using SMC::internal::Welding;
  return name == "on" ? Welding::ON : name == "off" ? Welding::OFF : Welding::AUTO;
}

} // namespace

Surface_arguments read_surface_arguments(const Call& call)
{
  Surface_arguments arguments;
  arguments.soup.coordinates = read_array<double>(call, "points");
  arguments.soup.corners = read_array<std::int64_t>(call, "corners");
  arguments.soup.offsets = read_array<std::int64_t>(call, "offsets");
  arguments.mandatory_edges = read_array<std::int64_t>(call, "mandatory_edges");
  arguments.forbidden_edges = read_array<std::int64_t>(call, "forbidden_edges");
  arguments.initial_cut = read_array<std::int64_t>(call, "initial_cut");
  arguments.weighted_edges = read_array<std::int64_t>(call, "weighted_edges");
  arguments.edge_weights = read_array<double>(call, "edge_weights");
  arguments.has_weights = call.contains("edge_weights");
  arguments.terminals = read_array<std::int64_t>(call, "terminals");
  read(call, "strict", arguments.is_strict);
  std::string weld;
  read(call, "weld", weld);
  arguments.welding.mode = mode_of(weld);
  read(call, "weld_tolerance", arguments.welding.tolerance);
  return arguments;
}

py::array_t<std::int64_t> to_array(const std::vector<std::size_t>& indices)
{
  return to_array(std::vector<std::int64_t>(indices.begin(), indices.end()));
}

py::array_t<std::int64_t> to_array(const std::vector<Edge>& edges)
{
  std::vector<std::int64_t> result;
  result.reserve(2 * edges.size());
  for(const auto& [a, b] : edges)
    result.insert(result.end(), {std::int64_t(a), std::int64_t(b)});
  return to_array(std::move(result), 2);
}

py::array_t<double> to_array(const std::vector<SMC::Trade_off>& trade_offs)
{
  std::vector<double> result;
  for(const SMC::Trade_off& t : trade_offs)
    result.insert(result.end(), {t.cut_length, t.cut_cost, t.average_distortion});
  return to_array(std::move(result), 3);
}

py::dict to_dict(const Finding& finding)
{
  py::dict result;
  result["status"] = SMC::to_string(finding.code);
  result["message"] = finding.message;
  if(!finding.edges.empty())
  {
    result["kind"] = "edges";
    result["elements"] = to_array(finding.edges);
    return result;
  }
  const bool has_vertices = !finding.vertices.empty();
  result["kind"] = has_vertices ? "vertices" : finding.faces.empty() ? "" : "faces";
  result["elements"] = to_array(has_vertices ? finding.vertices : finding.faces);
  return result;
}

py::list to_list(const std::vector<Finding>& findings)
{
  py::list result;
  for(const Finding& finding : findings)
    result.append(to_dict(finding));
  return result;
}

py::list to_list(const std::vector<SMC::Interpretation>& interpreted)
{
  py::list result;
  for(const SMC::Interpretation& reading : interpreted)
  {
    std::vector<Edge> edges;
    for(const auto& edge : reading.edges)
      edges.emplace_back(edge[0], edge[1]);
    py::dict entry;
    entry["what"] = SMC::internal::name_of(reading.kind);
    entry["elements"] = !edges.empty() ? to_array(edges)
                                       : to_array(reading.vertices.empty() ? reading.polygons : reading.vertices);
    result.append(std::move(entry));
  }
  return result;
}

py::dict to_dict(const SMC::Phase_times& times, double packing)
{
  py::dict result;
  result["candidates"] = times.candidates;
  result["filter"] = times.filter;
  result["connect"] = times.connect;
  result["refine"] = times.refine;
  result["parameterize"] = times.parameterize;
  result["packing"] = packing;
  result["total"] = times.total;
  return result;
}

void add_status(const Result_status& status, py::dict& result)
{
  result["finding"] = to_dict(status);
  result["warnings"] = to_list(status.warnings);
}

} // namespace binding
