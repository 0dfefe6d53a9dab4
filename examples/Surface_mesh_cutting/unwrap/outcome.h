// How a run ended and what it measured: what the exit status, the messages and the JSON report
// are made from.

#ifndef UNWRAP_OUTCOME_H
#define UNWRAP_OUTCOME_H

#include "Surface.h"

#include <CGAL/Surface_mesh_cutting/Distortion_measures.h>
#include <CGAL/Surface_mesh_cutting/Run_profile.h>
#include <CGAL/Surface_mesh_cutting/Reflection_plane.h>
#include <CGAL/Surface_mesh_cutting/Seam_measures.h>
#include <CGAL/Surface_mesh_cutting/Unwrap_result.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

enum class Exit_code
{
  DONE = 0,
  USAGE = 2,
  UNREADABLE = 3,
  UNSUPPORTED = 4,
  FAILED = 5,
  STOPPED = 6,
  BOUND_NOT_REACHED = 7
};

// The elements of the input at which something was found, counted from 0.
// An edge is named by its two vertices, which stand next to each other in the list.
struct Witness
{
  enum class Kind { NONE, VERTICES, EDGES, FACES };

  Kind kind = Kind::NONE;
  std::vector<int> indices;
};

// Ends the run without a result.
class Failure : public std::runtime_error
{
public:
  Failure(Exit_code code, const std::string& message, Witness witness = {})
    : std::runtime_error(message), code(code), witness(std::move(witness))
  {}

  Exit_code code;
  Witness witness;
};

// Seconds spent in the phases of the method.
struct Phase_seconds
{
  std::optional<double> candidates, filter, connect, refine, parameterize, packing, total;
};

// All that is known about a run. What was not computed has no value.
struct Outcome
{
  Exit_code exit_code = Exit_code::DONE;
  std::string message;
  std::vector<std::string> warnings;
  Witness witness;

  std::optional<int> vertices, faces, polygons, components, genus, borders; // polygons: faces that are no triangles
  std::vector<Interpretation> interpreted;
  std::optional<int> candidates, features, auxiliary;
  std::optional<double> cut_length, cut_cost, lower_bound; // over the bounding box diagonal
  std::optional<bool> is_optimal;
  std::optional<double> average_energy, maximum_energy;
  std::vector<std::array<double, 2> > energy_quantiles; // shares of the area, and what they do not exceed
  std::vector<CGAL::Surface_mesh_cutting::Chart_distortion> chart_energies;
  std::optional<int> flips, overlaps, charts;
  std::optional<std::vector<std::vector<int> > > stacked; // components, if they are compared
  std::optional<double> uv_scale, texels_per_unit; // UV units, and texels, per unit of length
  std::vector<double> fills;                       // of the unit square, of each page
  std::optional<CGAL::Surface_mesh_cutting::Distortion_measures> distortion; // if there is a report
  std::optional<CGAL::Surface_mesh_cutting::Seam_measures> seams;            // the same
  std::optional<CGAL::Surface_mesh_cutting::Reflection_plane> symmetry;      // found, if it was asked for
  std::vector<std::array<double, 2> > trade_offs; // length of the cut over the diagonal, mean energy
  Phase_seconds seconds, cpu_seconds;
  CGAL::Surface_mesh_cutting::Phase_counts factorized_unknowns;

  std::optional<int> threads;
  std::optional<std::uint32_t> seed;
  std::optional<double> maximum_average_distortion; // asked for
  std::optional<std::string> effort, solver;
  bool has_weights = false;

  // The mean of the pages, if charts are packed.
  std::optional<double> mean_fill() const
  {
    return fills.empty() ? std::nullopt
                         : std::make_optional(std::accumulate(fills.begin(), fills.end(), 0.) / double(fills.size()));
  }

  // Whether there is a valid result to write.
  bool has_result = false;

  void set_failure(Exit_code code, std::string reason, Witness where = {})
  {
    exit_code = code;
    message = std::move(reason);
    witness = std::move(where);
    has_result = false;
  }
};

#endif // UNWRAP_OUTCOME_H
