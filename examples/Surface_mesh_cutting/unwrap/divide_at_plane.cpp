#include "divide_at_plane.h"

#include <CGAL/Surface_mesh_cutting/internal/halves/Half_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/mirrored_vertices.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/to_plane.h>
#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <cstddef>

namespace {

template <typename Adapter>
std::vector<int> mirrored_halfedges(const Mesh& mesh, const Adapter& adapter,
                                    const CGAL::Surface_mesh_cutting::internal::Indexed_symmetry& symmetry)
{
  std::vector<int> image_of(mesh.num_vertices(), -1), images(mesh.num_halfedges(), -1);
  for(std::size_t v = 0; v < symmetry.images.size(); ++v)
    if(symmetry.images[v] >= 0)
      image_of[std::size_t(adapter.to_vertex(int(v)))] = int(adapter.to_vertex(symmetry.images[v]));
  for(const Halfedge h : mesh.halfedges())
  {
    const int from = image_of[std::size_t(mesh.target(h))], to = image_of[std::size_t(mesh.source(h))];
    if(from >= 0 && to >= 0)
      images[std::size_t(h)] = int(mesh.halfedge(Vertex(Mesh::size_type(from)), Vertex(Mesh::size_type(to))));
  }
  return images;
}

} // namespace

std::optional<Division> divide_at_plane(const Mesh& mesh, CGAL::Surface_mesh_cutting::Symmetry choice)
{
  using namespace CGAL::Surface_mesh_cutting::internal;
  constexpr Execution execution
    = CGAL::Surface_mesh_parameterization::internal::execution_of<CGAL::Parallel_if_available_tag>();
  if(choice == CGAL::Surface_mesh_cutting::Symmetry::NONE)
    return std::nullopt;
  const auto adapter = make_mesh_adapter(mesh, CGAL::parameters::default_values());
  if(!adapter.status())
    return std::nullopt;
  const Indexed_mesh& indexed = adapter.mesh();
  for(const Indexed_symmetry& symmetry : find_indexed_symmetries(indexed, diagonals_of(adapter), choice, execution))
  {
    if(!symmetry.is_symmetry() || !symmetry.is_exact)
      continue;
    const Half_mesh half(indexed, symmetry);
    if(!half.is_divided())
      continue;
    Division division{to_plane(symmetry, adapter), std::vector<char>(mesh.num_edges(), 0), mirrored_halfedges(mesh, adapter, symmetry)};
    for(int e = 0; e < indexed.number_of_edges(); ++e)
      if(half.plane()[e])
        division.is_divided[std::size_t(adapter.to_edge(e))] = 1;
    return division;
  }
  return std::nullopt;
}
