#include "Surface.h"

#include "make_mesh.h"
#include "outcome.h"
#include "stop_request.h"

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welding_advice.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/name_of_interpretation.h>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/read_soup.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

namespace SMC = CGAL::Surface_mesh_cutting;

// Only points that no polygon uses may be others.
double finite_or_zero(double x) { return std::isfinite(x) ? x : 0; }

SMC::internal::Soup_surface read(const Polygon_soup& soup, const SMC::internal::Welding& welding,
                                 std::vector<std::string>& warnings)
{
  std::vector<SMC::internal::Point> points;
  points.reserve(soup.points.size());
  for(const Polygon_soup::Point& p : soup.points)
    points.emplace_back(finite_or_zero(p[0]), finite_or_zero(p[1]), finite_or_zero(p[2]));
  SMC::internal::Polygons polygons;
  polygons.vertices = soup.corners;
  if(!soup.originals.empty())
    for(int& v : polygons.vertices)
      v = soup.originals[std::size_t(v)];
  polygons.ends.assign(soup.polygon_ends.begin(), soup.polygon_ends.end());
  using namespace CGAL::Surface_mesh_parameterization::internal;
  constexpr Execution execution = execution_of<CGAL::Parallel_if_available_tag>();
  const SMC::internal::Go_further go_further = [] { return !is_stop_requested(); };
  SMC::internal::Soup_surface surface = SMC::internal::read_soup(points, polygons, welding, execution, go_further);
  end_if_stop_is_requested();
  warnings = SMC::internal::soup_warnings(
    surface, SMC::internal::Welding_adviser(points, polygons, surface, welding, execution, go_further)(),
    {"--weld on", "--weld-tolerance ", ""});
  return surface;
}

Interpretation translate(const SMC::Interpretation& finding)
{
  Interpretation result = {SMC::internal::name_of(finding.kind), {}, {}};
  result.elements.assign(finding.vertices.begin(), finding.vertices.end());
  result.elements.insert(result.elements.end(), finding.polygons.begin(), finding.polygons.end());
  for(const auto& edge : finding.edges)
    result.edges.emplace_back(int(edge[0]), int(edge[1]));
  return result;
}

// The halfedge that leads to each corner of the polygons, of those of the sides.
std::vector<Halfedge> halfedges_to_corners(const SMC::internal::Polygons& polygons, const std::vector<Halfedge>& halfedges)
{
  std::vector<Halfedge> result;
  result.reserve(halfedges.size());
  for(int f = 0; f < polygons.number(); ++f)
    for(int c = polygons.begin(f); c < polygons.end(f); ++c)
      result.push_back(halfedges[std::size_t(polygons.previous(f, c))]);
  return result;
}

} // namespace

Surface read_surface(const Polygon_soup& soup, const SMC::internal::Welding& welding)
{
  Surface surface;
  const SMC::internal::Soup_surface read_as = read(soup, welding, surface.warnings);
  if(read_as.polygons.number() == 0)
    throw Failure(Exit_code::UNSUPPORTED, "no face is part of a surface: each has fewer than three different corners");

  const std::vector<Halfedge> of_sides = number_halfedges(read_as);
  surface.mesh = make_mesh(read_as, of_sides);
  surface.vertices = read_as.origins;
  surface.polygons = read_as.polygon_origins;
  const std::vector<Halfedge> halfedges = halfedges_to_corners(read_as.polygons, of_sides);
  surface.corners.assign(surface.mesh.num_halfedges(), -1);
  surface.halfedges.reserve(read_as.corners.size());
  for(std::size_t c = 0; c < read_as.corners.size(); ++c)
  {
    const Halfedge h = halfedges[std::size_t((std::max)(read_as.corners[c], 0))]; // away from the surface, any
    surface.halfedges.push_back(h);
    if(read_as.is_on_surface[c])
      surface.corners[h] = int(c);
  }
  for(const SMC::Interpretation& finding : read_as.findings)
    surface.interpreted.push_back(translate(finding));
  return surface;
}
