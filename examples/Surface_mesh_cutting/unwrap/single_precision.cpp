#include "single_precision.h"

#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>

#include <string>

void hold_in_single_precision(const Mesh& mesh, Cut_map is_cut, UV_map uvs, bool is_injective, Outcome& outcome)
{
  using namespace CGAL::Surface_mesh_cutting::internal;
  for(const Halfedge h : mesh.halfedges())
    put(Single_precision_uvs{uvs}, h, Single_precision_uv(uvs[h].x(), uvs[h].y()));
  const auto adapter = make_mesh_adapter(mesh, CGAL::parameters::default_values());
  const Certificate certificate = certify_corners(make_chart(adapter.mesh(), adapter.read_cut(is_cut)), adapter.read_uvs(uvs),
                                                  is_injective);
  outcome.flips = certificate.flips;
  if(is_injective)
    outcome.overlaps = certificate.overlaps();
  if(!certificate)
    outcome.warnings.push_back("the single precision of glTF spoils the layout (" + certificate.status().finding.message
                               + "); OBJ and PLY hold all digits");
}
