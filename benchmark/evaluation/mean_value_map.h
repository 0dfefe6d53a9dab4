#ifndef EVALUATION_MEAN_VALUE_MAP_H
#define EVALUATION_MEAN_VALUE_MAP_H

#include "Surface.h"

#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>

#include <Eigen/Geometry>
#include <Eigen/SparseLU>

// The tangent of half the angle of triangle `t` at its corner `k`.
inline double half_angle_tangent(const Internal::Indexed_mesh& mesh, int t, int k)
{
  const Internal::Triangle& c = mesh.triangles()[t];
  const Internal::Point a = mesh.point(c[(k + 1) % 3]) - mesh.point(c[k]),
                    b = mesh.point(c[(k + 2) % 3]) - mesh.point(c[k]);
  return a.cross(b).norm() / (a.norm() * b.norm() + a.dot(b));
}

// The map of an opened mesh to the unit disk by mean value coordinates [Flo03]: the border on the circle,
// spaced as on the surface. False if the system cannot be solved.
inline bool mean_value_map(const Internal::Indexed_mesh& mesh, const Internal::Corner_table& chart, std::vector<Eigen::Vector2d>& uv)
{
  const int n = chart.number_of_vertices();
  const std::vector<int> loop = chart.border_loops().front();
  std::vector<double> lengths;
  for(int h : loop)
    lengths.push_back(mesh.length(mesh.edge(h)));
  uv.resize(n);
  SMP::map_border_to_circle(chart, loop, lengths, uv);

  std::vector<char> is_fixed(n, 0);
  std::vector<Eigen::Triplet<double> > entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(n, 2);
  for(int h : loop)
  {
    const int v = chart.source(h);
    is_fixed[v] = 1;
    entries.emplace_back(v, v, 1.);
    right.row(v) = uv[v].transpose();
  }
  for(int t = 0; t < int(chart.triangles().size()); ++t)
    for(int k = 0; k < 3; ++k)
    {
      const Internal::Triangle& c = chart.triangles()[t];
      const int v = c[k];
      if(is_fixed[v])
        continue;
      for(int side : {3 * t + k, Internal::previous_halfedge(3 * t + k)})
      {
        const double weight = half_angle_tangent(mesh, t, k) / mesh.length(mesh.edge(side));
        const int other = chart.source(side) == v ? c[(k + 1) % 3] : chart.source(side);
        entries.emplace_back(v, v, weight);
        entries.emplace_back(v, other, -weight);
      }
    }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double> > solver(matrix);
  if(solver.info() != Eigen::Success)
    return false;
  const Eigen::MatrixX2d solution = solver.solve(right);
  for(int v = 0; v < n; ++v)
    uv[v] = solution.row(v).transpose();
  return solution.allFinite();
}

#endif // EVALUATION_MEAN_VALUE_MAP_H
