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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Triangle_groups.h>

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The sparse system of a Newton step: gradient and Hessian of a sum of triangle energies. The
// pattern, the places of all entries in it and the order of the unknowns are found once.
class Newton_system
{
public:
  Newton_system() = default;

  // Receives the pattern of the Hessian once it is known.
  using Analyze = std::function<void(const Sparse_matrix&)>;

  // Vertices with `is_fixed` have no unknowns (empty: none is fixed). The unknowns come in the order of the vertices'
  // `ranks`, ties by index; if there are none, an order that keeps the factors sparse is found. O(n log n).
  Newton_system(const std::vector<Triangle>& triangles, int number_of_vertices, const std::vector<char>& is_fixed,
                Execution execution = Execution::SEQUENTIAL, const std::vector<int>& ranks = {},
                const Analyze& analyze = [](const Sparse_matrix&) {})
    : m_execution(execution), m_positions(number_of_vertices, -1)
  {
    const int number_of_positions = order_unknowns(triangles, is_fixed, ranks);
    build_pattern(triangles, number_of_positions);
    execute_in_isolation(m_execution, [&]
    {
      execute_both(m_execution, [&] { analyze(m_hessian); }, [&]
      {
        locate_mixed_blocks(triangles);
        m_groups = Triangle_groups(triangles, m_positions, number_of_positions);
      });
    });
  }

  int number_of_unknowns() const { return int(m_gradient.size()); }
  const Sparse_matrix& hessian() const { return m_hessian; }
  const Eigen::VectorXd& gradient() const { return m_gradient; }
  // The first unknown of a vertex, or a negative number for a fixed or unused one.
  int unknown(int v) const { return 2 * m_positions[v]; }
  // The place of each vertex in the order of elimination, negative without an unknown.
  const std::vector<int>& positions() const { return m_positions; }

  // The Newton decrement of one vertex with all others fixed, from the gradient and the latest Hessian; 0 without an
  // unknown.
  double decrement(int v) const
  {
    const int p = m_positions[v];
    if(p < 0)
      return 0;
    const double* const d = m_hessian.valuePtr() + m_diagonal[p];
    const int stride = m_column_sizes[p];
    const double x = m_gradient[2 * p], y = m_gradient[2 * p + 1];
    return (d[stride + 1] * x * x - 2 * d[stride] * x * y + d[0] * y * y) / (d[0] * d[stride + 1] - d[stride] * d[stride]);
  }

  // The vertices with a decrement above a threshold.
  std::vector<int> vertices_above(double threshold) const
  {
    const auto append = [](std::vector<int> list, const std::vector<int>& more)
    {
      list.insert(list.end(), more.begin(), more.end());
      return list;
    };
    return reduce_blocks(m_execution, int(m_positions.size()), std::vector<int>(), [&](int begin, int end)
    {
      std::vector<int> above;
      for(int v = begin; v < end; ++v)
        if(decrement(v) > threshold)
          above.push_back(v);
      return above;
    }, append);
  }

  // Where a vertex has moved; nothing without an unknown.
  void set_gradient(int v, const Eigen::Vector2d& gradient)
  {
    if(m_positions[v] >= 0)
      m_gradient.segment<2>(2 * m_positions[v]) = gradient;
  }

  // Sums weight * energy over the triangles. A diagonal entry grows by the fraction `shift` of
  // itself; this fixes the gauge where the energy does not depend on scale and rotation, without
  // damping stiff and soft regions alike as a constant would.
  template <typename Energy>
  double assemble(const std::vector<Triangle>& triangles, const std::vector<Rest_shape>& shapes,
                  const std::vector<double>& weights, const std::vector<Eigen::Vector2d>& uv,
                  double shift)
  {
    double* const values = m_hessian.valuePtr();
    execute_blocks(m_execution, int(m_hessian.nonZeros()),
                   [&](int begin, int end) { std::fill(values + begin, values + end, 0.); });
    m_gradient.setZero();
    const auto terms_of = [&](int f)
    {
      Triangle_terms terms;
      const Triangle& t = triangles[f];
      triangle_terms<Energy>(shapes[f], uv[t[0]], uv[t[1]], uv[t[2]], terms);
      return terms;
    };
    const double energy = m_groups.sum(m_execution, terms_of, [&](int f, const Triangle_terms& terms)
    {
      const Triangle& t = triangles[f];
      const double w = weights[f];
      for(int k = 0; k < 3; ++k)
      {
        const int p = m_positions[t[k]];
        if(p < 0)
          continue;
        m_gradient.segment<2>(2 * p) += w * terms.gradient[k];
        double* d = values + m_diagonal[p];
        const int stride = m_column_sizes[p];
        d[0] += w * terms.diagonal[k](0, 0);
        d[stride] += w * terms.diagonal[k](0, 1);
        d[stride + 1] += w * terms.diagonal[k](1, 1);
        add_mixed(values, m_mixed[3 * f + k], p, m_positions[t[(k + 1) % 3]], w, terms.mixed[k]);
      }
      return w * terms.value;
    });
    execute_blocks(m_execution, int(m_diagonal.size()), [&](int begin, int end)
    {
      for(int p = begin; p < end; ++p)
      {
        values[m_diagonal[p]] *= 1 + shift;
        values[m_diagonal[p] + m_column_sizes[p] + 1] *= 1 + shift;
      }
    });
    return energy;
  }

  // The gradient of the same sum, without the Hessian.
  template <typename Energy>
  void assemble_gradient(const std::vector<Triangle>& triangles, const std::vector<Rest_shape>& shapes,
                         const std::vector<double>& weights, const std::vector<Eigen::Vector2d>& uv)
  {
    m_gradient.setZero();
    struct Gradient { Eigen::Vector2d at_corners[3]; };
    const auto gradient_of = [&](int f)
    {
      Gradient gradient;
      const Triangle& t = triangles[f];
      triangle_gradient<Energy>(shapes[f], uv[t[0]], uv[t[1]], uv[t[2]], gradient.at_corners);
      return gradient;
    };
    m_groups.sum(m_execution, gradient_of, [&](int f, const Gradient& gradient)
    {
      const Triangle& t = triangles[f];
      for(int k = 0; k < 3; ++k)
        if(m_positions[t[k]] >= 0)
          m_gradient.segment<2>(2 * m_positions[t[k]]) += weights[f] * gradient.at_corners[k];
      return 0.;
    });
  }

private:
  static void add_to_block(double* block, int stride, double a00, double a01, double a10, double a11)
  {
    block[0] += a00;
    block[1] += a10;
    block[stride] += a01;
    block[stride + 1] += a11;
  }

  // `m` belongs to rows of p and columns of q; the upper triangle keeps it where p < q.
  void add_mixed(double* values, int entry, int p, int q, double w, const Eigen::Matrix2d& m) const
  {
    if(entry < 0)
      return;
    if(p < q)
      add_to_block(values + entry, m_column_sizes[q], w * m(0, 0), w * m(0, 1), w * m(1, 0), w * m(1, 1));
    else
      add_to_block(values + entry, m_column_sizes[p], w * m(0, 0), w * m(1, 0), w * m(0, 1), w * m(1, 1));
  }

  // Returns the number of vertices with unknowns.
  int order_unknowns(const std::vector<Triangle>& triangles, const std::vector<char>& is_fixed,
                     const std::vector<int>& ranks)
  {
    std::vector<int> compact(m_positions.size(), -1);
    std::vector<int> vertices;
    for(const Triangle& t : triangles)
      for(int v : t)
        if(compact[v] < 0 && (is_fixed.empty() || !is_fixed[v]))
        {
          compact[v] = int(vertices.size());
          vertices.push_back(v);
        }
    const int n = int(vertices.size());
    if(!ranks.empty())
    {
      std::sort(vertices.begin(), vertices.end(),
                [&](int v, int w) { return ranks[v] != ranks[w] ? ranks[v] < ranks[w] : v < w; });
      for(int i = 0; i < n; ++i)
        m_positions[vertices[i]] = i;
      return n;
    }
    const std::vector<int> order = fill_reducing_order(adjacency(n, [&](const auto& visit)
    {
      for(int i = 0; i < n; ++i)
        visit(i, i);
      for_each_edge(triangles, compact, [&](int p, int q)
      {
        visit(p, q);
        visit(q, p);
      });
    }));
    for(int i = 0; i < n; ++i)
      m_positions[vertices[order[i]]] = i;
    return n;
  }

  // Calls `visit(p, q)` for the sides of triangles both of whose ends have `numbers` that are not negative.
  template <typename Visit>
  static void for_each_edge(const std::vector<Triangle>& triangles, const std::vector<int>& numbers, const Visit& visit)
  {
    for(const Triangle& t : triangles)
      for(int k = 0; k < 3; ++k)
      {
        const int p = numbers[t[k]], q = numbers[t[(k + 1) % 3]];
        if(p >= 0 && q >= 0)
          visit(p, q);
      }
  }

  // `for_each_pair(visit)` calls `visit(column, row)`, for any of them several times.
  template <typename ForEachPair>
  Sparse_matrix adjacency(int n, const ForEachPair& for_each_pair) const
  {
    Buckets<int> columns(n, for_each_pair);
    std::vector<int> sizes(n);
    execute_blocks(m_execution, n, [&](int begin, int end)
    {
      for(int c = begin; c < end; ++c)
      {
        const auto rows = columns[c];
        std::sort(rows.begin(), rows.end());
        sizes[c] = int(std::unique(rows.begin(), rows.end()) - rows.begin());
      }
    });
    Sparse_matrix matrix(n, n);
    int* const outer = matrix.outerIndexPtr();
    outer[0] = 0;
    for(int c = 0; c < n; ++c)
      outer[c + 1] = outer[c] + sizes[c];
    matrix.resizeNonZeros(outer[n]);
    execute_blocks(m_execution, n, [&](int begin, int end)
    {
      for(int c = begin; c < end; ++c)
        std::copy_n(columns[c].begin(), sizes[c], matrix.innerIndexPtr() + outer[c]);
      std::fill(matrix.valuePtr() + outer[begin], matrix.valuePtr() + outer[end], 1.);
    });
    return matrix;
  }

  // `n`: the number of positions.
  void build_pattern(const std::vector<Triangle>& triangles, int n)
  {
    const Sparse_matrix blocks = adjacency(n, [&](const auto& visit)
    { for_each_edge(triangles, m_positions, [&](int p, int q) { visit((std::max)(p, q), (std::min)(p, q)); }); });

    m_hessian.resize(2 * n, 2 * n);
    m_hessian.resizeNonZeros(4 * blocks.nonZeros() + 3 * n);
    m_diagonal.resize(n);
    m_column_sizes.resize(n);
    int* outer = m_hessian.outerIndexPtr();
    int* inner = m_hessian.innerIndexPtr();
    int entry = 0;
    for(int c = 0; c < n; ++c)
      for(int second = 0; second < 2; ++second)
      {
        outer[2 * c + second] = entry;
        for(Sparse_matrix::InnerIterator it(blocks, c); it; ++it)
        {
          inner[entry++] = 2 * int(it.row());
          inner[entry++] = 2 * int(it.row()) + 1;
        }
        if(second == 0)
        {
          m_diagonal[c] = entry;
          m_column_sizes[c] = entry + 1 - outer[2 * c];
        }
        inner[entry++] = 2 * c;
        if(second == 1)
          inner[entry++] = 2 * c + 1;
      }
    outer[2 * n] = entry;
    m_gradient.setZero(2 * n);
  }

  void locate_mixed_blocks(const std::vector<Triangle>& triangles)
  {
    const int *const outer = m_hessian.outerIndexPtr(), *const inner = m_hessian.innerIndexPtr();
    m_mixed.assign(3 * triangles.size(), -1);
    execute_blocks(m_execution, int(triangles.size()), [&](int begin, int end)
    {
      for(int h = 3 * begin; h < 3 * end; ++h)
      {
        const Triangle& t = triangles[h / 3];
        const int p = m_positions[t[h % 3]], q = m_positions[t[(h + 1) % 3]];
        if(p < 0 || q < 0)
          continue;
        const int column = (std::max)(p, q), row = (std::min)(p, q);
        const int *const first = inner + outer[2 * column], *const last = inner + outer[2 * column + 1];
        m_mixed[h] = outer[2 * column] + int(std::lower_bound(first, last, 2 * row) - first);
      }
    });
  }

  Execution m_execution = Execution::SEQUENTIAL;
  std::vector<int> m_positions;    // per vertex, in the order of elimination
  Sparse_matrix m_hessian;         // upper triangle
  Eigen::VectorXd m_gradient;
  std::vector<int> m_diagonal;     // per position, where its 2x2 diagonal block starts
  std::vector<int> m_column_sizes; // per position, distance between its two columns
  std::vector<int> m_mixed;        // per halfedge, where the block of its two vertices starts
  Triangle_groups m_groups;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SYSTEM_H
