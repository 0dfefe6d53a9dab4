#include "json_report.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <sys/resource.h>

namespace {

using Json = nlohmann::ordered_json;

template <typename Value>
Json to_json(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json();
}

Json to_json(const std::optional<double>& value)
{
  return value && std::isfinite(*value) ? Json(*value) : Json();
}

Json to_json(const Phase_seconds& seconds)
{
  return {{"candidates", to_json(seconds.candidates)}, {"filter", to_json(seconds.filter)},
          {"connect", to_json(seconds.connect)},       {"refine", to_json(seconds.refine)},
          {"parameterize", to_json(seconds.parameterize)}, {"packing", to_json(seconds.packing)},
          {"total", to_json(seconds.total)}};
}

Json to_json(const CGAL::Surface_mesh_cutting::Phase_counts& counts)
{
  return {{"candidates", counts.candidates}, {"filter", counts.filter},
          {"connect", counts.connect},       {"refine", counts.refine},
          {"parameterize", counts.parameterize}, {"total", counts.total}};
}

Json to_json(const Witness& witness)
{
  switch(witness.kind)
  {
    case Witness::Kind::VERTICES: return {{"kind", "vertices"}, {"indices", witness.indices}};
    case Witness::Kind::EDGES: return {{"kind", "edges"}, {"indices", witness.indices}};
    case Witness::Kind::FACES: return {{"kind", "faces"}, {"indices", witness.indices}};
    case Witness::Kind::NONE: break;
  }
  return nullptr;
}

Json to_json(const std::vector<Interpretation>& interpreted)
{
  Json result = Json::array();
  for(const Interpretation& i : interpreted)
    result.push_back({{"what", i.what},
                      {"count", i.count()},
                      {"elements", i.edges.empty() ? Json(i.elements) : Json(i.edges)}});
  return result;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json quantiles_to_json(const std::vector<std::array<double, 2> >& quantiles)
{
  Json object = Json::object();
  for(const auto& [share, energy] : quantiles)
    object[share == 1 ? std::string("1") : Json(share).dump()] = number(energy);
  return object;
}

Json charts_to_json(const std::vector<CGAL::Surface_mesh_cutting::Chart_distortion>& charts)
{
  Json list = Json::array();
  for(const CGAL::Surface_mesh_cutting::Chart_distortion& chart : charts)
    list.push_back({{"mean", number(chart.average)}, {"max", number(chart.largest)}, {"faces", chart.number_of_faces}});
  return list;
}

// The columns of the parameterization benchmark.
Json to_json(const std::optional<CGAL::Surface_mesh_cutting::Distortion_measures>& measures)
{
  if(!measures)
    return nullptr;
  return {{"max_area_distortion", number(measures->largest_area_distortion)},
          {"average_area_discrepancy", number(measures->average_area_discrepancy)},
          {"min_singular_value", number(measures->smallest_singular_value)},
          {"max_singular_value", number(measures->largest_singular_value)},
          {"proportion_flipped_triangles", number(measures->proportion_of_flipped_faces)},
          {"max_angle_distortion", number(measures->largest_angle_distortion)},
          {"average_angle_discrepancy", number(measures->average_angle_discrepancy)},
          {"resolution", number(measures->resolution)},
          {"symmetric_dirichlet_energy", number(measures->symmetric_Dirichlet_energy / 2)},
          {"mesh_cut_length", number(measures->cut_length)},
          {"overlaps", to_json(measures->overlaps)}};
}

Json to_json(const std::optional<CGAL::Surface_mesh_cutting::Seam_measures>& measures)
{
  if(!measures)
    return nullptr;
  return {{"jaggedness", to_json(measures->jaggedness)},
          {"compactness", number(measures->compactness)},
          {"convexity", number(measures->convexity)},
          {"on_hard_edges", to_json(measures->on_hard_edges)},
          {"hidden", to_json(measures->hidden)}};
}

Json to_json(const std::optional<CGAL::Surface_mesh_cutting::Reflection_plane>& plane)
{
  if(!plane)
    return nullptr;
  return {{"normal", plane->normal}, {"offset", plane->offset}, {"matched", plane->matched}};
}

double peak_memory_in_megabytes()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024; // given in kilobytes
}

} // namespace

const char* name_of(Exit_code code)
{
  switch(code)
  {
    case Exit_code::DONE: return "done";
    case Exit_code::USAGE: return "usage";
    case Exit_code::UNREADABLE: return "unreadable";
    case Exit_code::UNSUPPORTED: return "unsupported";
    case Exit_code::FAILED: return "failed";
    case Exit_code::STOPPED: return "stopped";
    case Exit_code::BOUND_NOT_REACHED: return "bound_not_reached";
  }
  return "";
}

std::string to_json(const Outcome& outcome)
{
  const Json report = {
    {"status", name_of(outcome.exit_code)},
    {"message", outcome.message},
    {"warnings", outcome.warnings},
    {"witness", to_json(outcome.witness)},
    {"vertices", to_json(outcome.vertices)},
    {"faces", to_json(outcome.faces)},
    {"polygons", to_json(outcome.polygons)},
    {"interpreted", to_json(outcome.interpreted)},
    {"components", to_json(outcome.components)},
    {"genus", to_json(outcome.genus)},
    {"borders", to_json(outcome.borders)},
    {"candidates", to_json(outcome.candidates)},
    {"features", to_json(outcome.features)},
    {"auxiliary", to_json(outcome.auxiliary)},
    {"cut_length", to_json(outcome.cut_length)},
    {"cut_cost", to_json(outcome.cut_cost)},
    {"cut_lower_bound", to_json(outcome.lower_bound)},
    {"optimal", to_json(outcome.is_optimal)},
    {"E_iso", to_json(outcome.average_energy)},
    {"E_max", to_json(outcome.maximum_energy)},
    {"E_quantiles", quantiles_to_json(outcome.energy_quantiles)},
    {"charts_distortion", charts_to_json(outcome.chart_energies)},
    {"flips", to_json(outcome.flips)},
    {"overlaps", to_json(outcome.overlaps)},
    {"charts", to_json(outcome.charts)},
    {"uv_scale", to_json(outcome.uv_scale)},
    {"fill", outcome.fills.size() > 1 ? Json(outcome.fills) : to_json(outcome.mean_fill())},
    {"pages", outcome.fills.empty() ? Json() : Json(outcome.fills.size())},
    {"texels_per_unit", to_json(outcome.texels_per_unit)},
    {"stacked", to_json(outcome.stacked)},
    {"distortion", to_json(outcome.distortion)},
    {"seams", to_json(outcome.seams)},
    {"symmetry", to_json(outcome.symmetry)},
    {"tradeoff", outcome.trade_offs},
    {"seconds", to_json(outcome.seconds)},
    {"cpu_seconds", to_json(outcome.cpu_seconds)},
    {"factorized_unknowns", to_json(outcome.factorized_unknowns)},
    {"threads", to_json(outcome.threads)},
    {"seed", to_json(outcome.seed)},
    {"effort", to_json(outcome.effort)},
    {"solver", to_json(outcome.solver)},
    {"peak_memory_mb", peak_memory_in_megabytes()}};
  // File names need not be UTF-8.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
