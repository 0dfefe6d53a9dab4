#include "pack.h"

#include "Progress_visitor.h"
#include "file_extension.h"
#include "given_layout.h"
#include "single_precision.h"
#include "surface_numbers.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/rotation_of.h>
#include <CGAL/Surface_mesh_cutting/internal/run/effort_of.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/symmetry_of.h>
#include <CGAL/Surface_mesh_cutting/pack_charts.h>

#include <chrono>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_cutting;

void add_packing(Phase_seconds& phases, double seconds)
{
  phases.packing = phases.packing.value_or(0) + seconds;
  phases.total = phases.total.value_or(0) + seconds;
}

// Where charts find no room.
std::string remedy(const Options& options)
{
  return std::string("; a larger --texture-size") + (options.texels_per_unit ? " or a smaller --texels-per-unit helps"
                                                                           : " or --uv-scale surface helps");
}

// The map may hold fewer digits than the UVs have: where that spoils them, they are repaired.
template <typename UVs>
SMC::Packing_result<Mesh> packed(const Mesh& mesh, Cut_map is_cut, UVs uvs, double given_scale, bool do_bijective,
                                 const Options& options)
{
  Progress_visitor visitor(options, {options.is_pack_only ? 0 : share_without_packing, 1});
  return SMC::pack_charts<CGAL::Parallel_if_available_tag>(
    mesh, is_cut, uvs,
    CGAL::parameters::margin(options.margin)
      .texture_size(options.texture_size)
      .texels_per_unit(options.texels_per_unit.value_or(0) / given_scale)
      .number_of_pages(options.most_pages.value_or(options.texels_per_unit ? 0 : 1))
      .chart_rotation(SMC::internal::rotation_of(options.rotate))
      .symmetry(SMC::internal::symmetry_of(options.symmetry))
      .do_bijective(do_bijective)
      .allow_flips(options.is_pack_only)
      .effort(SMC::internal::effort_of(options.effort))
      .visitor(std::ref(visitor)));
}

} // namespace

bool has_packing(const Options& options) { return options.uv_scale != "surface"; }

void pack(const Mesh& mesh, Cut_map is_cut, UV_map uvs, double given_scale, const Options& options, Outcome& outcome)
{
  if(!has_packing(options))
  {
    outcome.charts = number_of_charts(mesh, is_cut);
    outcome.uv_scale = 1;
    if(is_gltf(options.output))
      hold_in_single_precision(mesh, is_cut, uvs, is_injective(options), outcome);
    return;
  }
  const auto wall_start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  const bool is_single = is_gltf(options.output);
  // Those that the input brings may overlap, and do so in the result unless it is different charts that do.
  const bool do_bijective = options.is_pack_only ? !has_overlaps(mesh, is_cut, uvs) : is_injective(options);
  const auto packed_as = [&](auto map) { return packed(mesh, is_cut, map, given_scale, do_bijective, options); };
  auto result = is_single ? packed_as(Single_precision_uvs{uvs}) : packed_as(uvs);
  const bool is_spoiled = is_single && result.status.code == SMC::Status_code::NOT_CERTIFIED;
  if(is_spoiled)
    result = packed_as(uvs);
  add_packing(outcome.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count());
  add_packing(outcome.cpu_seconds, double(std::clock() - cpu_start) / CLOCKS_PER_SEC);
  if(!result.has_result)
  {
    const bool is_full = result.status.code == SMC::Status_code::INFEASIBLE_CONSTRAINTS;
    throw Failure(is_full ? Exit_code::UNSUPPORTED : Exit_code::FAILED,
                  result.status.message + (is_full ? remedy(options) : ""));
  }
  if(!result && outcome.exit_code == Exit_code::DONE)
  {
    outcome.exit_code = Exit_code::STOPPED;
    outcome.message = stop_reason() + " before the charts were packed best";
  }
  if(is_spoiled)
    hold_in_single_precision(mesh, is_cut, uvs, is_injective(options), outcome);
  outcome.charts = result.number_of_charts;
  outcome.uv_scale = result.scale * given_scale;
  outcome.texels_per_unit = *outcome.uv_scale * options.texture_size;
  outcome.fills = result.page_fills;
}
