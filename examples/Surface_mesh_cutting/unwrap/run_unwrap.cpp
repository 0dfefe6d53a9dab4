#include "run_unwrap.h"

#include "Constraints.h"
#include "Progress_visitor.h"
#include "Stacking.h"
#include "divide_at_plane.h"
#include "divide_long_charts.h"
#include "given_layout.h"
#include "make_layout.h"
#include "pack.h"
#include "pages.h"
#include "stop_request.h"
#include "summary.h"
#include "surface_numbers.h"

#include <CGAL/Default.h>
#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Surface_mesh_cutting/distortion_report.h>
#include <CGAL/Surface_mesh_cutting/internal/run/effort_of.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/coincident_vertices_warning.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/symmetry_of.h>
#include <CGAL/Surface_mesh_cutting/seam_report.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>
#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif
#include <Eigen/SparseCholesky>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/info.h>
#endif

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>

namespace {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Status_code;
using Result = SMC::Unwrap_result<Mesh>;

Exit_code exit_code_of(Status_code code)
{
  switch(code)
  {
    case Status_code::OK: return Exit_code::DONE;
    case Status_code::WRONG_PARAMETER: return Exit_code::USAGE;
    case Status_code::EMPTY_MESH:
    case Status_code::NOT_TRIANGULATED:
    case Status_code::NON_MANIFOLD:
    case Status_code::INVALID_POINT:
    case Status_code::INFEASIBLE_CONSTRAINTS: return Exit_code::UNSUPPORTED;
    case Status_code::NOT_CUT_TO_DISKS:
    case Status_code::NUMERICAL_FAILURE:
    case Status_code::NOT_CERTIFIED: return Exit_code::FAILED;
    case Status_code::STOPPED: return Exit_code::STOPPED;
    case Status_code::BOUND_NOT_REACHED: return Exit_code::BOUND_NOT_REACHED;
  }
  return Exit_code::FAILED;
}

Witness witness_of(const SMC::Finding<Mesh>& finding, const Surface& surface)
{
  Witness witness;
  for(const Vertex v : finding.vertices)
    witness.indices.push_back(surface.vertices[v]);
  for(const Face f : finding.faces)
    witness.indices.push_back(surface.polygons[f]);
  for(const Edge e : finding.edges)
    for(const int i : {0, 1})
      witness.indices.push_back(surface.vertices[surface.mesh.vertex(e, unsigned(i))]);
  witness.kind = !finding.vertices.empty() ? Witness::Kind::VERTICES
               : !finding.faces.empty() ? Witness::Kind::FACES
               : !finding.edges.empty() ? Witness::Kind::EDGES : Witness::Kind::NONE;
  return witness;
}

// The library counts elements of the mesh; where that is not like the soup, the message names those of the soup.
std::string message_of(const SMC::Finding<Mesh>& finding, const Surface& surface, bool is_like_soup)
{
  const Witness witness = witness_of(finding, surface);
  const std::size_t names = finding.message.rfind(": ");
  if(is_like_soup || witness.indices.empty() || names == std::string::npos)
    return finding.message;
  constexpr std::size_t maximum = 5;
  const bool is_edge = witness.kind == Witness::Kind::EDGES;
  const std::size_t count = witness.indices.size() / (is_edge ? 2 : 1);
  std::string text = finding.message.substr(0, finding.message.find(' ', names + 2));
  for(std::size_t i = 0; i < (std::min)(count, maximum); ++i)
    text += (i == 0 ? " " : ", ")
            + (is_edge ? std::to_string(witness.indices[2 * i]) + "-" + std::to_string(witness.indices[2 * i + 1])
                       : std::to_string(witness.indices[i]));
  return count > maximum ? text + " and " + std::to_string(count - maximum) + " more" : text;
}

Phase_seconds phase_seconds(const SMC::Phase_times& times)
{
  return {times.candidates, times.filter, times.connect, times.refine, times.parameterize,
          std::nullopt, times.total};
}

// Whether a cut is shorter and its map less distorted than those of another one, or one of both, the other being equal.
bool is_better(const std::array<double, 2>& cut, const std::array<double, 2>& other)
{
  return cut != other && cut[0] <= other[0] && cut[1] <= other[1];
}

// Without cuts that another one is better than; the result stays, as it is by its cost that it may be best.
std::vector<std::array<double, 2> > best_trade_offs(const Result& result)
{
  std::vector<std::array<double, 2> > all, best;
  for(const SMC::Trade_off& t : result.trade_offs)
    all.push_back({{t.cut_length / result.bounding_box_diagonal, t.average_distortion}});
  for(std::size_t i = 0; i < all.size(); ++i)
  {
    const SMC::Trade_off& t = result.trade_offs[i];
    const bool is_result = t.cut_length == result.cut_length && t.average_distortion == result.average_distortion;
    if(is_result || std::none_of(all.begin(), all.end(), [&](const auto& other) { return is_better(other, all[i]); }))
      best.push_back(all[i]);
  }
  return best;
}

// Whether all that it names are points that only repeat others with another color.
bool is_about_repeated_points(const SMC::Finding<Mesh>& finding, const Surface& surface, const Polygon_soup& soup)
{
  const auto is_repeated = [&](Vertex v)
  { return soup.originals[std::size_t(surface.vertices[v])] != surface.vertices[v]; };
  return !soup.originals.empty() && !finding.vertices.empty() &&
         std::all_of(finding.vertices.begin(), finding.vertices.end(), is_repeated);
}

void tell(const Result& result, const Surface& surface, const Polygon_soup& soup, Outcome& outcome)
{
  const bool is_like_soup = surface.is_like_soup(soup);
  outcome.exit_code = exit_code_of(result.status.code);
  outcome.message = outcome.exit_code == Exit_code::STOPPED ? stop_reason()
                                                           : message_of(result.status, surface, is_like_soup);
  outcome.witness = witness_of(result.status, surface);
  for(const SMC::Finding<Mesh>& warning : result.status.warnings)
    if(warning.message.rfind(SMC::internal::coincident_vertices_warning, 0) != 0 && // reading the surface has told more
       !is_about_repeated_points(warning, surface, soup))
      outcome.warnings.push_back(message_of(warning, surface, is_like_soup));
  outcome.has_result = result.has_result;

  outcome.components = result.components;
  outcome.genus = result.genus;
  outcome.borders = result.borders;
  if(result.symmetry)
    outcome.symmetry = result.symmetry;
  if(!outcome.has_result)
  {
    if(outcome.exit_code == Exit_code::STOPPED)
      outcome.message += " before there was a layout; --effort fast takes least time";
    return;
  }
  outcome.candidates = result.number_of_candidates;
  outcome.features = int(result.feature_points.size());
  outcome.auxiliary = result.number_of_auxiliary_points;
  outcome.cut_length = result.cut_length / result.bounding_box_diagonal;
  if(outcome.has_weights)
    outcome.cut_cost = result.cut_cost / result.bounding_box_diagonal;
  if(result.lower_bound)
    outcome.lower_bound = *result.lower_bound / result.bounding_box_diagonal;
  outcome.is_optimal = result.is_optimal;
  outcome.average_energy = result.average_distortion;
  outcome.maximum_energy = result.largest_face_distortion;
  outcome.energy_quantiles = result.distortion_quantiles;
  outcome.chart_energies = result.charts;
  outcome.flips = result.flips;
  outcome.overlaps = result.overlaps;
  outcome.trade_offs = best_trade_offs(result);
}

// Once the charts are packed.
void tell_summary(const Options& options, Outcome& outcome)
{
  if(outcome.message.empty())
    outcome.message = summary(outcome);
  else if(outcome.exit_code == Exit_code::STOPPED)
    outcome.message += "; the best result so far is written: " + summary(outcome);
  for(const std::optional<std::string>& warning : {warning_of_many_charts(outcome, options.weld),
                                                   warning_of_empty_pages(outcome, options.least_fill)})
    if(warning)
      outcome.warnings.push_back(*warning);
}

SMC::Connection connection_of(const std::string& name)
{
  return name == "mst" ? SMC::Connection::METRIC_CLOSURE
       : name == "sph" ? SMC::Connection::SHORTEST_PATH_HEURISTIC
       : name == "greedy" ? SMC::Connection::GREEDY
       : name == "exact" ? SMC::Connection::EXACT : SMC::Connection::BEST;
}

template <typename Solver>
Result run_library(const Mesh& mesh, const Options& options, const Constraints& constraints, Progress_visitor& visitor,
                   Cut_map is_cut, UV_map uvs, Solver solver)
{
  const auto parameters
    = CGAL::parameters::visitor(std::ref(visitor))
      .random_seed(options.seed)
      .effort(SMC::internal::effort_of(options.effort))
      .use_published_method(options.is_faithful)
      .symmetry(SMC::internal::symmetry_of(options.symmetry))
      .seam_smoothness(options.seam_smoothness)
      .do_bijective(is_injective(options))
      .connection(connection_of(options.connect.value_or(options.is_faithful ? "greedy" : "best")))
      .maximum_average_distortion(options.maximum_average_distortion.value_or(std::numeric_limits<double>::infinity()))
      .maximum_face_distortion(options.maximum_face_distortion.value_or(std::numeric_limits<double>::infinity()))
      .face_distortion_quantile(options.face_quantile)
      .maximum_chart_distortion(options.maximum_chart_distortion.value_or(std::numeric_limits<double>::infinity()))
      .minimum_distortion_decrease(options.eps_iso.value_or(0.01))
      .minimum_length_decrease(options.eps_len.value_or(0.01))
      .minimum_area_ratio(options.alpha.value_or(0.1))
      .influence_threshold(options.beta.value_or(20))
      .edge_is_constrained_map(constraints.must_be_cut)
      .edge_is_forbidden_map(constraints.must_not_be_cut)
      .initial_cut_map(constraints.is_initially_cut)
      .vertex_is_constrained_map(constraints.is_terminal)
      .sparse_linear_solver(solver);
  // With one thread, Parallel_tag is the sequential algorithm.
  using Tag = CGAL::Parallel_if_available_tag;
  return constraints.weights
           ? SMC::unwrap<Tag>(mesh, is_cut, uvs, parameters.edge_weight_map(*constraints.weights))
           : SMC::unwrap<Tag>(mesh, is_cut, uvs, parameters);
}

Result run_library(const Mesh& mesh, const Options& options, const Constraints& constraints, Progress_visitor& visitor,
                   Cut_map is_cut, UV_map uvs)
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Simplicial = Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int> >; // unknowns come ordered
  const auto run = [&](auto solver) { return run_library(mesh, options, constraints, visitor, is_cut, uvs, solver); };
  if(options.solver == "eigen")
    return run(CGAL::Eigen_solver_traits<Simplicial>());
#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
  if(options.solver == "cholmod")
    return run(CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Matrix> >());
#endif
  return run(CGAL::Default());
}

} // namespace

std::vector<std::string> available_solvers()
{
#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
  return {"supernodal", "eigen", "cholmod"};
#else
  return {"supernodal", "eigen"};
#endif
}

int available_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  return tbb::info::default_concurrency();
#else
  return 1;
#endif
}

namespace {

// The surface that is cut and mapped: the whole, or one of each kind of its parts.
struct Work
{
  Surface& surface;
  Cut_map is_cut;
  UV_map uvs;

  explicit Work(Surface& surface)
    : surface(surface), is_cut(surface.mesh.add_property_map<Edge, bool>("e:is_cut", false).first),
      uvs(surface.mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first)
  {}
};

// The library's result, without much in it where the layout is given. Tells `outcome` about it.
Result find_layout(const Polygon_soup& soup, Surface& surface, Stacking* stacking, const Options& options, Work& work,
                   Outcome& outcome)
{
  if(options.is_pack_only)
  {
    read_given_layout(soup, surface, work.is_cut, work.uvs);
    outcome.has_result = true;
    return Result();
  }
  Constraints constraints = read_constraints(options, soup, surface);
  outcome.warnings.insert(outcome.warnings.end(), constraints.warnings.begin(), constraints.warnings.end());
  if(stacking != nullptr)
    constraints = stacking->constraints_of_originals(constraints);
  Progress_visitor visitor(options, {0, has_packing(options) ? share_without_packing : 1});
  const Result result = run_library(work.surface.mesh, options, constraints, visitor, work.is_cut, work.uvs);
  tell(result, work.surface, soup, outcome);
  outcome.seconds = phase_seconds(visitor.profile().seconds);
  outcome.cpu_seconds = phase_seconds(visitor.profile().cpu_seconds);
  outcome.factorized_unknowns = visitor.profile().factorized_unknowns;
  if(stacking != nullptr)
    tell_numbers(surface.mesh, outcome);
  return result;
}

// Halves that are mirror images are stacked, too: nothing more has to be mirrored then.
void stack(const Surface& surface, Options& options, std::optional<Stacking>& stacking, Outcome& outcome)
{
  const std::optional<Division> division = divide_at_plane(surface.mesh, SMC::internal::symmetry_of(options.symmetry));
  stacking.emplace(surface, options.stack_tolerance, division);
  outcome.stacked = stacking->stacks();
  if(!stacking->has_copies())
    stacking.reset();
  else if(division)
  {
    options.symmetry = "off";
    outcome.symmetry = division->plane;
  }
}

void add_feature_points(const Result& result, const Surface& surface, Layout& layout)
{
  std::vector<int>& features = layout.feature_points;
  for(const Vertex v : result.feature_points)
    features.push_back(surface.vertices[v]);
  std::sort(features.begin(), features.end());
  features.erase(std::unique(features.begin(), features.end()), features.end());
}

} // namespace

Layout run_unwrap(const Polygon_soup& soup, Surface& surface, const Options& given_options, Outcome& outcome)
{
  Options options = given_options;
  using namespace CGAL::Surface_mesh_parameterization::internal;
  constexpr Execution execution = execution_of<CGAL::Parallel_if_available_tag>();
  end_if_stop_is_requested();
  std::optional<Stacking> stacking;
  if(options.is_stacked)
    stack(surface, options, stacking, outcome);
  Work work(stacking ? stacking->originals() : surface);
  const Result result = find_layout(soup, surface, stacking ? &*stacking : nullptr, options, work, outcome);
  if(!outcome.has_result)
    return {};

  const Mesh& mesh = work.surface.mesh;
  const double given_scale = options.is_pack_only ? scale_of_layout(mesh, work.uvs) : 1;
  std::optional<Work> whole; // with all copies
  if(stacking)
    whole.emplace(surface);
  const Work& all = whole ? *whole : work;
  Layout layout;
  const auto start_layout = [&]
  {
    if(stacking)
      stacking->copy_cut(work.is_cut, all.is_cut);
    layout = make_layout(surface, all.is_cut, soup);
  };
  // On other polygons, both make an adapter, and each would add properties to the mesh.
  const Execution on_triangles = *outcome.polygons == 0 ? execution : Execution::SEQUENTIAL;
  if(options.least_fill)
  {
    pack_with_least_fill(mesh, work.is_cut, work.uvs, given_scale, options, outcome);
    start_layout();
  }
  else
    execute_both(on_triangles, [&] { pack(mesh, work.is_cut, work.uvs, given_scale, options, outcome); }, start_layout);
  if(stacking)
    stacking->copy_uvs(work.uvs, all.uvs);
  if(options.is_pack_only)
    tell_given_layout(mesh, work.is_cut, work.uvs, outcome);
  tell_summary(options, outcome);
  layout.uv_scale = outcome.uv_scale.value_or(1);
  layout.uv_set = options.uv_set;
  layout.has_mirrored = stacking && stacking->has_mirrored();
  layout.bounding_box_diagonal = diagonal_of(surface.mesh);
  add_feature_points(result, work.surface, layout);
  execute_both(execution, [&]
  {
    place_uv_vertices(surface, all.uvs, layout);
    place_pages(options, int(outcome.fills.size()), layout);
  }, [&]
  {
    if(options.json.empty() && options.html.empty())
      return;
    outcome.distortion = SMC::distortion_report(mesh, work.is_cut, work.uvs);
    outcome.seams = SMC::seam_report<CGAL::Parallel_if_available_tag>(mesh, work.is_cut, work.uvs);
  });
  return layout;
}
