// The exact flip test against rational arithmetic.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>

#include <cmath>
#include <limits>
#include <vector>

namespace exact_flips_test {

using namespace CGAL::Surface_mesh_parameterization::internal;
using Eigen::Vector2d;

bool is_counterclockwise_rational(const Vector2d& a, const Vector2d& b, const Vector2d& c)
{
  using FT = CGAL::Exact_rational;
  const FT ax(a.x()), ay(a.y());
  return (FT(b.x()) - ax) * (FT(c.y()) - ay) - (FT(b.y()) - ay) * (FT(c.x()) - ax) > 0;
}

// Points so close to the diagonal that the double determinant is wrong for many of them.
void test_nearly_collinear(double scale)
{
  const double ulp = std::ldexp(1., -53);
  const Vector2d b(12, 12), c(24, 24);
  int positive = 0, naive_errors = 0;
  for(int i = 0; i < 64; ++i)
    for(int j = 0; j < 64; ++j)
    {
      const Vector2d a(0.5 + i * ulp, 0.5 + j * ulp);
      const Vector2d p = scale * a, q = scale * b, r = scale * c;
      const bool expected = is_counterclockwise_rational(p, q, r);
      CHECK(is_counterclockwise(p, q, r) == expected);
      CHECK(is_counterclockwise(q, r, p) == expected);
      CHECK(is_counterclockwise(r, p, q) == expected);
      positive += expected;
      naive_errors += ((q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x()) > 0) != expected;
    }
  CHECK(0 < positive && positive < 64 * 64);
  CHECK(naive_errors > 0);
}

void test_random(CGAL::Random& random)
{
  for(int i = 0; i < 20000; ++i)
  {
    // Few bits make many collinear triples, exponents reach underflow and overflow.
    const int e = random.get_int(-1070, 1020);
    Vector2d p[3];
    for(Vector2d& q : p)
      q = Vector2d(std::ldexp(random.get_int(-4, 5), e), std::ldexp(random.get_int(-4, 5), e));
    CHECK(is_counterclockwise(p[0], p[1], p[2]) == is_counterclockwise_rational(p[0], p[1], p[2]));
  }
}

void test_count()
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vector2d> uv
    = {Vector2d(0, 0), Vector2d(1, 0), Vector2d(0, 1), Vector2d(2, 0), Vector2d(nan, 1), Vector2d(0, infinity)};
  const std::vector<Triangle> triangles
    = {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}, {0, 1, 4}, {0, 1, 5}, {1, 3, 2}, {0, 0, 1}};
  std::vector<int> witness;
  CHECK(count_flips(triangles, uv, &witness) == 5);
  CHECK((witness == std::vector<int>{1, 2, 3, 4, 6}));
  CHECK(count_flips(triangles, uv) == 5);
}

} // namespace exact_flips_test

int main()
{
  using namespace exact_flips_test;
  test_nearly_collinear(1);
  test_nearly_collinear(std::ldexp(1., 1000));
  test_nearly_collinear(std::ldexp(1., -1000));
  CGAL::Random random(7);
  test_random(random);
  test_count();
  return test::exit_status();
}
