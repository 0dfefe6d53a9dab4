// What goes beyond the paper's method: bounded distortion, shortening, given cuts, coarser versions,
// trade-offs, and what a stopped run leaves. Results are proven by the certificate, energies are
// measured anew from the UVs.

#include "../BGL/check.h"
#include "star_shapes.h"
#include "surface_meshes.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/cut_length.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/corners.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Objective.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/distortion_tree.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/detect_features.h>
#include <CGAL/Surface_mesh_cutting/is_cut_to_disks.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>
#include <CGAL/Surface_mesh_parameterization/distortion_measures.h>

#include <CGAL/Random.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace refinement_test {

namespace SMC = CGAL::Surface_mesh_cutting;
namespace SMP = CGAL::Surface_mesh_parameterization;
using CGAL::parameters::effort;
using SMC::Status_code;
using Mesh = test::Surface_mesh;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

// A sphere with arms.
Mesh star(int n)
{
  test::Soup soup = test::sphere(2 * n, n);
  for(std::array<double, 3>& p : soup.points)
  {
    const double polar = CGAL_PI * (p[2] + 1) / (n + 2), around = std::atan2(p[1], p[0]);
    const double radius = 1 + 1.5 * std::pow(std::sin(2 * polar) * std::cos(2 * around), 2) + 0.3 * std::cos(5 * polar);
    p = {radius * std::sin(polar) * std::cos(around), radius * std::sin(polar) * std::sin(around),
         1.5 * radius * std::cos(polar)};
  }
  return test::make_mesh<Mesh>(soup);
}

struct Maps
{
  Mesh::Property_map<Mesh::Edge_index, bool> is_cut;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv;

  Maps(Mesh& mesh, const std::string& name)
    : is_cut(mesh.add_property_map<Mesh::Edge_index, bool>("e:" + name).first),
      uv(mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:" + name).first)
  {}
};

// The mean energy, from what was written.
double measure(const Mesh& mesh, const Maps& maps)
{
  std::vector<double> energies(mesh.number_of_faces());
  auto energy = boost::make_iterator_property_map(energies.begin(), get(boost::face_index, mesh));
  SMP::compute_symmetric_Dirichlet_energy(mesh, maps.uv, energy);
  double sum = 0, area = 0;
  for(Mesh::Face_index f : mesh.faces())
  {
    const auto h = mesh.halfedge(f);
    const auto &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h)),
               &c = mesh.point(mesh.target(mesh.next(h)));
    const double face_area = std::sqrt(CGAL::squared_area(a, b, c));
    sum += face_area * energies[f];
    area += face_area;
  }
  return sum / area;
}

template <typename Result>
void check_trade_offs(const Result& result)
{
  const std::vector<SMC::Trade_off>& t = result.trade_offs;
  for(std::size_t i = 1; i < t.size(); ++i)
    CHECK(t[i - 1].cut_length < t[i].cut_length && t[i - 1].average_distortion > t[i].average_distortion);
  CHECK(std::any_of(t.begin(), t.end(), [&](const SMC::Trade_off& trade_off)
                    { return std::abs(trade_off.cut_length - result.cut_length) < 1e-9 * result.cut_length; }));
}

// Of random trade-offs with costs that are equal, nearly so, or not, those remain that no other one is better than, and the
// result, which nothing claims to beat.
void test_undominated_trade_offs(CGAL::Random& random)
{
  constexpr double rounding = 1e-12;
  const auto random_trade_off = [&]
  {
    const double cost = random.get_int(1, 6) * (1 + random.get_int(-2, 3) * 1e-16);
    return SMC::Trade_off{cost, cost, 4 + random.get_int(0, 6) / 8.};
  };
  for(int repetition = 0; repetition < 1000; ++repetition)
  {
    SMC::internal::Component_result result;
    for(int i = random.get_int(0, 12); i > 0; --i)
      result.trade_offs.push_back(random_trade_off());
    const std::vector<SMC::Trade_off> all = result.trade_offs;
    const SMC::Trade_off own = random_trade_off();
    result.length = result.cost = own.cut_cost;
    result.energy = own.average_distortion;
    result.keep_undominated_trade_offs();

    const std::vector<SMC::Trade_off>& kept = result.trade_offs;
    bool is_monotonic = true, holds_result = false;
    for(std::size_t i = 0; i < kept.size(); ++i)
    {
      is_monotonic = is_monotonic && (i == 0 || (kept[i - 1].cut_cost < kept[i].cut_cost * (1 - rounding) &&
                                                 kept[i - 1].average_distortion > kept[i].average_distortion));
      holds_result = holds_result || (kept[i].cut_cost == own.cut_cost && kept[i].average_distortion == own.average_distortion);
    }
    CHECK(is_monotonic && holds_result, "undominated trade-offs: from cheap to expensive, with the result");
    for(const SMC::Trade_off& t : all) // each one is dominated, or kept, or claims to beat the result
      CHECK((t.average_distortion <= own.average_distortion && t.cut_cost <= own.cut_cost * (1 + rounding)) ||
            std::any_of(kept.begin(), kept.end(), [&](const SMC::Trade_off& k)
                        { return k.cut_cost <= t.cut_cost * (1 + rounding) && k.average_distortion <= t.average_distortion; }),
            "undominated trade-offs: none is missing");
  }
}

void test_bounds()
{
  Mesh mesh = star(16);
  Maps plain(mesh, "plain");
  const auto unbounded = SMC::unwrap(mesh, plain.is_cut, plain.uv, effort(SMC::Effort::FAST));
  CHECK(unbounded, "no bound");
  check_trade_offs(unbounded);
  double former_length = 0;
  for(double bound : {4.3, 4.1, 4.04})
  {
    Maps maps(mesh, std::to_string(bound).c_str());
    const auto np = CGAL::parameters::maximum_average_distortion(bound).effort(SMC::Effort::FAST);
    const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv, np);
    CHECK(result && SMC::certify_unwrap(mesh, maps.is_cut, maps.uv), "bounded");
    std::cout << bound << ": length " << result.cut_length << ", energy " << result.average_distortion << " " << result.status.message << std::endl;
    CHECK(measure(mesh, maps) <= bound + 1e-12, "the bound holds for what was written");
    CHECK(std::abs(measure(mesh, maps) - result.average_distortion) < 1e-9, "the energy that is reported");
    CHECK(result.cut_length > former_length, "a lower bound takes a longer cut");
    former_length = result.cut_length;
    check_trade_offs(result);

    Maps flat(mesh, ("flat" + std::to_string(bound)).c_str());
    const auto bijective = SMC::unwrap(mesh, flat.is_cut, flat.uv, np.do_bijective(true));
    std::cout << "bijective: length " << bijective.cut_length << ", energy " << bijective.average_distortion << std::endl;
    CHECK(bijective.has_result && bijective.overlaps == 0 && bijective.flips == 0, "bounded and bijective");
    CHECK(bool(bijective) == (measure(mesh, flat) <= bound + 1e-12), "a missed bound is reported");
    CHECK(bijective || bound < 4.2, "a modest bound can be kept by a bijective map");
  }
}

// The objective against known values: the power law at a bound, and the sum without one.
void test_objective()
{
  const SMC::internal::Objective sum(std::numeric_limits<double>::infinity(), 0.5);
  CHECK(std::abs(sum(2, 4.25) - 1.25) < 1e-12 && std::abs(sum.largest_energy(4.25, 0.5) - 4.5) < 1e-12, "the sum");
  CHECK(sum.rank(1, 4.2) < sum.rank(1, 4.3) && sum.rank(9, 9) < sum.rank(0, std::numeric_limits<double>::quiet_NaN()),
        "the smaller sum first, no map last");
  SMC::internal::Objective cost(4.1, 0);
  CHECK(cost.rank(9, 4.1) < cost.rank(1, 4.2) && cost.rank(1, 4.1) < cost.rank(2, 4.), "first the bound, then the cost");
  const auto is_near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  CHECK(is_near(cost(2, 4.1), 2), "at the bound");
  CHECK(is_near(cost(2, 4.2), 2 * std::cbrt(2.)) && is_near(cost(2, 4.0125), 1), "the third power of the length");
  CHECK(is_near(cost(2, 4), 0) && is_near(cost(2, 3.9), 0), "no distortion");
  CHECK(cost.can_tell(4) && cost.can_tell(4.114) && !cost.can_tell(4.116), "far above the bound");
  const double before = cost(1, 4.05);
  cost.compare_with(4.05);
  CHECK(cost(1, 4.05) > before, "length counts more as long as there is room");
  cost.compare_with(4.11);
  CHECK(cost(1, 4.11) > std::cbrt(1.1), "and less above the bound");
}

// Ways where the map is distorted cost less, by as much as it is distorted there; without distortion, all cost what they are.
void test_distortion_tree(CGAL::Random& random)
{
  namespace internal = SMC::internal;
  constexpr double ideal = 4, energy = 4.1, share = 0.1;
  const internal::Indexed_mesh mesh = test::random_star_shape(8, random);
  const internal::Problem problem{mesh, SMP::internal::rest_shapes(mesh.triangles(), mesh.points()),
                                  internal::unconstrained(mesh), {}, internal::Initial_cut(), true};
  const int a = 0, b = mesh.number_of_vertices() / 2;
  const auto tree = [&](const std::vector<double>& distortion)
  {
    return internal::distortion_tree(problem, {a, b}, distortion, energy, share,
                                     CGAL::internal::Steiner_tree::Options(), internal::Execution::SEQUENTIAL,
                                     CGAL::internal::Graph_kernel::always_go_further);
  };
  std::vector<double> distortion(mesh.number_of_vertices(), ideal);
  const double shortest = internal::cut_length(mesh, tree(distortion).cut);
  CHECK(std::abs(shortest - test::distances_by_relaxation(mesh, a)[b]) < 1e-9, "without distortion, the shortest path");

  for(double& d : distortion)
    d = ideal + random.get_double(0, 100 * (energy - ideal));
  const auto lowered = [&](const internal::Cut& cut)
  {
    double cost = 0;
    for(int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const double d = (distortion[mesh.source(mesh.halfedge(e))] + distortion[mesh.target(mesh.halfedge(e))]) / 2;
      cost += cut[e] ? mesh.length(e) / (1 + share * (d - ideal) / (energy - ideal)) : 0;
    }
    return cost;
  };
  const internal::Cut way = tree(distortion).cut;
  CHECK(internal::cut_length(mesh, way) >= shortest - 1e-9, "no way is shorter than the shortest one");
  for(int v = 0; v < mesh.number_of_vertices(); ++v) // detours
  {
    if(v == a || v == b)
      continue;
    const internal::Cut detour
      = internal::connect_terminals(mesh, problem.constraints, {a, v, b}, CGAL::internal::Steiner_tree::Options(),
                                    internal::Execution::SEQUENTIAL,
                                    CGAL::internal::Graph_kernel::always_go_further).cut;
    CHECK(lowered(way) <= lowered(detour) + 1e-9, "no detour is cheaper");
  }
}

// A default run moves ends at the bound: it finds a shorter cut than a fast run, which keeps the bound as well.
void test_moved_ends()
{
  constexpr double bound = 4.1;
  Mesh mesh = star(18);
  Maps fast(mesh, "fast"), moved(mesh, "moved");
  const auto np = CGAL::parameters::maximum_average_distortion(bound);
  const auto first = SMC::unwrap(mesh, fast.is_cut, fast.uv, np.effort(SMC::Effort::FAST));
  const auto second = SMC::unwrap(mesh, moved.is_cut, moved.uv, np);
  std::cout << "moved ends: length " << first.cut_length << " -> " << second.cut_length << std::endl;
  CHECK(second && SMC::certify_unwrap(mesh, moved.is_cut, moved.uv), "moved ends");
  CHECK(measure(mesh, moved) <= bound + 1e-12, "the bound holds with moved ends");
  CHECK(second.cut_length < 0.95 * first.cut_length, "moved ends make a cut shorter");
  check_trade_offs(second);
}

// Arms that lie on each other in the plane: slits where they are in each other's way, and seams between charts, take less of
// the cut than lowering the distortion until some cut makes room.
void test_room_at_bound(SMC::Effort effort, const std::string& name)
{
  constexpr double bound = 4.1;
  Mesh mesh = star(16);
  Maps overlapping(mesh, name + " overlapping"), injective(mesh, name + " injective");
  const auto np = CGAL::parameters::maximum_average_distortion(bound).effort(effort);
  const auto first = SMC::unwrap(mesh, overlapping.is_cut, overlapping.uv, np);
  const auto second = SMC::unwrap(mesh, injective.is_cut, injective.uv, np.do_bijective(true));
  std::cout << "room, " << name << ": length " << first.cut_length << " -> " << second.cut_length << std::endl;
  CHECK(second && second.overlaps == 0 && SMC::certify_unwrap(mesh, injective.is_cut, injective.uv), name);
  CHECK(measure(mesh, injective) <= bound + 1e-12, name + ": the bound holds without overlaps");
  CHECK(second.cut_length < 4. / 3 * first.cut_length, name + ": room takes little of the cut");
}

// Where nothing may be cut on one half of the surface, no cut flattens that; the run ends all the same,
// with a valid result.
void test_unreachable_bound()
{
  Mesh mesh = star(8);
  Maps maps(mesh, "unreachable");
  auto is_forbidden = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_forbidden", false).first;
  for(Mesh::Edge_index e : mesh.edges())
    is_forbidden[e] = mesh.point(mesh.vertex(e, 0)).z() > 0 && mesh.point(mesh.vertex(e, 1)).z() > 0;
  const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv,
                                  CGAL::parameters::maximum_average_distortion(4.001).edge_is_forbidden_map(is_forbidden));
  CHECK(result.status.code == Status_code::BOUND_NOT_REACHED && result.has_result, "a bound out of reach");
  CHECK(result.status.message.find("the bound 4.001") != std::string::npos, "the bound is told");
  CHECK(SMC::certify_unwrap(mesh, maps.is_cut, maps.uv), "certificate beyond the bound");
  for(double bound : {4., 0., -1., std::numeric_limits<double>::quiet_NaN()})
    CHECK(SMC::greedy_cut(mesh, maps.is_cut, CGAL::parameters::maximum_average_distortion(bound)).status.code ==
          Status_code::WRONG_PARAMETER, "no bound at all");
}

// Gauss and Bonnet: the curvature of a closed surface of genus 0 is 4 pi. Spread over a smooth surface, no few vertices carry it.
void test_corners(CGAL::Random& random)
{
  const std::vector<double> defects = SMC::internal::angle_defects(test::random_star_shape(8, random));
  CHECK(std::abs(std::accumulate(defects.begin(), defects.end(), 0.) - 4 * CGAL_PI) < 1e-9, "the curvature of a sphere");
}

// More work lowers what is minimized.
void test_shortening()
{
  Mesh mesh = star(16);
  Maps fast(mesh, "fast"), slow(mesh, "default");
  const auto first = SMC::unwrap(mesh, fast.is_cut, fast.uv, effort(SMC::Effort::FAST));
  const auto second = SMC::unwrap(mesh, slow.is_cut, slow.uv);
  const auto sum = [](const auto& result)
  { return result.average_distortion + 0.15 * result.cut_length / result.bounding_box_diagonal; };
  CHECK(first && second && sum(second) <= sum(first) + 1e-9, "more work, no larger sum");
}

void test_coarser_version()
{
  Mesh mesh = star(40);
  Maps coarse(mesh, "coarse"), fine(mesh, "fine");
  const auto np = effort(SMC::Effort::FAST);
  const auto first = SMC::unwrap(mesh, coarse.is_cut, coarse.uv, np.coarse_number_of_faces(800));
  const auto second = SMC::unwrap(mesh, fine.is_cut, fine.uv, np.coarse_number_of_faces(0));
  CHECK(first && second && SMC::certify_unwrap(mesh, coarse.is_cut, coarse.uv), "coarser version");
  CHECK(first.number_of_candidates < second.number_of_candidates ||
          first.feature_points.size() <= second.feature_points.size(), "fewer candidates");
  CHECK(std::abs(first.average_distortion - second.average_distortion) < 0.1, "about the same energy");
}

// The starts of the first seeds are taken whichever of these is given, so that they lead to the same cut.
void test_compared_starts()
{
  constexpr double bound = 4.1;
  Mesh mesh = star(20);
  std::vector<std::vector<bool>> cuts;
  for(unsigned int seed : {0u, 1u, 2u, 5u})
  {
    Maps maps(mesh, "seed " + std::to_string(seed));
    const auto np = CGAL::parameters::maximum_average_distortion(bound).coarse_number_of_faces(1000).random_seed(seed);
    CHECK(SMC::unwrap(mesh, maps.is_cut, maps.uv, np) && measure(mesh, maps) <= bound + 1e-12, "any seed");
    cuts.emplace_back();
    for(Mesh::Edge_index e : mesh.edges())
      cuts.back().push_back(maps.is_cut[e]);
  }
  CHECK(cuts[1] == cuts[0] && cuts[2] == cuts[0] && cuts[3] == cuts[0], "the first seeds lead to the same cut");
}

void test_given_cuts()
{
  Mesh mesh = star(10);
  Maps given(mesh, "given"), found(mesh, "found");
  CHECK(SMC::greedy_cut(mesh, given.is_cut), "a cut to start from");
  const double length = SMC::cut_length(mesh, given.is_cut);
  const auto result = SMC::unwrap(mesh, found.is_cut, found.uv,
                                  CGAL::parameters::initial_cut_map(given.is_cut).effort(SMC::Effort::FAST));
  CHECK(result && SMC::certify_unwrap(mesh, found.is_cut, found.uv), "from a given cut");
  CHECK(result.cut_length > 0.5 * length, "a given cut is extended, not replaced");

  // Seams that separate the surface, and a single edge.
  for(int e = 0; e < int(mesh.number_of_edges()); ++e)
    given.is_cut[Mesh::Edge_index(e)] = e % 3 == 0;
  const auto shortened = SMC::unwrap(mesh, found.is_cut, found.uv, CGAL::parameters::initial_cut_map(given.is_cut));
  CHECK(shortened && shortened.trade_offs.size() > 2, "seams that separate, and what lies on the way from them");
  for(Mesh::Edge_index e : mesh.edges())
    given.is_cut[e] = e == Mesh::Edge_index(0);
  CHECK(SMC::unwrap(mesh, found.is_cut, found.uv, CGAL::parameters::initial_cut_map(given.is_cut)), "one edge");
}

// Counts the questions, and stops at one of them.
struct Stopping_visitor : public SMC::Default_visitor
{
  int questions = 0, last = std::numeric_limits<int>::max();
  bool go_further() { return ++questions < last; }
};

void test_stopping()
{
  Mesh mesh = star(8);
  Maps maps(mesh, "stopped");
  const auto np = CGAL::parameters::maximum_average_distortion(4.05);
  Stopping_visitor counter;
  CHECK(SMC::unwrap(mesh, maps.is_cut, maps.uv, np.visitor(std::ref(counter))), "not stopped");
  for(int i = 0; i <= 6; ++i)
  {
    Stopping_visitor visitor;
    visitor.last = 2 + i * (counter.questions - 3) / 6;
    const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv, np.visitor(std::ref(visitor)));
    CHECK(result.status.code == Status_code::STOPPED, "stopped");
    CHECK(result.has_result && SMC::certify_unwrap(mesh, maps.is_cut, maps.uv), "each stop leaves a valid result");
  }
}

} // namespace refinement_test

int main()
{
  using namespace refinement_test;
  CGAL::Random random(CGAL::get_default_random().get_seed());
  std::cout << "seed " << random.get_seed() << std::endl;
  test_bounds();
  test_objective();
  test_undominated_trade_offs(random);
  for(int i = 0; i < 5; ++i)
    test_distortion_tree(random);
  test_corners(random);
  test_moved_ends();
  test_room_at_bound(SMC::Effort::FAST, "fast");
  test_room_at_bound(SMC::Effort::DEFAULT, "default");
  test_unreachable_bound();
  test_shortening();
  test_coarser_version();
  test_compared_starts();
  test_given_cuts();
  test_stopping();
  return test::exit_status();
}
