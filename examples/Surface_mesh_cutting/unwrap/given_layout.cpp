#include "given_layout.h"

#include "surface_numbers.h"
#include "uv_seams.h"

#include <CGAL/Surface_mesh_cutting/distortion_report.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>
#include <CGAL/Surface_mesh_cutting/internal/result/side_by_side.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_cutting;

SMC::internal::Certificate certificate_of(const Mesh& mesh, Cut_map is_cut, UV_map uvs)
{
  const auto adapter = SMC::internal::make_mesh_adapter(mesh, CGAL::parameters::default_values());
  return SMC::internal::certify_corners(SMC::internal::make_chart(adapter.mesh(), adapter.read_cut(is_cut)),
                                        adapter.read_uvs(uvs), true);
}

void check_all_have_uvs(const Polygon_soup& soup, const Surface& surface)
{
  Witness witness = {Witness::Kind::FACES, {}};
  for(const Face f : surface.mesh.faces())
  {
    bool has_uvs = true;
    for(const Halfedge h : surface.mesh.halfedges_around_face(surface.mesh.halfedge(f)))
      has_uvs = has_uvs && soup.corner_uvs[std::size_t(surface.corners[h])].has_value();
    if(!has_uvs)
      witness.indices.push_back(surface.polygons[f]);
  }
  if(!witness.indices.empty())
    throw Failure(Exit_code::UNSUPPORTED, "--pack-only: faces without texture coordinates, first face "
                                            + std::to_string(witness.indices.front()), witness);
}

} // namespace

void read_given_layout(const Polygon_soup& soup, const Surface& surface, Cut_map is_cut, UV_map uvs)
{
  for(const Edge e : uv_seams("--pack-only", soup, surface))
    put(is_cut, e, true);
  check_all_have_uvs(soup, surface);
  for(const Halfedge h : surface.mesh.halfedges())
    if(!surface.mesh.is_border(h))
    {
      const Polygon_soup::Texture_point& uv = *soup.corner_uvs[std::size_t(surface.corners[h])];
      put(uvs, h, Kernel::Point_2(uv[0], uv[1]));
    }
}

double scale_of_layout(const Mesh& mesh, UV_map uvs)
{
  const auto adapter = SMC::internal::make_mesh_adapter(mesh, CGAL::parameters::default_values());
  const std::vector<Eigen::Vector2d> uv = adapter.read_uvs(uvs);
  double area = 0, uv_area = 0;
  for(int f = 0; f < adapter.mesh().number_of_faces(); ++f)
  {
    area += adapter.mesh().face_area(f);
    uv_area += std::abs(CGAL::Surface_mesh_parameterization::internal::triangle_area({{3 * f, 3 * f + 1, 3 * f + 2}}, uv));
  }
  const double scale = std::sqrt(uv_area) / adapter.to_original_scale(std::sqrt(area));
  if(!(scale > 0 && std::isfinite(scale)))
    throw Failure(Exit_code::UNSUPPORTED, "--pack-only: the texture coordinates have no area");
  return scale;
}

bool has_overlaps(const Mesh& mesh, Cut_map is_cut, UV_map uvs)
{
  using CGAL::Surface_mesh_parameterization::internal::vertex_uvs;
  const auto adapter = SMC::internal::make_mesh_adapter(mesh, CGAL::parameters::default_values());
  const auto chart = SMC::internal::make_chart(adapter.mesh(), adapter.read_cut(is_cut));
  // Apart, since thousands of charts on one place have millions of overlaps with each other.
  const auto uv = SMC::internal::side_by_side(chart, vertex_uvs(chart, adapter.read_uvs(uvs)), false);
  return SMC::internal::certify(chart, uv, true).overlaps() > 0;
}

void tell_given_layout(const Mesh& mesh, Cut_map is_cut, UV_map uvs, Outcome& outcome)
{
  tell_numbers(mesh, outcome);
  const SMC::internal::Certificate certificate = certificate_of(mesh, is_cut, uvs);
  outcome.flips = certificate.flips;
  outcome.overlaps = certificate.overlaps();
  if(certificate.flips > 0)
    outcome.warnings.push_back("--pack-only keeps " + std::to_string(certificate.flips)
                               + " triangles of the input that are clockwise in the texture, or have no area there");
  if(certificate.overlaps() > 0)
    outcome.warnings.push_back("--pack-only keeps " + std::to_string(certificate.overlaps())
                               + " overlaps of charts of the input with themselves");
  double length = 0;
  for(const Edge e : mesh.edges())
    if(get(is_cut, e))
      length += edge_length(mesh, e);
  outcome.cut_length = length / diagonal_of(mesh);
  const SMC::Distortion_report<Mesh> measures = SMC::distortion_report(mesh, is_cut, uvs);
  if(measures && certificate.flips == 0)
    outcome.average_energy = measures.symmetric_Dirichlet_energy;
}
