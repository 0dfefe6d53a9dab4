// Parts of a surface that are congruent, or mirror images: cut once, and laid on one place.

#ifndef UNWRAP_STACKING_H
#define UNWRAP_STACKING_H

#include "Constraints.h"
#include "Mesh.h"
#include "Surface.h"

#include <CGAL/Surface_mesh_cutting/internal/surface/Congruent_components.h>

#include <vector>

class Stacking
{
public:
  // `tolerance`: of the diagonal of a part. The surface is kept by reference.
  Stacking(const Surface& surface, double tolerance);
  Stacking(const Stacking&) = delete;
  Stacking& operator=(const Stacking&) = delete;

  bool has_copies() const { return m_copies > 0; }

  // One of each, without the corners of the soup.
  Surface& originals() { return m_originals; }

  // The constraints of an original are those of itself and its copies, and its cost is the largest.
  Constraints constraints_of_originals(const Constraints& of_all);

  void copy_cut(Cut_map from, Cut_map to) const;
  void copy_uvs(UV_map from, UV_map to) const;

  // Whether some copies are mirrored: their triangles are clockwise on purpose.
  bool has_mirrored() const;

  // Lists of components that are congruent. They are counted in the order of their first edges.
  std::vector<std::vector<int> > stacks() const;

private:
  Halfedge edge_of_original(Halfedge h) const;
  Halfedge corner_of_original(Halfedge h) const;

  const Surface& m_surface;
  const CGAL::Surface_mesh_cutting::internal::Halfedge_arrays m_arrays;
  const CGAL::Surface_mesh_cutting::internal::Congruent_components m_components;
  Surface m_originals;
  std::vector<Halfedge> m_halfedges; // of the originals, per halfedge of the surface
  int m_copies = 0;
};

#endif // UNWRAP_STACKING_H
