// Whether a cut and texture coordinates are valid, without the package's own checks.

#ifndef VALID_UNWRAP_H
#define VALID_UNWRAP_H

#include "surface_meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <boost/pending/disjoint_sets.hpp>

#include <set>
#include <utility>
#include <vector>

namespace test {

using Exact_kernel_2 = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

// Whether the chart to the left of the halfedge ends there.
template <typename CutMap>
bool is_chart_border(const Surface_mesh& mesh, CutMap is_cut, Surface_mesh::Halfedge_index h)
{
  return !mesh.is_border(h) && (mesh.is_border(mesh.opposite(h)) || is_cut[mesh.edge(h)]);
}

// The next one along the border of the chart.
template <typename CutMap>
Surface_mesh::Halfedge_index next_on_chart_border(const Surface_mesh& mesh, CutMap is_cut, Surface_mesh::Halfedge_index h)
{
  for(h = mesh.next(h); !is_chart_border(mesh, is_cut, h);)
    h = mesh.next(mesh.opposite(h));
  return h;
}

// The loops of border halfedges.
template <typename CutMap>
std::vector<std::vector<Surface_mesh::Halfedge_index> > chart_borders(const Surface_mesh& mesh, CutMap is_cut)
{
  std::vector<std::vector<Surface_mesh::Halfedge_index> > loops;
  std::set<Surface_mesh::Halfedge_index> is_done;
  for(const auto first : mesh.halfedges())
    if(is_chart_border(mesh, is_cut, first) && is_done.insert(first).second)
    {
      loops.push_back({first});
      for(auto h = next_on_chart_border(mesh, is_cut, first); h != first; h = next_on_chart_border(mesh, is_cut, h))
      {
        is_done.insert(h);
        loops.back().push_back(h);
      }
    }
  return loops;
}

// Whether what the cut leaves are disks, by Euler's formula; whether corners on both sides of the other edges have the
// same coordinates; and whether all triangles are oriented alike, by exact predicates.
template <typename CutMap, typename UvMap>
bool is_valid_unwrap(const Surface_mesh& mesh, CutMap is_cut, UvMap uv)
{
  using Halfedge = Surface_mesh::Halfedge_index;
  std::vector<int> rank(mesh.number_of_halfedges()), parent(mesh.number_of_halfedges());
  boost::disjoint_sets<int*, int*> corners(rank.data(), parent.data());
  std::vector<int> face_rank(mesh.number_of_faces()), face_parent(mesh.number_of_faces());
  boost::disjoint_sets<int*, int*> charts(face_rank.data(), face_parent.data());
  for(const Halfedge h : mesh.halfedges())
    corners.make_set(int(h));
  for(const auto f : mesh.faces())
    charts.make_set(int(f));
  int characteristic = int(mesh.number_of_faces());
  for(const auto e : mesh.edges())
  {
    const Halfedge h = mesh.halfedge(e), opposite = mesh.opposite(h);
    const bool is_open = mesh.is_border(h) || mesh.is_border(opposite) || is_cut[e];
    characteristic -= is_open && !mesh.is_border(h) && !mesh.is_border(opposite) ? 2 : 1;
    if(is_open)
      continue;
    charts.union_set(int(mesh.face(h)), int(mesh.face(opposite)));
    for(const auto& [one, other] : {std::make_pair(h, mesh.prev(opposite)), std::make_pair(mesh.prev(h), opposite)})
    {
      if(uv[one] != uv[other])
        return false;
      corners.union_set(int(one), int(other));
    }
  }
  std::set<int> chart_set, corner_set;
  for(const auto f : mesh.faces())
  {
    chart_set.insert(charts.find_set(int(f)));
    const Halfedge h = mesh.halfedge(f);
    Exact_kernel_2::Point_2 p[3];
    int i = 0;
    for(const Halfedge k : {h, mesh.next(h), mesh.prev(h)})
    {
      corner_set.insert(corners.find_set(int(k)));
      p[i++] = {uv[k].x(), uv[k].y()};
    }
    if(CGAL::orientation(p[0], p[1], p[2]) != CGAL::LEFT_TURN)
      return false;
  }
  characteristic += int(corner_set.size());
  // Each part has a border, so that its characteristic is at most 1, as that of a disk is.
  return chart_set.size() == chart_borders(mesh, is_cut).size() && characteristic == int(chart_set.size());
}

// Whether no two triangles of a single chart without flips overlap: whether its border does not touch itself.
template <typename CutMap, typename UvMap>
bool is_injective(const Surface_mesh& mesh, CutMap is_cut, UvMap uv)
{
  const auto borders = chart_borders(mesh, is_cut);
  CGAL::Polygon_2<Exact_kernel_2> polygon;
  for(const auto h : borders.front())
    polygon.push_back({uv[h].x(), uv[h].y()});
  return borders.size() == 1 && polygon.is_simple();
}

} // namespace test

#endif // VALID_UNWRAP_H
