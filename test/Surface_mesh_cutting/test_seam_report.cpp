// Measures of seams: by hand on grids, under changes that they do not depend on, and what is refused.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_cutting/seam_report.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace seam_report_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using K = CGAL::Simple_cartesian<double>;
using Point_2 = K::Point_2;
using Point_3 = K::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Place = std::pair<int, int>; // on a grid

constexpr double pi = 3.14159265358979323846;
constexpr int size = 6; // squares along a side

bool is_close(double a, double b) { return std::abs(a - b) <= 1e-12 * (1 + std::abs(a)); }

// A grid with a diagonal in each square, flat in its map and placed by `place` in space.
struct Grid
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_cut;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv;

  Grid(const std::function<Point_3(double, double)>& place, const std::vector<Place>& way)
  {
    CGAL::make_grid(size, size, mesh, [](int i, int j) { return Point_3(i, j, 0); }, true);
    is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;
    uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
    const auto vertex = [this](const Place& p)
    {
      return *std::find_if(mesh.vertices().begin(), mesh.vertices().end(), [&](Mesh::Vertex_index v)
                           { return mesh.point(v) == Point_3(p.first, p.second, 0); });
    };
    for(std::size_t i = 1; i < way.size(); ++i)
      is_cut[mesh.edge(mesh.halfedge(vertex(way[i - 1]), vertex(way[i])))] = true;
    for(const auto h : mesh.halfedges())
      uv[h] = Point_2(mesh.point(mesh.target(h)).x(), mesh.point(mesh.target(h)).y());
    for(const auto v : mesh.vertices())
      mesh.point(v) = place(mesh.point(v).x(), mesh.point(v).y());
  }

  SMC::Seam_report<Mesh> report() const { return SMC::seam_report(mesh, is_cut, uv); }
};

Point_3 flat(double x, double y) { return Point_3(x, y, 0); }
Point_3 folded(double x, double y) { return x < 3 ? Point_3(x, y, 0) : Point_3(3, y, x - 3); }

const std::vector<Place> straight = {{3, 1}, {3, 2}, {3, 3}, {3, 4}};
const std::vector<Place> stairs = {{1, 1}, {2, 1}, {2, 2}, {3, 2}, {3, 3}, {4, 3}, {4, 4}};

void test_straight_seam()
{
  const SMC::Seam_report<Mesh> r = Grid(flat, straight).report();
  CHECK(r && r.jaggedness && *r.jaggedness < 1e-12);
  CHECK(r.on_hard_edges && *r.on_hard_edges == 0);
  CHECK(r.hidden && *r.hidden == 0);
  const double perimeter = 4 * size + 2 * 3; // both sides of the cut
  CHECK(is_close(r.compactness, 4 * pi * size * size / (perimeter * perimeter)));
  CHECK(is_close(r.convexity, 1));
}

// The turnings are 90 degrees to the left and to the right.
void test_stairs()
{
  const SMC::Seam_report<Mesh> r = Grid(flat, stairs).report();
  const double number_of_edges = 2 * size * (size + 1) + size * size;
  const double edge_length = (2 * size * (size + 1) + size * size * std::sqrt(2.)) / number_of_edges;
  // Five vertices, whose windows hold 3, 4, 5, 4 and 3 turnings: an odd number leaves one of them.
  const double excess = pi / 2 * (5 - 3 * 0.2);
  CHECK(r && r.jaggedness && is_close(*r.jaggedness, excess * edge_length / 6));
}

// A corner that a way takes to stay on its course, as around a window, is no zigzag to the same degree.
void test_bend()
{
  const std::vector<Place> arc = {{1, 4}, {1, 3}, {2, 2}, {3, 1}, {4, 1}};
  CHECK(*Grid(flat, arc).report().jaggedness < 0.6 * *Grid(flat, stairs).report().jaggedness);
}

void test_fold()
{
  SMC::Seam_report<Mesh> r = Grid(folded, straight).report();
  CHECK(r && is_close(*r.on_hard_edges, 1) && *r.jaggedness < 1e-12);
  CHECK(*r.hidden == 0 || *r.hidden > 0.2); // on the side of the normals, or hidden in the fold
  const SMC::Seam_report<Mesh> half = Grid([](double x, double y) { return folded(x, y); }, {{1, 3}, {2, 3}, {3, 3}, {3, 2}, {3, 1}}).report();
  CHECK(half && is_close(*half.on_hard_edges, 0.5));
}

// A mesh of other size, place and numbering has the same measures.
void test_invariance()
{
  const SMC::Seam_report<Mesh> r = Grid(folded, stairs).report();
  const K::Aff_transformation_3 motion(0, -7, 0, 1e3, 7, 0, 0, 5, 0, 0, 7, 2);
  const SMC::Seam_report<Mesh> moved
    = Grid([&](double x, double y) { return motion(folded(x, y)); }, {stairs.rbegin(), stairs.rend()}).report();
  CHECK(std::abs(*r.jaggedness - *moved.jaggedness) < 1e-9);
  CHECK(std::abs(*r.on_hard_edges - *moved.on_hard_edges) < 1e-9);
  CHECK(r.compactness == moved.compactness && r.convexity == moved.convexity);
}

void test_no_seam()
{
  const SMC::Seam_report<Mesh> r = Grid(flat, {}).report();
  CHECK(r && !r.jaggedness && !r.on_hard_edges && !r.hidden);
  CHECK(is_close(r.compactness, pi / 4));
}

// Two charts count by their areas.
void test_charts()
{
  std::vector<Place> across;
  for(int j = 0; j <= size; ++j)
    across.emplace_back(2, j);
  const SMC::Seam_report<Mesh> r = Grid(flat, across).report();
  const auto of_rectangle = [](double a, double b) { return 4 * pi * a * b / (4 * (a + b) * (a + b)); };
  CHECK(r && is_close(r.compactness, (of_rectangle(2, size) * 2 + of_rectangle(4, size) * 4) / size));
  CHECK(is_close(r.convexity, 1));
}

// A corner of the square moves in, between its neighbors on the border at (1, 0) and (0, 1).
void test_concave_chart()
{
  Grid grid(flat, straight);
  for(const auto h : grid.mesh.halfedges())
    if(grid.uv[h] == Point_2(0, 0))
      grid.uv[h] = Point_2(1.5, 1.5);
  CHECK(is_close(grid.report().convexity, (size * size - 1.5) / (size * size - 0.5)));
}

void test_refusals()
{
  Grid grid(flat, straight);
  grid.uv[*grid.mesh.halfedges().begin()] = Point_2(std::numeric_limits<double>::quiet_NaN(), 0);
  grid.uv[*std::next(grid.mesh.halfedges().begin())] = Point_2(std::numeric_limits<double>::quiet_NaN(), 0);
  CHECK(grid.report().status.code == SMC::Status_code::NOT_CERTIFIED);
  Mesh empty;
  CHECK(SMC::seam_report(empty, empty.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first,
                         empty.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first).status.code
        == SMC::Status_code::EMPTY_MESH);
}

} // namespace seam_report_test

int main()
{
  using namespace seam_report_test;
  test_straight_seam();
  test_stairs();
  test_bend();
  test_fold();
  test_invariance();
  test_no_seam();
  test_charts();
  test_concave_chart();
  test_refusals();
  return test::exit_status();
}
