#include "divide_long_charts.h"

#include "halfedge_arrays.h"
#include "pack.h"
#include "stop_request.h"
#include "surface_numbers.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/Long_chart.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <vector>

namespace {

using CGAL::Surface_mesh_cutting::internal::Halfedge_arrays;
using CGAL::Surface_mesh_cutting::internal::Long_chart;

std::vector<Eigen::Vector2d> uv_vectors(const Mesh& mesh, UV_map uvs)
{
  std::vector<Eigen::Vector2d> result;
  for(const Halfedge h : mesh.halfedges())
    result.emplace_back(uvs[h].x(), uvs[h].y());
  return result;
}

// Until no chart alone keeps all from filling so much; returns the length of the seams on the surface.
double divide(const Mesh& mesh, Cut_map is_cut, UV_map uvs, double fill)
{
  constexpr int most_seams = 1000;
  const Halfedge_arrays arrays = halfedge_arrays(mesh);
  const std::vector<Eigen::Vector2d> uv = uv_vectors(mesh, uvs);
  std::vector<char> is_seam(mesh.num_halfedges(), 0);
  for(const Halfedge h : mesh.halfedges())
    is_seam[h] = is_cut[mesh.edge(h)];
  double length = 0;
  for(int i = 0; i < most_seams && !is_stop_requested(); ++i)
  {
    const Long_chart chart(arrays, uv, is_seam);
    const std::vector<int> seam = chart.area() < fill * chart.side() * chart.side() ? chart.seam() : std::vector<int>();
    if(seam.empty())
      break;
    for(const int number : seam)
    {
      const Halfedge h = Halfedge(Mesh::size_type(number));
      is_seam[h] = is_seam[mesh.opposite(h)] = 1;
      is_cut[mesh.edge(h)] = true;
      length += edge_length(mesh, mesh.edge(h));
    }
  }
  return length;
}

// Whether there is room for so many charts.
bool pack_again(const Mesh& mesh, Cut_map is_cut, UV_map uvs, double given_scale, const Options& options, Outcome& outcome)
{
  try
  {
    pack(mesh, is_cut, uvs, given_scale, options, outcome);
    return true;
  }
  catch(const Failure&)
  {
    return false;
  }
}

void warn(double wanted, double fill, Outcome& outcome)
{
  std::ostringstream text;
  text.precision(3);
  text << "--min-fill " << wanted << ": charts fill " << 100 * fill << " % of the pages; dividing more of them is not worth it";
  outcome.warnings.push_back(text.str());
}

} // namespace

void pack_with_least_fill(const Mesh& mesh, Cut_map is_cut, UV_map uvs, double given_scale, const Options& options,
                          Outcome& outcome)
{
  constexpr double usual_fill = 0.6, step = 1.5; // of what the longest chart allows; how much more that then allows
  constexpr int most_tries = 4;
  const std::vector<Kernel::Point_2> given(uvs.begin(), uvs.end());
  pack(mesh, is_cut, uvs, given_scale, options, outcome);
  double allowed = *options.least_fill / usual_fill;
  for(int i = 0; i < most_tries && *outcome.mean_fill() < *options.least_fill && outcome.exit_code != Exit_code::STOPPED; ++i)
  {
    const std::vector<char> former_cut(is_cut.begin(), is_cut.end());
    const std::vector<Kernel::Point_2> packed(uvs.begin(), uvs.end());
    const Outcome former = outcome;
    std::copy(given.begin(), given.end(), uvs.begin());
    const double length = divide(mesh, is_cut, uvs, allowed);
    if(!(length > 0 && pack_again(mesh, is_cut, uvs, given_scale, options, outcome)
         && *outcome.mean_fill() > *former.mean_fill()))
    {
      std::copy(former_cut.begin(), former_cut.end(), is_cut.begin());
      std::copy(packed.begin(), packed.end(), uvs.begin());
      outcome = former;
    }
    else if(outcome.cut_length)
    {
      *outcome.cut_length += length / diagonal_of(mesh);
      if(outcome.average_energy)
        outcome.trade_offs.push_back({{*outcome.cut_length, *outcome.average_energy}});
    }
    allowed *= step;
  }
  if(*outcome.mean_fill() < *options.least_fill)
    warn(*options.least_fill, *outcome.mean_fill(), outcome);
}
