// The whole method on closed surfaces of genus 0 as meshes of all types: valid results, proven by the
// certificate, the same twice and for every thread count, and typed refusals.

#include "../BGL/check.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/cut_length.h>
#include <CGAL/Surface_mesh_cutting/detect_feature_points.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/is_cut_to_disks.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <thread>
#include <vector>

namespace unwrap_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Status_code;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

// A cut and UVs for any mesh.
template <typename Mesh>
struct Maps
{
  using Traits = boost::graph_traits<Mesh>;
  decltype(get(CGAL::dynamic_edge_property_t<bool>(), std::declval<Mesh&>())) is_cut;
  decltype(get(CGAL::dynamic_halfedge_property_t<Point_2>(), std::declval<Mesh&>())) uv;

  explicit Maps(Mesh& mesh)
    : is_cut(get(CGAL::dynamic_edge_property_t<bool>(), mesh)),
      uv(get(CGAL::dynamic_halfedge_property_t<Point_2>(), mesh))
  {}

  std::vector<double> values(Mesh& mesh) const
  {
    std::vector<double> all;
    for(auto e : edges(mesh))
      all.push_back(get(is_cut, e));
    for(auto h : halfedges(mesh))
      if(!is_border(h, mesh))
      {
        all.push_back(get(uv, h).x());
        all.push_back(get(uv, h).y());
      }
    return all;
  }
};

template <typename Mesh>
void test_valid(Mesh mesh, const char* name)
{
  Maps<Mesh> maps(mesh), again(mesh);
  const SMC::Unwrap_result<Mesh> result = SMC::unwrap(mesh, maps.is_cut, maps.uv);
  std::cout << name << ": " << result.feature_points.size() << " features, E " << result.average_distortion << std::endl;
  CHECK(result, result.status.message.c_str());
  CHECK(SMC::certify_unwrap(mesh, maps.is_cut, maps.uv), "certificate");
  CHECK(SMC::is_cut_to_disks(mesh, maps.is_cut), "disks");
  CHECK(result.genus == 0 && result.components == 1 && result.borders == 0, "topology");
  CHECK(std::abs(result.cut_length - SMC::cut_length(mesh, maps.is_cut)) <= 1e-12 * result.cut_length, "length");
  CHECK(result.average_distortion >= 4 && result.average_distortion <= 4.5 && result.largest_face_distortion >= result.average_distortion, "energy");
  CHECK(result.lower_bound && *result.lower_bound <= result.cut_length * (1 + 1e-12), "lower bound");

  // The cut is a tree through the feature points whose leaves are feature points.
  std::map<std::size_t, int> degrees;
  std::size_t number_of_edges = 0;
  auto index = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t i = 0;
  for(auto v : vertices(mesh))
    put(index, v, i++);
  for(auto e : edges(mesh))
    if(get(maps.is_cut, e))
    {
      ++number_of_edges;
      ++degrees[get(index, source(e, mesh))];
      ++degrees[get(index, target(e, mesh))];
    }
  CHECK(number_of_edges + 1 == degrees.size(), "a connected cut without cycle");
  std::map<std::size_t, bool> is_feature;
  for(auto v : result.feature_points)
  {
    is_feature[get(index, v)] = true;
    CHECK(degrees.count(get(index, v)) == 1, "a feature point on the cut");
  }
  for(const auto& [v, degree] : degrees)
    CHECK(degree > 1 || is_feature[v], "no dangling edge");

  const SMC::Unwrap_result<Mesh> parallel
    = SMC::unwrap<CGAL::Parallel_if_available_tag>(mesh, again.is_cut, again.uv);
  CHECK(parallel && maps.values(mesh) == again.values(mesh), "the same with several threads");
}

// Notices when two threads are in it.
struct Exclusive_visitor : public SMC::Default_visitor
{
  std::atomic<int> inside{0};
  std::atomic<bool> is_shared{false};

  bool go_further() { return visit(); }
  void progress(SMC::Phase, double) { visit(); }

  SMC::Run_profile profile;
  void ended(const SMC::Run_profile& p) { profile = p; }

private:
  bool visit()
  {
    if(++inside > 1)
      is_shared = true;
    std::this_thread::yield();
    --inside;
    return true;
  }
};

// Handles, borders and several components: disks and no flips, whatever the surface.
void test_topologies()
{
  struct Case { test::Soup soup; int components, genus, borders; };
  test::Soup several = test::bumpy_sphere(6);
  several.add(test::torus(16, 8));
  several.add(test::tube(8, 4));
  for(const Case& c : std::vector<Case>{{test::torus(24, 12), 1, 1, 0}, {test::tube(12, 8), 1, 0, 2},
                                  {test::patch(6, 5), 1, 0, 1}, {several, 3, 1, 2}})
  {
    test::Surface_mesh mesh = test::make_mesh<test::Surface_mesh>(c.soup);
    Maps<test::Surface_mesh> maps(mesh);
    const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv);
    CHECK(result, result.status.message.c_str());
    CHECK(result.components == c.components && result.genus == c.genus && result.borders == c.borders, "topology");
    CHECK(SMC::certify_unwrap(mesh, maps.is_cut, maps.uv), "certificate of any topology");
    CHECK(result.average_distortion < 4.5, "energy of any topology");
    Maps<test::Surface_mesh> again(mesh);
    Exclusive_visitor visitor;
    CHECK(SMC::unwrap<CGAL::Parallel_if_available_tag>(mesh, again.is_cut, again.uv,
                                                            CGAL::parameters::visitor(std::ref(visitor))) &&
            maps.values(mesh) == again.values(mesh), "the same with components in parallel");
    CHECK(!visitor.is_shared, "one thread at a time calls the visitor");
    CHECK(visitor.profile.seconds.total > 0 && visitor.profile.factorized_unknowns.total > 0, "what the run took");
    for(auto e : edges(mesh))
      CHECK(!is_border(e, mesh) || !get(maps.is_cut, e), "a border edge is not cut");
  }
  // A surface that lies flat already is not cut at all.
  test::Surface_mesh patch = test::make_mesh<test::Surface_mesh>(test::patch(1, 1));
  Maps<test::Surface_mesh> maps(patch);
  const auto result = SMC::unwrap(patch, maps.is_cut, maps.uv);
  CHECK(result && result.cut_length == 0 && result.average_distortion < 4 + 1e-9, "a flat patch stays whole");
}

// A sphere with long arms, whose chart overlaps itself; and does not if that is asked for.
void test_bijective()
{
  test::Soup soup = test::bumpy_sphere(16);
  for(std::array<double, 3>& p : soup.points)
  {
    const double factor = 1 + 1.5 * std::pow(std::sin(4 * p[0]) * std::sin(4 * p[1]) * std::cos(3 * p[2]), 2);
    p = {factor * p[0], factor * p[1], factor * p[2]};
  }
  test::Surface_mesh mesh = test::make_mesh<test::Surface_mesh>(soup);
  Maps<test::Surface_mesh> maps(mesh), flat(mesh);
  const auto quick = CGAL::parameters::connection(SMC::Connection::METRIC_CLOSURE);
  const auto bijective = quick.do_bijective(true);
  const auto plain = SMC::unwrap(mesh, maps.is_cut, maps.uv, quick);
  CHECK(plain && !plain.overlaps, "overlaps are not counted unless asked for");
  CHECK(!SMC::certify_unwrap(mesh, maps.is_cut, maps.uv, bijective), "a surface that overlaps itself");
  const auto result = SMC::unwrap(mesh, flat.is_cut, flat.uv, bijective);
  CHECK(result && result.overlaps && *result.overlaps == 0, "a bijective map");
  CHECK(SMC::certify_unwrap(mesh, flat.is_cut, flat.uv, bijective), "certificate of a bijective map");
  // The same cut, or another one where parts are in each other's way.
  bool is_same_cut = true;
  for(auto e : edges(mesh))
    is_same_cut = is_same_cut && get(maps.is_cut, e) == get(flat.is_cut, e);
  CHECK(!is_same_cut || result.average_distortion >= plain.average_distortion, "energy of a bijective map of the same cut");
  CHECK(result.cut_length < 1.1 * plain.cut_length, "the cut of a bijective map");
  CHECK(result.average_distortion < plain.average_distortion + 0.1, "energy of a bijective map");
  Maps<test::Surface_mesh> again(mesh);
  SMC::unwrap<CGAL::Parallel_if_available_tag>(mesh, again.is_cut, again.uv, bijective);
  CHECK(flat.values(mesh) == again.values(mesh), "the same bijective map with several threads");

  // Several charts, beside each other.
  test::Soup several = test::bumpy_sphere(6);
  several.add(test::torus(16, 8));
  several.add(test::tube(8, 4));
  test::Surface_mesh charts = test::make_mesh<test::Surface_mesh>(several);
  Maps<test::Surface_mesh> laid_out(charts);
  CHECK(SMC::unwrap(charts, laid_out.is_cut, laid_out.uv, bijective), "bijective map of several components");
  CHECK(SMC::certify_unwrap(charts, laid_out.is_cut, laid_out.uv, bijective), "certificate of several charts");
}

void test_scales()
{
  std::vector<double> energies;
  for(double factor : {1., 0x1p-500, 0x1p+500})
  {
    test::Soup soup = test::bumpy_sphere(8);
    soup.scale(factor);
    test::Surface_mesh mesh = test::make_mesh<test::Surface_mesh>(soup);
    Maps<test::Surface_mesh> maps(mesh);
    const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv);
    CHECK(result, "extreme scale");
    energies.push_back(result.average_distortion);
  }
  CHECK(energies[0] == energies[1] && energies[0] == energies[2], "energy does not depend on the scale");
}

// On a squashed mesh, all of whose faces are needles, a tree that connects the features in another way than the
// filter did may leave orders of magnitude more distortion.
void test_squashed()
{
  test::Surface_mesh mesh;
  CHECK(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/pipe.off"), mesh), "pipe.off is there");
  for(auto v : vertices(mesh))
    mesh.point(v) = {1e-8 * mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
  Maps<test::Surface_mesh> maps(mesh);
  const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv, CGAL::parameters::effort(SMC::Effort::FAST));
  double lowest = std::numeric_limits<double>::infinity();
  for(const SMC::Trade_off& t : result.trade_offs)
    lowest = (std::min)(lowest, t.average_distortion);
  CHECK(result && result.average_distortion < 2.01 * lowest, "connecting keeps what filtering gained");
}

void test_methods()
{
  test::Surface_mesh mesh = test::make_mesh<test::Surface_mesh>(test::bumpy_sphere(10));
  Maps<test::Surface_mesh> maps(mesh);
  double shortest = std::numeric_limits<double>::infinity(), exact = 0;
  for(SMC::Connection connection : {SMC::Connection::METRIC_CLOSURE, SMC::Connection::SHORTEST_PATH_HEURISTIC,
                                    SMC::Connection::GREEDY, SMC::Connection::EXACT, SMC::Connection::BEST})
  {
    const auto result = SMC::greedy_cut(mesh, maps.is_cut,
                                        CGAL::parameters::connection(connection).effort(SMC::Effort::FAST));
    CHECK(result && SMC::is_cut_to_disks(mesh, maps.is_cut), "connection");
    shortest = (std::min)(shortest, result.cut_length);
    if(connection == SMC::Connection::EXACT)
    {
      exact = result.cut_length;
      CHECK(result.is_optimal && *result.is_optimal, "proof");
    }
  }
  CHECK(exact <= shortest * (1 + 1e-12), "the exact tree is the shortest");
  CHECK(SMC::unwrap(mesh, maps.is_cut, maps.uv, CGAL::parameters::connection(SMC::Connection::EXACT)),
        "refinement leaves the shortest tree, whose proof is complete");
  CHECK(SMC::unwrap(mesh, maps.is_cut, maps.uv, CGAL::parameters::use_published_method(true)), "faithful");
  CHECK(SMC::unwrap(mesh, maps.is_cut, maps.uv, CGAL::parameters::effort(SMC::Effort::BEST)), "best");

  std::vector<test::Surface_mesh::Vertex_index> points;
  const auto detected = SMC::detect_feature_points(mesh, std::back_inserter(points));
  CHECK(detected && detected.feature_points.size() == points.size() && points.size() >= 2, "detection");
}

struct Stopping_visitor : public SMC::Default_visitor
{
  int calls_left;
  explicit Stopping_visitor(int calls) : calls_left(calls) {}
  bool go_further() { return --calls_left > 0; }

  int endings = 0;
  void ended(const SMC::Run_profile&) { ++endings; }
};

// The maps stay as they were where there is no result, which only a stop may leave.
void test_refusals()
{
  const auto code_of = [](const test::Soup& soup, const auto& np)
  {
    test::Surface_mesh mesh = test::make_mesh<test::Surface_mesh>(soup);
    Maps<test::Surface_mesh> maps(mesh);
    for(auto e : edges(mesh))
      put(maps.is_cut, e, true);
    const auto result = SMC::greedy_cut(mesh, maps.is_cut, np);
    if(!result.has_result)
      for(auto e : edges(mesh))
        CHECK(get(maps.is_cut, e), "nothing written on refusal");
    return result.status.code;
  };
  const auto none = CGAL::parameters::default_values();
  CHECK(code_of(test::Soup(), none) == Status_code::EMPTY_MESH, "empty");
  CHECK(code_of(test::sphere(8, 3), CGAL::parameters::minimum_area_ratio(2.)) == Status_code::WRONG_PARAMETER, "alpha");
  CHECK(code_of(test::sphere(8, 3), CGAL::parameters::minimum_distortion_decrease(std::nan(""))) ==
          Status_code::WRONG_PARAMETER, "epsilon");
  test::Soup invalid = test::sphere(8, 3);
  invalid.points[3][1] = std::numeric_limits<double>::infinity();
  CHECK(code_of(invalid, none) == Status_code::INVALID_POINT, "infinite coordinate");
  for(int calls : {1, 2, 5, 20})
  {
    Stopping_visitor visitor(calls);
    CHECK(code_of(test::bumpy_sphere(10), CGAL::parameters::visitor(std::ref(visitor))) == Status_code::STOPPED,
          "visitor");
    CHECK(visitor.endings == 1, "the end of a stopped run");
  }
  for(double seconds : {1e-9, -1., std::numeric_limits<double>::quiet_NaN()})
    CHECK(code_of(test::bumpy_sphere(10), CGAL::parameters::maximum_running_time(seconds)) == Status_code::STOPPED,
          "time limit");
}

} // namespace unwrap_test

int main()
{
  using namespace unwrap_test;
  const test::Soup soup = test::bumpy_sphere(12);
  test_valid(test::make_mesh<test::Surface_mesh>(soup), "Surface_mesh");
  test_valid(test::make_mesh_with_garbage(soup), "Surface_mesh with removed elements");
  test_valid(test::make_mesh<test::Polyhedron>(soup), "Polyhedron_3");
  test_valid(test::make_mesh<test::Linear_cell_complex>(soup), "Linear_cell_complex");

  test::Soup tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  test::Surface_mesh mesh = test::make_mesh<test::Surface_mesh>(tetrahedron);
  Maps<test::Surface_mesh> maps(mesh);
  CHECK(SMC::unwrap(mesh, maps.is_cut, maps.uv), "the smallest closed surface");

  test_topologies();
  test_bijective();
  test_scales();
  test_squashed();
  test_methods();
  test_refusals();
  return test::exit_status();
}
