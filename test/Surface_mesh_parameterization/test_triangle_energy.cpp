// Gradients and Hessians of the energies against finite differences in high precision, and the
// projection of Hessians against Eigen's eigenvalues; random and nearly degenerate triangles.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <CGAL/Random.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

namespace triangle_energy_test {

using namespace CGAL::Surface_mesh_parameterization::internal;

using Real = long double;
using Precise = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                              boost::multiprecision::et_off>;
using Vector4 = Eigen::Matrix<Real, 4, 1>; // f_z, then f_z̄
using Matrix4 = Eigen::Matrix<Real, 4, 4>;
using Vector6 = Eigen::Matrix<Real, 6, 1>; // u0, u1, u2
using Matrix46 = Eigen::Matrix<Real, 4, 6>;

// The definitions, by the squared norm and the determinant of the Jacobian.
struct MIPS_definition
{
  using Energy = MIPS_energy;
  static Precise value(const Precise& squared_norm, const Precise& determinant)
  { return squared_norm / (2 * determinant); }
};
struct Symmetric_Dirichlet_definition
{
  using Energy = Symmetric_Dirichlet_energy;
  static Precise value(const Precise& squared_norm, const Precise& determinant)
  { return squared_norm + squared_norm / (determinant * determinant); }
};

template <typename Definition>
Precise value(const std::array<Precise, 4>& w)
{
  const Precise x = w[0] * w[0] + w[1] * w[1], y = w[2] * w[2] + w[3] * w[3];
  return Definition::value(2 * (x + y), x - y);
}

// Central differences; the step is small against the distance to a flip.
template <typename Definition>
struct Differences
{
  Real energy;
  Vector4 gradient;
  Matrix4 hessian;

  explicit Differences(const Vector4& w)
  {
    const Precise h = 1e-5L * (w.head<2>().norm() - w.tail<2>().norm());
    const auto at = [&](int i, int s, int j, int t)
    {
      std::array<Precise, 4> v = {w[0], w[1], w[2], w[3]};
      v[i] += s * h;
      v[j] += t * h;
      return value<Definition>(v);
    };
    for(int i = 0; i < 4; ++i)
    {
      gradient[i] = static_cast<Real>((at(i, 1, i, 0) - at(i, -1, i, 0)) / (2 * h));
      for(int j = 0; j <= i; ++j)
        hessian(i, j) = hessian(j, i)
          = static_cast<Real>((at(i, 1, j, 1) - at(i, 1, j, -1) - at(i, -1, j, 1)
                               + at(i, -1, j, -1)) / (4 * h * h));
    }
    energy = static_cast<Real>(at(0, 0, 0, 0));
  }
};

// Negative eigenvalues set to zero.
Matrix4 clamped(const Matrix4& m)
{
  const Eigen::SelfAdjointEigenSolver<Matrix4> solver(m);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(Real(0)).asDiagonal()
       * solver.eigenvectors().transpose();
}

// The linear map from the corners to (f_z, f_z̄), from the Jacobian's entries.
Matrix46 corner_map(const Rest_shape& s)
{
  const Eigen::Vector2d g[3] = {s.g0, s.g1, s.g2};
  Matrix46 m;
  for(int i = 0; i < 3; ++i)
  {
    const Real a = g[i].x() / 2, b = g[i].y() / 2;
    m.block<4, 2>(0, 2 * i) << a, b, -b, a, a, -b, b, a;
  }
  return m;
}

template <typename Definition>
void check(const Rest_shape& shape, const Eigen::Vector2d (&u)[3], Real tolerance)
{
  Triangle_terms terms;
  triangle_terms<typename Definition::Energy>(shape, u[0], u[1], u[2], terms);
  const Matrix46 m = corner_map(shape);
  Vector6 corners;
  for(int i = 0; i < 3; ++i)
    corners.segment<2>(2 * i) = (u[i] - u[0]).cast<Real>(); // the energies do not see translations
  const Vector4 w = m * corners;
  const Differences<Definition> differences(w);

  CHECK(std::abs(terms.value - differences.energy) <= tolerance * terms.value);
  Vector6 gradient;
  Eigen::Matrix<Real, 6, 6> hessian;
  for(int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    gradient.segment<2>(2 * i) = terms.gradient[i].cast<Real>();
    hessian.block<2, 2>(2 * i, 2 * i) = terms.diagonal[i].cast<Real>();
    hessian.block<2, 2>(2 * i, 2 * j) = terms.mixed[i].cast<Real>();
    hessian.block<2, 2>(2 * j, 2 * i) = terms.mixed[i].cast<Real>().transpose();
  }
  // Where the map is nearly degenerate, large parts cancel in the products with `m`, and near a
  // similarity the gradient vanishes.
  const Matrix4 projected = clamped(differences.hessian);
  const Real gradient_scale
    = m.norm() * (differences.gradient.norm() + 1e-6L * terms.value / w.norm());
  const Real hessian_scale = m.squaredNorm() * projected.norm();
  CHECK((gradient - m.transpose() * differences.gradient).norm() <= tolerance * gradient_scale);
  CHECK((hessian - m.transpose() * projected * m).norm() <= tolerance * hessian_scale);
}

// The three numbers that the projected Hessian consists of, against the eigenvalues of the whole.
template <typename Definition>
void check_projection(const Vector4& w, Real tolerance)
{
  const double x = double(w.head<2>().squaredNorm()), y = double(w.tail<2>().squaredNorm());
  const Projected_hessian h(Definition::Energy::derivatives(x, y), x, y);
  const Matrix4 projected = clamped(Differences<Definition>(w).hessian);
  const Eigen::Vector4d expected
    = Eigen::SelfAdjointEigenSolver<Matrix4>(projected).eigenvalues().template cast<double>();
  Eigen::Matrix2d block;
  block << h.zz, h.zc, h.zc, h.cc;
  const Eigen::Vector2d along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(block).eigenvalues();
  CHECK(along[0] >= -1e-14 * along[1] && h.across_z >= 0 && h.across_conjugate >= 0);
  Eigen::Vector4d found(along[0], along[1], h.across_z, h.across_conjugate);
  std::sort(found.data(), found.data() + 4);
  CHECK((found - expected).norm() <= tolerance * expected.norm());
}

template <typename Definition>
void test_energy(CGAL::Random& random)
{
  const auto point = [&]
  { return Eigen::Vector2d(random.get_double(-1, 1), random.get_double(-1, 1)); };
  const auto is_positive = [](const Eigen::Vector2d (&p)[3], double threshold)
  {
    const Eigen::Vector2d a = p[1] - p[0], b = p[2] - p[0];
    return a.x() * b.y() - a.y() * b.x() > threshold;
  };
  for(int i = 0; i < 1000; ++i)
  {
    Eigen::Vector2d p[3], u[3];
    do
      for(int k = 0; k < 3; ++k)
      {
        p[k] = point();
        u[k] = point();
      }
    while(!is_positive(p, 1e-2) || !is_positive(u, 1e-2));
    if(i % 4 == 1) // a needle on the surface
      p[2] = 0.5 * (p[0] + p[1]) + 1e-4 * (p[2] - p[0]);
    else if(i % 4 == 2) // a cap in the plane
      u[2] = 0.3 * u[0] + 0.7 * u[1] + 1e-4 * (u[2] - u[0]);
    else if(i % 4 == 3) // a nearly similar image: f_z̄ is almost zero
      for(int k = 0; k < 3; ++k)
        u[k] = Eigen::Vector2d(-3 * p[k].y(), 3 * p[k].x()) + 1e-9 * u[k];
    check<Definition>(rest_shape(p[0], p[1], p[2]), u, 1e-6L);
  }
  for(int i = 0; i < 1000; ++i)
  {
    const Real angle = random.get_double(0, 6), turn = random.get_double(0, 6);
    const Real size = std::pow(10., random.get_double(-2, 2));
    const Real gap = i % 2 ? std::pow(10., random.get_double(-4, 0)) : random.get_double(0, 1);
    Vector4 w;
    w << std::cos(angle), std::sin(angle), (1 - gap) * std::cos(turn), (1 - gap) * std::sin(turn);
    w *= size;
    check_projection<Definition>(w, 1e-6L);
  }
}

} // namespace triangle_energy_test

int main()
{
  using namespace triangle_energy_test;
  CGAL::Random random(20);
  std::cout << "seed " << random.get_seed() << std::endl;
  test_energy<MIPS_definition>(random);
  test_energy<Symmetric_Dirichlet_definition>(random);
  return test::exit_status();
}
