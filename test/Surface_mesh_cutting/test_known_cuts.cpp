// Cuts under constraints on surfaces where the answer is known, at sizes with and without a coarser version.

#include "../BGL/check.h"
#include "surface_meshes.h"
#include "valid_unwrap.h"

#include <CGAL/Surface_mesh_cutting/crease_weights.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace known_cuts_test {

namespace SMC = CGAL::Surface_mesh_cutting;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace parameters = CGAL::parameters;
using test::Soup;
using Mesh = test::Surface_mesh;
using Edge = Mesh::Edge_index;
using Vertex = Mesh::Vertex_index;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Surface
{
  Mesh mesh;
  Mesh::Property_map<Edge, double> weight = mesh.add_property_map<Edge, double>("e:weight").first;
  Mesh::Property_map<Edge, bool> is_cut = mesh.add_property_map<Edge, bool>("e:is_cut").first;
  Mesh::Property_map<Mesh::Halfedge_index, test::Point_2> uv
    = mesh.add_property_map<Mesh::Halfedge_index, test::Point_2>("h:uv").first;

  explicit Surface(const Soup& soup) : mesh(test::make_mesh<Mesh>(soup))
  {
    for(const Edge e : mesh.edges())
      weight[e] = length(e);
  }

  double length(Edge e) const { return PMP::edge_length(mesh.halfedge(e), mesh); }
  const Mesh::Point& end(Edge e, int i) const { return mesh.point(mesh.vertex(e, i)); }

  // Whether `predicate` holds for all edges of the cut.
  template <typename Predicate>
  bool all_of_cut(Predicate predicate) const
  {
    return std::all_of(mesh.edges().begin(), mesh.edges().end(), [&](Edge e) { return !is_cut[e] || predicate(e); });
  }

  template <typename NamedParameters>
  SMC::Unwrap_result<Mesh> unwrap(const NamedParameters& np, const std::string& name)
  {
    const auto result = SMC::unwrap(mesh, is_cut, uv, np.edge_weight_map(weight));
    CHECK(result, name + ": " + result.status.message);
    CHECK(test::is_valid_unwrap(mesh, is_cut, uv), name + ": disks without flips");
    return result;
  }
};

// Along a tube, any straight line between its borders is a shortest cut, and the tube unrolls without distortion.
void test_cylinder(int around, int along)
{
  const std::string name = "cylinder of " + std::to_string(2 * around * along) + " triangles";
  Surface tube(test::tube(around, along));
  const auto is_expensive = [&](Edge e) { return tube.end(e, 0).x() < 0 || tube.end(e, 1).x() < 0; };
  for(const Edge e : tube.mesh.edges())
    if(is_expensive(e))
      tube.weight[e] *= 2;
  const auto result = tube.unwrap(parameters::all_default(), name);
  CHECK(tube.all_of_cut([&](Edge e) { return !is_expensive(e); }), name + ": the cut stays on the cheap half");
  CHECK(std::abs(result.cut_cost - along) < 1e-9 * along, name + ": the cut is a straight line");
  CHECK(result.average_distortion < 4 + 1e-6, name + ": no distortion");
}

// A ball with a long spike, whose tip ends each good cut.
Soup spiked_ball(int n)
{
  Soup soup = test::sphere(2 * n, n);
  for(std::array<double, 3>& p : soup.points)
  {
    const double polar = CGAL_PI * (p[2] + 1) / (n + 2), around = std::atan2(p[1], p[0]);
    const double radius = 1 + 2 * std::exp(-CGAL::square(CGAL_PI - polar) * 8);
    p = {radius * std::sin(polar) * std::cos(around), radius * std::sin(polar) * std::sin(around),
         -radius * std::cos(polar)};
  }
  return soup;
}

void test_forbidden_tip(int n)
{
  const double height = 1.8; // of the cap, whose tip is at 3
  Surface free(spiked_ball(n)), capped(spiked_ball(n));
  const std::string name = "spike of " + std::to_string(free.mesh.number_of_faces()) + " triangles";
  const auto top = [](const Surface& surface)
  {
    double z = -infinity;
    for(const Edge e : surface.mesh.edges())
      if(surface.is_cut[e])
        z = (std::max)({z, surface.end(e, 0).z(), surface.end(e, 1).z()});
    return z;
  };
  free.unwrap(parameters::all_default(), name);
  CHECK(top(free) > 2.5, name + ": the best cut ends at the tip");
  for(const Edge e : capped.mesh.edges())
    if((std::max)(capped.end(e, 0).z(), capped.end(e, 1).z()) > height)
      capped.weight[e] = infinity;
  capped.unwrap(parameters::all_default(), name + " with a cap");
  CHECK(top(capped) <= height && top(capped) > 0.6 * height, name + ": the cut ends near the cap");
}

// A cube of edge length 1 with n by n squares on each side.
Soup cube(int n)
{
  Soup soup;
  std::map<std::array<int, 3>, std::size_t> index;
  const auto vertex = [&](const std::array<int, 3>& p)
  {
    const auto found = index.emplace(p, soup.points.size());
    if(found.second)
      soup.points.push_back({p[0] / double(n), p[1] / double(n), p[2] / double(n)});
    return found.first->second;
  };
  for(int axis = 0; axis < 3; ++axis)
    for(const bool is_upper : {false, true})
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j)
        {
          const auto corner = [&](int di, int dj)
          {
            std::array<int, 3> p;
            p[axis] = is_upper ? n : 0;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            return vertex(p);
          };
          const std::size_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          soup.faces.push_back(is_upper ? std::vector<std::size_t>{a, b, c} : std::vector<std::size_t>{c, b, a});
          soup.faces.push_back(is_upper ? std::vector<std::size_t>{a, c, d} : std::vector<std::size_t>{d, c, a});
        }
  return soup;
}

// A cube unfolds without distortion along a tree through its corners, and no such tree costs less than seven of its
// edges.
void test_box(int n, bool is_forbidden)
{
  Surface box(cube(n));
  const std::string name = "box of " + std::to_string(box.mesh.number_of_faces()) + " triangles, sides "
                           + (is_forbidden ? "forbidden" : "expensive");
  const auto is_on_crease = [&](Edge e)
  {
    int number_of_sides = 0; // that hold the edge
    for(int axis = 0; axis < 3; ++axis)
      number_of_sides += box.end(e, 0)[axis] == box.end(e, 1)[axis] &&
                         (box.end(e, 0)[axis] == 0 || box.end(e, 0)[axis] == 1);
    return number_of_sides == 2;
  };
  SMC::crease_weights(box.mesh, box.weight);
  if(is_forbidden)
    for(const Edge e : box.mesh.edges())
      if(!is_on_crease(e))
        box.weight[e] = infinity;
  const auto is_corner = box.mesh.add_property_map<Vertex, bool>("v:is_corner", false).first;
  for(const Vertex v : box.mesh.vertices())
  {
    const Mesh::Point& p = box.mesh.point(v);
    is_corner[v] = (p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1) && (p.z() == 0 || p.z() == 1);
  }
  const auto result = box.unwrap(parameters::vertex_is_constrained_map(is_corner), name);
  CHECK(box.all_of_cut(is_on_crease), name + ": all seams are edges of the box");
  CHECK(std::abs(result.cut_length - 7) < 1e-9, name + ": seven of them");
  CHECK(result.average_distortion < 4 + 1e-6, name + ": no distortion");
}

// Marked edges, forbidden ones, vertices, a cut to start from, weights, a bound, and no overlaps.
void test_all_constraints(int n)
{
  Surface surface(test::bumpy_sphere(n));
  Mesh& mesh = surface.mesh;
  const std::string name = "all constraints, " + std::to_string(mesh.number_of_faces()) + " triangles";
  const auto must = mesh.add_property_map<Edge, bool>("e:must", false).first;
  const auto never = mesh.add_property_map<Edge, bool>("e:never", false).first;
  const auto initial = mesh.add_property_map<Edge, bool>("e:initial", false).first;
  const auto is_terminal = mesh.add_property_map<Vertex, bool>("v:is_terminal", false).first;
  for(const Edge e : mesh.edges())
  {
    // vertices of the tube are numbered along lines from pole to pole
    const int a = int(mesh.vertex(e, 0)), b = int(mesh.vertex(e, 1)), tube = 2 * n * (n + 1);
    const bool is_along = a < tube && b < tube && a / (n + 1) == b / (n + 1);
    const int line = a / (n + 1), place = (std::min)(a, b) % (n + 1);
    must[e] = is_along && line == n / 2 && place > n / 3 && place < n / 2;
    initial[e] = is_along && line == 3 * n / 2;
    never[e] = (std::max)(surface.end(e, 0).z(), surface.end(e, 1).z()) > 1.2;
    if(surface.end(e, 0).y() + surface.end(e, 1).y() > 0)
      surface.weight[e] *= 5;
  }
  for(const int v : {n / 4, 5 * (n + 1) + n / 2, 3 * n / 2 * (n + 1) + n / 4})
    is_terminal[Vertex(Mesh::size_type(v))] = surface.mesh.point(Vertex(Mesh::size_type(v))).z() < 1.2;

  constexpr double bound = 4.4;
  const auto result = surface.unwrap(parameters::edge_is_constrained_map(must).edge_is_forbidden_map(never)
                                       .vertex_is_constrained_map(is_terminal).initial_cut_map(initial)
                                       .maximum_average_distortion(bound).do_bijective(true), name);
  CHECK(result.average_distortion <= bound, name + ": the bound");
  CHECK(test::is_injective(mesh, surface.is_cut, surface.uv), name + ": no overlaps");
  for(const Edge e : mesh.edges())
  {
    CHECK(!must[e] || surface.is_cut[e], name + ": a marked edge is not cut");
    CHECK(!never[e] || !surface.is_cut[e], name + ": a forbidden edge is cut");
  }
  for(const Vertex v : mesh.vertices())
  {
    const auto around = mesh.halfedges_around_target(mesh.halfedge(v));
    CHECK(!is_terminal[v] || std::any_of(around.begin(), around.end(), [&](auto h) { return surface.is_cut[mesh.edge(h)]; }),
          name + ": a marked vertex is not on the cut");
  }
}

} // namespace known_cuts_test

int main()
{
  using namespace known_cuts_test;
  for(const auto& [around, along] : {std::array<int, 2>{{32, 12}}, std::array<int, 2>{{96, 40}}})
    test_cylinder(around, along);
  for(const int n : {20, 48})
    test_forbidden_tip(n);
  for(const int n : {8, 26})
    for(const bool is_forbidden : {false, true})
      test_box(n, is_forbidden);
  for(const int n : {24, 48})
    test_all_constraints(n);
  return test::exit_status();
}
