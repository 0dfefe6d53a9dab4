// Runs that a visitor stops at any of its calls, or the time limit: they return STOPPED, whatever else they found,
// and leave the maps untouched or a valid result in them; cuts and maps of small surfaces always are a result.

#include "../BGL/check.h"
#include "random_surfaces.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/connect_points.h>
#include <CGAL/Surface_mesh_cutting/cut_handles.h>
#include <CGAL/Surface_mesh_cutting/detect_feature_points.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/is_cut_to_disks.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace stops_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Status_code;
using Mesh = test::Surface_mesh;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

// Says once that the run has to stop, and would let it go on afterwards.
struct Stopping_visitor : public SMC::Default_visitor
{
  const int stopping_call; // 0: none
  int calls = 0;

  double done = 0; // of the run
  bool is_monotone = true;

  explicit Stopping_visitor(int call) : stopping_call(call) {}
  bool go_further() { return ++calls != stopping_call; }
  void progress(SMC::Phase, double fraction)
  {
    is_monotone = is_monotone && done <= fraction && fraction <= 1;
    done = fraction;
  }
};

// Stops `call(visitor)`, which returns its status, after few, many, and all calls to the visitor.
template <typename Call>
void stop_everywhere(const std::string& name, const Call& call, int number_of_stops)
{
  Stopping_visitor whole(0);
  const Status_code code = call(whole);
  CHECK(code == Status_code::OK || code == Status_code::BOUND_NOT_REACHED, name + ": the whole run");
  std::cout << name << ": " << whole.calls << " calls" << std::endl;
  CHECK(whole.is_monotone && (whole.done == 1 || whole.done == 0), name + ": progress " + std::to_string(whole.done));
  number_of_stops = (std::min)(number_of_stops, whole.calls);
  CHECK(number_of_stops > 0, name + ": the visitor is asked");
  for(int i = 0; i < number_of_stops; ++i)
  {
    const int stopping_call = 1 + int(long(i) * (whole.calls - 1) / (std::max)(1, number_of_stops - 1));
    const std::string where = name + ", stopped at call " + std::to_string(stopping_call);
    Stopping_visitor visitor(stopping_call);
    const Status_code stopped = call(visitor);
    CHECK(stopped == Status_code::STOPPED, where + ": status " + to_string(stopped));
    CHECK(visitor.calls == stopping_call, where + ": asked again");
    CHECK(visitor.is_monotone && visitor.done < 1.0001, where + ": progress");
  }
}

struct Setting
{
  std::string name;
  test::Soup soup;
  SMC::Effort effort = SMC::Effort::DEFAULT;
  SMC::Connection connection = SMC::Connection::BEST;
  double bound = std::numeric_limits<double>::infinity();
  bool is_faithful = false, do_bijective = false, has_weights = false;
};

// A mesh and its maps, which hold what no run writes.
struct Task
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_cut;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv;
  Mesh::Property_map<Mesh::Edge_index, double> weight;

  explicit Task(const test::Soup& soup) : mesh(test::make_mesh<Mesh>(soup))
  {
    is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", true).first;
    uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", untouched()).first;
    weight = mesh.add_property_map<Mesh::Edge_index, double>("e:weight").first;
  }

  static Point_2 untouched() { return Point_2(-7, -7); }

  void set_weights(bool are_lengths)
  {
    for(auto e : edges(mesh))
    {
      const auto &p = mesh.point(source(e, mesh)), &q = mesh.point(target(e, mesh));
      weight[e] = are_lengths || p.x() > 0 ? std::sqrt(CGAL::squared_distance(p, q)) : 1;
    }
  }

  template <typename Visitor>
  auto parameters(const Setting& s, const Visitor& visitor) const
  {
    return CGAL::parameters::visitor(visitor).effort(s.effort).connection(s.connection).maximum_average_distortion(s.bound)
      .use_published_method(s.is_faithful).do_bijective(s.do_bijective).edge_weight_map(weight);
  }

  bool is_cut_untouched() const
  {
    return std::all_of(edges(mesh).begin(), edges(mesh).end(), [&](auto e) { return is_cut[e]; });
  }
  bool is_uv_untouched() const
  {
    return std::all_of(halfedges(mesh).begin(), halfedges(mesh).end(), [&](auto h) { return uv[h] == untouched(); });
  }
  bool is_cut_valid() const { return !is_cut_untouched() && SMC::is_cut_to_disks(mesh, is_cut); }
};

void test_unwrap(const Setting& s)
{
  const auto call = [&](Stopping_visitor& visitor)
  {
    Task task(s.soup);
    task.set_weights(!s.has_weights);
    const auto result = SMC::unwrap(task.mesh, task.is_cut, task.uv, task.parameters(s, std::ref(visitor)));
    CHECK(result.has_result && task.is_cut_valid() && SMC::certify_unwrap(task.mesh, task.is_cut, task.uv,
                                                                          CGAL::parameters::do_bijective(s.do_bijective)),
          "unwrap, " + s.name + ": maps");
    return result.status.code;
  };
  stop_everywhere("unwrap, " + s.name, call, 12);
}

void test_greedy_cut(const Setting& s)
{
  const auto call = [&](Stopping_visitor& visitor)
  {
    Task task(s.soup);
    task.set_weights(!s.has_weights);
    const auto result = SMC::greedy_cut(task.mesh, task.is_cut, task.parameters(s, std::ref(visitor)));
    CHECK(result.has_result && task.is_cut_valid(), "greedy_cut, " + s.name + ": map");
    return result.status.code;
  };
  stop_everywhere("greedy_cut, " + s.name, call, 6);
}

void test_detection(const Setting& s)
{
  const auto call = [&](Stopping_visitor& visitor)
  {
    Task task(s.soup);
    task.set_weights(!s.has_weights);
    std::vector<Mesh::Vertex_index> points;
    const auto result
      = SMC::detect_feature_points(task.mesh, std::back_inserter(points), task.parameters(s, std::ref(visitor)));
    CHECK(result.has_result ? points == result.feature_points : points.empty(),
          "detect_feature_points, " + s.name + ": points");
    return result.status.code;
  };
  stop_everywhere("detect_feature_points, " + s.name, call, 10);
}

// Every so many vertices.
std::vector<Mesh::Vertex_index> some_points(const Mesh& mesh, int step)
{
  std::vector<Mesh::Vertex_index> points;
  for(auto v : vertices(mesh))
    if(int(v) % step == 0)
      points.push_back(v);
  return points;
}

void test_connection(const Setting& s)
{
  const auto call = [&](Stopping_visitor& visitor)
  {
    Task task(s.soup);
    task.set_weights(!s.has_weights);
    const auto result = SMC::connect_points(task.mesh, some_points(task.mesh, 9), task.is_cut,
                                            task.parameters(s, std::ref(visitor)));
    CHECK(task.is_cut_untouched() ? result.length == 0 : task.is_cut_valid(), "connect_points, " + s.name + ": map");
    return result.status.code;
  };
  stop_everywhere("connect_points, " + s.name, call, 10);
}

void test_handles(const Setting& s)
{
  const auto call = [&](Stopping_visitor& visitor)
  {
    Task task(s.soup);
    task.set_weights(!s.has_weights);
    const auto result = SMC::cut_handles(task.mesh, task.is_cut, task.parameters(s, std::ref(visitor)));
    CHECK(result || (task.is_cut_untouched() && result.loops.empty()), "cut_handles, " + s.name + ": map");
    return result.status.code;
  };
  stop_everywhere("cut_handles, " + s.name, call, 10);
}

// Copies count their calls together; what is left of a copy that was destroyed says so.
class Passed_visitor : public SMC::Default_visitor
{
public:
  explicit Passed_visitor(int call) : m_stopping_call(call) {}
  Passed_visitor(const Passed_visitor& other) : m_calls(other.m_calls), m_stopping_call(other.m_stopping_call) {}
  ~Passed_visitor() { m_is_alive = false; }

  bool go_further()
  {
    CHECK(m_is_alive, "a visitor that lives");
    return m_is_alive && ++*m_calls != m_stopping_call;
  }
  void progress(SMC::Phase, double) { CHECK(m_is_alive, "a visitor that lives"); }
  int calls() const { return *m_calls; }

private:
  std::shared_ptr<int> m_calls = std::make_shared<int>(0);
  int m_stopping_call;
  volatile bool m_is_alive = true; // also for the compiler
};

// The statuses of all calls that take a visitor.
template <typename Visitor>
std::vector<Status_code> all_calls(const test::Soup& soup, const Visitor& visitor, double seconds = 0)
{
  Task task(soup);
  task.set_weights(true);
  const auto np = task.parameters(Setting{"", soup}, visitor).maximum_running_time(seconds);
  std::vector<Mesh::Vertex_index> points;
  return {SMC::unwrap(task.mesh, task.is_cut, task.uv, np).status.code,
          SMC::greedy_cut(task.mesh, task.is_cut, np).status.code,
          SMC::detect_feature_points(task.mesh, std::back_inserter(points), np).status.code,
          SMC::connect_points(task.mesh, some_points(task.mesh, 20), task.is_cut, np).status.code,
          SMC::cut_handles(task.mesh, task.is_cut, np).status.code};
}

void test_visitors()
{
  const test::Soup soup = test::torus(12, 6);
  const std::vector<Status_code> all_ok(5, Status_code::OK), all_stopped(5, Status_code::STOPPED);
  const Passed_visitor silent(0);
  CHECK(all_calls(soup, silent) == all_ok && silent.calls() > 0, "a visitor by value");
  CHECK(all_calls(soup, Passed_visitor(0)) == all_ok, "a temporary visitor");
  Passed_visitor referred(0);
  CHECK(all_calls(soup, std::ref(referred)) == all_ok && referred.calls() == silent.calls(), "a visitor by reference");
  const Passed_visitor stopping(1);
  CHECK(all_calls(soup, stopping).front() == Status_code::STOPPED && stopping.calls() > 1,
        "a visitor by value stops the run");
}

// Long before a run would end.
void test_time_limit()
{
  constexpr double longest = 10; // in seconds of processor time, mostly for reading the mesh five times
  const std::clock_t start = std::clock();
  Passed_visitor visitor(0);
  CHECK(all_calls(test::torus(200, 100), std::ref(visitor), 1e-9)
          == std::vector<Status_code>(5, Status_code::STOPPED), "time limit");
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  std::cout << "time limit: " << seconds << " s" << std::endl;
  CHECK(seconds < longest, "stopped at once");
}

// What the caller asks for holds for the cut of a run that is stopped at once, too: on one side of a surface no edge may be cut
// but the border, on the other side some edges must, and a vertex has to be reached.
void test_constraints(const std::string& name, const test::Soup& soup, double forbidden_from)
{
  Task task(soup);
  Mesh& mesh = task.mesh;
  auto is_forbidden = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_forbidden", false).first;
  auto is_mandatory = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_mandatory", false).first;
  auto is_terminal = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_terminal", false).first;
  const auto is_inside = [&](Mesh::Vertex_index v) { return mesh.point(v).x() > forbidden_from; };
  for(auto e : edges(mesh))
  {
    is_forbidden[e] = is_inside(source(e, mesh)) && is_inside(target(e, mesh));
    is_mandatory[e] = !is_forbidden[e] && mesh.point(source(e, mesh)).x() < -forbidden_from && int(e) % 5 == 0;
  }
  const Mesh::Vertex_index terminal = *std::min_element(vertices(mesh).begin(), vertices(mesh).end(), [&](auto v, auto w)
                                                        { return mesh.point(v).y() < mesh.point(w).y(); });
  is_terminal[terminal] = true;
  Stopping_visitor visitor(1);
  const auto result = SMC::unwrap(mesh, task.is_cut, task.uv, CGAL::parameters::visitor(std::ref(visitor))
                                  .edge_is_forbidden_map(is_forbidden).edge_is_constrained_map(is_mandatory)
                                  .vertex_is_constrained_map(is_terminal));
  CHECK(result.status.code == Status_code::STOPPED && result.has_result && task.is_cut_valid(),
        name + ": stopped, " + result.status.message);
  CHECK(SMC::certify_unwrap(mesh, task.is_cut, task.uv, CGAL::parameters::do_bijective(true)), name + ": map");
  for(auto e : edges(mesh))
    CHECK(!(task.is_cut[e] && is_forbidden[e]) && (task.is_cut[e] || !is_mandatory[e]), name + ": edge");
  CHECK(std::any_of(edges(mesh).begin(), edges(mesh).end(), [&](auto e)
                    { return task.is_cut[e] && (source(e, mesh) == terminal || target(e, mesh) == terminal); }), name + ": terminal");
}

void test_names()
{
  CHECK(to_string(Status_code::OK) == "ok" && to_string(Status_code::BOUND_NOT_REACHED) == "bound_not_reached", "statuses");
  CHECK(SMC::to_string(SMC::Phase::CANDIDATES) == "candidates" && SMC::to_string(SMC::Phase::PACK) == "pack", "phases");
}

// Summed in another order, the whole area may be less than itself.
void test_whole_area()
{
  for(int n = 4; n < 16; ++n)
  {
    Task task(test::bumpy_sphere(n));
    const auto result = SMC::greedy_cut(task.mesh, task.is_cut, CGAL::parameters::minimum_area_ratio(1.)
                                                                  .effort(SMC::Effort::FAST));
    CHECK(result && task.is_cut_valid(), "a second cut anywhere");
  }
}

} // namespace stops_test

int main()
{
  using namespace stops_test;
  const unsigned int seed = 3;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  const test::Soup sphere = test::bumpy_sphere(8), small = test::bumpy_sphere(5);
  const test::Soup genus_2 = test::random_surface(12, 8, 2, 1, random).soup;
  test::Soup several = test::bumpy_sphere(6);
  several.add(test::torus(10, 6));
  several.add(test::tube(8, 4));

  std::vector<Setting> settings;
  const auto add = [&](const std::string& name, const test::Soup& soup) -> Setting&
  {
    settings.push_back({name, soup});
    return settings.back();
  };
  add("fast", sphere).effort = SMC::Effort::FAST;
  add("default", sphere);
  add("best", small).effort = SMC::Effort::BEST;
  add("faithful", sphere).is_faithful = true;
  add("bound", small).bound = 4.05;
  add("a bound that cannot be kept", small).bound = 4 + 1e-6;
  add("bijective", sphere).do_bijective = true;
  Setting& both = add("bijective with a bound", small);
  both.do_bijective = true;
  both.bound = 4.05;
  add("weights", sphere).has_weights = true;
  Setting& exact = add("exact, best", small);
  exact.effort = SMC::Effort::BEST;
  exact.connection = SMC::Connection::EXACT;
  add("handles", genus_2);
  add("components", several).do_bijective = true;
  test::Soup both_kinds = small;
  both_kinds.add(test::tube(6, 3));
  Setting& all = add("all", both_kinds);
  all.effort = SMC::Effort::BEST;
  all.bound = 4.2;
  all.has_weights = true;

  for(const Setting& s : settings)
  {
    test_unwrap(s);
    test_greedy_cut(s);
    test_detection(s);
  }
  for(SMC::Connection connection : {SMC::Connection::EXACT, SMC::Connection::GREEDY, SMC::Connection::BEST})
    for(const test::Soup& soup : {sphere, genus_2, several})
    {
      Setting s{std::to_string(int(connection)), soup};
      s.connection = connection;
      test_connection(s);
    }
  test_handles({"genus 2", genus_2});
  test_handles({"components", several});
  test_constraints("sphere", sphere, 0.7);
  test_constraints("torus", test::torus(24, 12), 2.2);
  test_names();
  test_visitors();
  test_time_limit();
  test_whole_area();
  return test::exit_status();
}
