// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_PRINCIPAL_ALIGNMENT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_PRINCIPAL_ALIGNMENT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/dihedral_angles.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/flatness.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// How the surface bends around a vertex, integrated over a third of its faces: the tensor of Cohen-Steiner and
// Morvan, to which each edge adds its dihedral angle, times half its length, in its own direction.
struct Integrated_curvature
{
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  double area = 0;
};

inline Eigen::Vector3d unit_direction(const Indexed_mesh& mesh, int e)
{
  const int h = mesh.halfedge(e);
  return (mesh.point(mesh.target(h)) - mesh.point(mesh.source(h))).stableNormalized();
}

inline std::vector<Integrated_curvature> vertex_curvatures(const Indexed_mesh& mesh)
{
  std::vector<Integrated_curvature> result(mesh.number_of_vertices());
  const std::vector<double> angles = dihedral_angles(mesh);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    const Eigen::Vector3d direction = unit_direction(mesh, e);
    const Eigen::Matrix3d tensor = (0.5 * angles[e] * mesh.length(e)) * direction * direction.transpose();
    for(int v : {mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e))})
      result[v].tensor += tensor;
  }
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.triangles()[f])
      result[v].area += mesh.face_area(f) / 3;
  return result;
}

// For each edge, from the curvature around its ends: 1 if it runs in a principal direction of a surface that
// bends clearly more in one direction than in the other, 0 if it runs halfway between the two directions or
// if there are none, as on a plane or a sphere. Linear in the size of the mesh.
inline std::vector<double> principal_alignment(const Indexed_mesh& mesh)
{
  const std::vector<Integrated_curvature> curvatures = vertex_curvatures(mesh);
  const std::vector<Eigen::Vector3d> normals = unit_normals(mesh);
  // What bends less than a sphere as large as the surface counts as flat.
  const double least_curvature = 1 / bounding_box_diagonal(mesh);
  std::vector<double> result(mesh.number_of_edges(), 0.);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    const int h = mesh.halfedge(e);
    const Integrated_curvature& first = curvatures[mesh.source(h)];
    const Integrated_curvature& second = curvatures[mesh.target(h)];
    const Eigen::Matrix3d tensor = first.tensor + second.tensor;

    // Its entries in the tangent plane, the first axis along the edge.
    Eigen::Vector3d normal = normals[h / 3];
    if(!mesh.is_border(h))
      normal += normals[mesh.opposite(h) / 3];
    const Eigen::Vector3d along = unit_direction(mesh, e);
    const Eigen::Vector3d across = Surface_mesh_parameterization::internal::cross_product(normal.stableNormalized(), along);
    const double difference = along.dot(tensor * along) - across.dot(tensor * across);
    const double sum = along.dot(tensor * along) + across.dot(tensor * across);
    const double mixed = 2 * along.dot(tensor * across);

    // With an angle t from the edge to the nearer principal direction, the principal curvatures differ by
    // the root of `square`, of which `difference` is the part cos(2t).
    const double square = difference * difference + mixed * mixed;
    const double flat = least_curvature * (first.area + second.area);
    const double bending = (std::max)(square, 0.5 * (square + sum * sum) + flat * flat);
    if(bending > 0)
      result[e] = difference * difference / bending;
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_PRINCIPAL_ALIGNMENT_H
