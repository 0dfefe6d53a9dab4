// Parts of a surface that are congruent, or mirror images: cut once, and laid on one place. Halves of a symmetric part are such.

#ifndef UNWRAP_STACKING_H
#define UNWRAP_STACKING_H

#include "Constraints.h"
#include "Mesh.h"
#include "Surface.h"
#include "divide_at_plane.h"

#include <CGAL/Surface_mesh_cutting/internal/surface/Congruent_components.h>

#include <cstddef>
#include <optional>
#include <vector>

class Stacking
{
public:
  // `tolerance`: of the diagonal of a part. `division`: where components are divided in addition. The surface is kept by
  // reference.
  Stacking(const Surface& surface, double tolerance, const std::optional<Division>& division);
  Stacking(const Stacking&) = delete;
  Stacking& operator=(const Stacking&) = delete;

  bool has_copies() const { return m_copies > 0; }

  // One of each, without the corners of the soup.
  Surface& originals() { return m_originals; }

  // The constraints of an original are those of itself and its copies, and its cost is the largest. Throws a `Failure` where edges
  // that are not to be cut are divided.
  Constraints constraints_of_originals(const Constraints& of_all);

  void copy_cut(Cut_map from, Cut_map to) const;
  void copy_uvs(UV_map from, UV_map to) const;

  // Whether some copies are mirrored: their triangles are clockwise on purpose.
  bool has_mirrored() const;

  // Lists of components, or of what is left of them where they are divided, that are congruent. They are counted in the order of
  // their first edges.
  std::vector<std::vector<int> > stacks() const;

private:
  bool is_divided(Edge e) const { return !m_is_divided.empty() && m_is_divided[std::size_t(e)] != 0; }
  Halfedge edge_of_original(Halfedge h) const;
  Halfedge corner_of_original(Halfedge h) const;

  const Surface& m_surface;
  const std::vector<char> m_is_divided;
  const CGAL::Surface_mesh_cutting::internal::Halfedge_arrays m_arrays;
  const CGAL::Surface_mesh_cutting::internal::Congruent_components m_components;
  Surface m_originals;
  std::vector<Halfedge> m_halfedges; // of the originals, per halfedge of the surface
  int m_copies = 0;
};

#endif // UNWRAP_STACKING_H
