#include "unwrap_file.h"

#include "Thread_limit.h"
#include "mesh_file.h"
#include "outputs.h"
#include "run_unwrap.h"
#include "soup_checks.h"
#include "stop_request.h"

#include <exception>
#include <new>
#include <vector>

namespace {

int number_of_other_polygons(const Polygon_soup& soup)
{
  int number = 0;
  for(int polygon = 0; polygon < soup.number_of_polygons(); ++polygon)
    number += soup.number_of_corners(polygon) != 3;
  return number;
}

CGAL::Surface_mesh_cutting::internal::Welding welding(const Polygon_soup& soup, const Options& options)
{
  using CGAL::Surface_mesh_cutting::internal::Welding;
  const bool is_off = options.is_strict || options.weld == "off";
  if(!soup.point_parts.empty()) // where the reader has welded what is at exactly the same point
    return {is_off || options.weld_tolerance == 0 ? Welding::OFF : Welding::ON, options.weld_tolerance, soup.point_parts};
  return {is_off ? Welding::OFF : options.weld == "on" ? Welding::ON : Welding::AUTO, options.weld_tolerance, {}};
}

void unwrap_file(const Options& options, Output_places& places, Outcome& outcome)
{
  decide_places(options, 1, places);
  const Polygon_soup soup = read_mesh_file(options.input, wanted_attributes(options));
  outcome.warnings = soup.warnings;
  const Layout layout = unwrap_soup(soup, options, outcome);
  if(!outcome.has_result)
    return;
  if(options.has_page_files && outcome.fills.size() > 1)
    decide_places(options, int(outcome.fills.size()), places);
  for(const std::string& warning : warnings_about_outputs(options, places, layout))
    outcome.warnings.push_back(warning);
  write_outputs(options, places, layout, outcome);
}

} // namespace

Layout unwrap_soup(const Polygon_soup& soup, const Options& options, Outcome& outcome)
{
  const Thread_limit limit(options.threads);
  outcome.vertices = soup.number_of_points();
  outcome.faces = soup.number_of_polygons();
  outcome.polygons = number_of_other_polygons(soup);
  if(options.is_strict)
    check_soup(soup);
  else
    check_points(soup);
  end_if_stop_is_requested();
  Surface surface = read_surface(soup, welding(soup, options));
  outcome.interpreted = surface.interpreted;
  if(!options.is_strict) // or else nothing is interpreted, nor welded
    outcome.warnings.insert(outcome.warnings.end(), surface.warnings.begin(), surface.warnings.end());
  end_if_stop_is_requested();
  return run_unwrap(soup, surface, options, outcome);
}

Outcome unwrap_file(const Options& options, Output_places& places)
{
  if(options.time_limit)
    set_time_limit(*options.time_limit);
  Outcome outcome;
  outcome.threads = options.threads;
  outcome.seed = options.seed;
  outcome.effort = options.effort;
  outcome.maximum_average_distortion = options.maximum_average_distortion;
  outcome.solver = options.solver;
  outcome.has_weights = !options.edge_weights.empty();
  try
  {
    unwrap_file(options, places, outcome);
  }
  catch(const Failure& failure)
  {
    outcome.set_failure(failure.code, failure.what(), failure.witness);
  }
  catch(const std::bad_alloc&)
  {
    outcome.set_failure(Exit_code::FAILED, "out of memory");
  }
  catch(const std::exception& exception)
  {
    outcome.set_failure(Exit_code::FAILED, exception.what());
  }
  return outcome;
}
