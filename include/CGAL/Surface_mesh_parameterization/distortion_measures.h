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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_MEASURES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_MEASURES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {

#ifndef DOXYGEN_RUNNING
namespace internal {

// The corners of a surface, face by face, in the order of `faces(tmesh)`.
struct Corners
{
  std::vector<Triangle> triangles; // of consecutive corners
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector2d> uv; // may be empty

  // Brings the surface to an extent of about one and the UVs with it, which changes no Jacobian.
  void normalize()
  {
    Bounding_box<3> box;
    for(const Eigen::Vector3d& p : points)
      box.add(p);
    const int e = scale_exponent(box);
    for(Eigen::Vector3d& p : points)
      p = scaled(p, -e);
    for(Eigen::Vector2d& p : uv)
      p = scaled(p, -e);
  }

  std::vector<Rest_shape> shapes() const { return rest_shapes(triangles, points); }
};

// `read_uv` is called with each halfedge that leads to a corner.
template <typename TriangleMesh, typename NamedParameters, typename ReadUV>
Corners read_corners(const TriangleMesh& tmesh, const NamedParameters& np, ReadUV read_uv)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Graph_traits = boost::graph_traits<TriangleMesh>;

  CGAL_precondition(is_triangle_mesh(tmesh));
  typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type vpm
    = choose_parameter(get_parameter(np, internal_np::vertex_point),
                       get_const_property_map(CGAL::vertex_point, tmesh));
  Corners corners;
  for(typename Graph_traits::face_descriptor f : faces(tmesh))
  {
    const int first = int(corners.points.size());
    corners.triangles.push_back({first, first + 1, first + 2});
    typename Graph_traits::halfedge_descriptor h = halfedge(f, tmesh);
    for(int k = 0; k < 3; ++k, h = next(h, tmesh))
    {
      corners.points.push_back(to_vector_3(get(vpm, target(h, tmesh))));
      read_uv(h, corners.uv);
    }
  }
  corners.normalize();
  return corners;
}

template <typename TriangleMesh, typename HalfedgeUVMap, typename NamedParameters>
Corners read_map(const TriangleMesh& tmesh, HalfedgeUVMap halfedge_uv_map, const NamedParameters& np)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  return read_corners(tmesh, np, [&](halfedge_descriptor h, std::vector<Eigen::Vector2d>& uv)
  {
    uv.push_back(to_vector_2(get(halfedge_uv_map, h)));
  });
}

template <typename Energy, typename TriangleMesh, typename HalfedgeUVMap, typename FaceEnergyMap,
          typename NamedParameters>
double compute_energy(const TriangleMesh& tmesh, HalfedgeUVMap halfedge_uv_map,
                      FaceEnergyMap face_energy_map, const NamedParameters& np)
{
  const Corners corners = read_map(tmesh, halfedge_uv_map, np);
  const std::vector<Rest_shape> shapes = corners.shapes();
  const std::vector<double> energies = face_energies<Energy>(shapes, corners.triangles, corners.uv);
  std::size_t i = 0;
  for(typename boost::graph_traits<TriangleMesh>::face_descriptor f : faces(tmesh))
    put(face_energy_map, f, energies[i++]);
  return area_average(shapes, energies);
}

} // namespace internal
#endif // DOXYGEN_RUNNING

/// \ingroup PkgSurfaceMeshCuttingParameterizersRef
///
/// computes the conformal distortion of a map from a surface to the plane: for each face the MIPS energy
/// \f$ \frac{1}{2}\|J\|_F^2 / \det J \f$ of its Jacobian \f$ J \f$. The energy is 1 for a similarity, larger
/// otherwise, and infinite where the image is not counterclockwise. The time is linear in the number of faces.
///
/// A degenerate face gets a small height so that its energy is defined.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `%Point_2` as value type
/// \tparam FaceEnergyMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
///         as key type and `double` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param halfedge_uv_map holds, at each halfedge `h` that is not on the border, the UV of the corner
///        of `face(h, tmesh)` at `target(h, tmesh)`
/// \param face_energy_map receives the energies. Pass a `boost::dummy_property_map` if only the average matters.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre `is_triangle_mesh(tmesh)`
///
/// \return the average of the energy over the area of the surface
template <typename TriangleMesh, typename HalfedgeUVMap, typename FaceEnergyMap,
          typename NamedParameters = parameters::Default_named_parameters>
double compute_MIPS_energy(const TriangleMesh& tmesh, HalfedgeUVMap halfedge_uv_map, FaceEnergyMap face_energy_map,
                           const NamedParameters& np = parameters::default_values())
{
  using Energy = internal::MIPS_energy;
  return internal::compute_energy<Energy>(tmesh, halfedge_uv_map, face_energy_map, np);
}

/// \ingroup PkgSurfaceMeshCuttingParameterizersRef
///
/// computes the isometric distortion of a map from a surface to the plane: for each face the symmetric Dirichlet
/// energy \f$ \|J\|_F^2 + \|J^{-1}\|_F^2 \f$ of its Jacobian \f$ J \f$. The energy is 4 for a rigid motion, larger
/// otherwise, and infinite where the image is not counterclockwise. It depends on the scale of the UVs, see
/// `best_isometric_scale()`. The time is linear in the number of faces.
///
/// A degenerate face gets a small height so that its energy is defined.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `%Point_2` as value type
/// \tparam FaceEnergyMap a model of `WritablePropertyMap` with `boost::graph_traits<TriangleMesh>::%face_descriptor`
///         as key type and `double` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param halfedge_uv_map holds, at each halfedge `h` that is not on the border, the UV of the corner
///        of `face(h, tmesh)` at `target(h, tmesh)`
/// \param face_energy_map receives the energies. Pass a `boost::dummy_property_map` if only the average matters.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre `is_triangle_mesh(tmesh)`
///
/// \return the average of the energy over the area of the surface
template <typename TriangleMesh, typename HalfedgeUVMap, typename FaceEnergyMap,
          typename NamedParameters = parameters::Default_named_parameters>
double compute_symmetric_Dirichlet_energy(const TriangleMesh& tmesh, HalfedgeUVMap halfedge_uv_map,
                                          FaceEnergyMap face_energy_map,
                                          const NamedParameters& np = parameters::default_values())
{
  using Energy = internal::Symmetric_Dirichlet_energy;
  return internal::compute_energy<Energy>(tmesh, halfedge_uv_map, face_energy_map, np);
}

/// \ingroup PkgSurfaceMeshCuttingParameterizersRef
///
/// computes the factor for all UVs that minimizes the average symmetric Dirichlet energy of the map:
/// \f$ \left( \sum_i a_i \|J_i^{-1}\|_F^2 \,/ \sum_i a_i \|J_i\|_F^2 \right)^{1/4} \f$ for faces of
/// area \f$ a_i \f$. The time is linear in the number of faces.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `%Point_2` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param halfedge_uv_map holds, at each halfedge `h` that is not on the border, the UV of the corner
///        of `face(h, tmesh)` at `target(h, tmesh)`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre `is_triangle_mesh(tmesh)`
///
/// \return the factor; it is meaningless unless every face is mapped to a counterclockwise triangle
template <typename TriangleMesh, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
double best_isometric_scale(const TriangleMesh& tmesh, HalfedgeUVMap halfedge_uv_map,
                            const NamedParameters& np = parameters::default_values())
{
  const internal::Corners corners = internal::read_map(tmesh, halfedge_uv_map, np);
  return internal::best_scale(corners.shapes(), corners.triangles, corners.uv);
}

/// \ingroup PkgSurfaceMeshCuttingParameterizersRef
///
/// computes the distortion at each vertex of a surface: the area-weighted average of the distortions
/// of the incident faces, and 0 at an isolated vertex. The faces on all sides of a cut count. The
/// time is linear in the size of the surface.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
/// \tparam FaceDistortionMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `double` as value type
/// \tparam VertexDistortionMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `double` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param face_distortion_map holds the distortion of each face, as computed by
///        `compute_symmetric_Dirichlet_energy()` or `compute_MIPS_energy()`
/// \param vertex_distortion_map receives the distortions of the vertices
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre `is_triangle_mesh(tmesh)`
template <typename TriangleMesh, typename FaceDistortionMap, typename VertexDistortionMap,
          typename NamedParameters = parameters::Default_named_parameters>
void compute_vertex_distortion(const TriangleMesh& tmesh, FaceDistortionMap face_distortion_map,
                               VertexDistortionMap vertex_distortion_map,
                               const NamedParameters& np = parameters::default_values())
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

  auto index = get(CGAL::dynamic_vertex_property_t<int>(), tmesh);
  int number_of_vertices = 0;
  for(typename Graph_traits::vertex_descriptor v : vertices(tmesh))
    put(index, v, number_of_vertices++);

  std::vector<int> corner_vertices;
  const internal::Corners corners = internal::read_corners(tmesh, np,
    [&](typename Graph_traits::halfedge_descriptor h, std::vector<Eigen::Vector2d>&)
    { corner_vertices.push_back(get(index, target(h, tmesh))); });
  std::vector<internal::Triangle> triangles;
  for(const internal::Triangle& t : corners.triangles)
    triangles.push_back({corner_vertices[t[0]], corner_vertices[t[1]], corner_vertices[t[2]]});
  std::vector<double> distortions;
  for(typename Graph_traits::face_descriptor f : faces(tmesh))
    distortions.push_back(CGAL::to_double(get(face_distortion_map, f)));

  const std::vector<double> averages
    = internal::vertex_averages(corners.shapes(), triangles, distortions, number_of_vertices);
  for(typename Graph_traits::vertex_descriptor v : vertices(tmesh))
    put(vertex_distortion_map, v, averages[get(index, v)]);
}

} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_MEASURES_H
