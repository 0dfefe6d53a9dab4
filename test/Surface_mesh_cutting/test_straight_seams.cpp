// Straighter seams: ways between the same ends turn less and cost hardly more, alone and in maps.

#include "../BGL/check.h"
#include "star_shapes.h"
#include "symmetric_figures.h"
#include "valid_unwrap.h"

#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>
#include <CGAL/Surface_mesh_cutting/internal/straightening/straightened.h>
#include <CGAL/Surface_mesh_cutting/seam_report.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <CGAL/Random.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <utility>
#include <vector>

namespace straight_seams_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using namespace SMC::internal;
using test::Surface_mesh;

double turning_of(const Indexed_mesh& mesh, const Cut& cut, const std::vector<char>& is_kept)
{
  const Turning turning(mesh);
  const Key_paths paths(mesh, cut, is_kept);
  double sum = 0;
  for(const Key_paths::Path& path : paths.paths())
    for(const double t : turnings_along(mesh, turning, path))
      sum += std::abs(t);
  return sum;
}

// A way that turns back, or straight on; the whole angle counts as a full turn.
void test_turning(CGAL::Random& random)
{
  const Indexed_mesh mesh = test::random_star_shape(6, random);
  const Turning turning(mesh);
  for(int h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    const int next = next_halfedge(h), other = mesh.opposite(previous_halfedge(mesh.opposite(h)));
    CHECK(std::abs(turning(h, next)) < CGAL_PI && (h == other || std::isfinite(turning(h, other))));
    // Backward, a way turns to the other side.
    CHECK(std::abs(turning(h, next) + turning(mesh.opposite(next), mesh.opposite(h))) < 1e-9);
  }
}

void test_random_trees(CGAL::Random& random)
{
  double before = 0, after = 0;
  for(int round = 0; round < 20; ++round)
  {
    const Indexed_mesh mesh = test::random_star_shape(12, random);
    const Edge_constraints constraints = unconstrained(mesh);
    std::vector<int> terminals;
    std::vector<char> is_kept(mesh.number_of_vertices(), 0);
    while(terminals.size() < 5)
      if(const int v = random.get_int(0, mesh.number_of_vertices()); !std::exchange(is_kept[v], char(1)))
        terminals.push_back(v);
    const Cut cut = connect_terminals(mesh, constraints, terminals, {}, Execution::SEQUENTIAL, always_go_further).cut;
    for(const double share : {0.01, 0.1})
    {
      const Cut next = straightened(mesh, constraints, cut, is_kept, share);
      CHECK(cut_length(mesh, next) <= (1 + share) * cut_length(mesh, cut) * (1 + 1e-12));
      CHECK(turning_of(mesh, next, is_kept) <= turning_of(mesh, cut, is_kept) + 1e-9);
      CHECK(make_chart(mesh, next).euler_characteristic() == 1);
      const std::vector<int> degrees = cut_degrees(mesh, cut), next_degrees = cut_degrees(mesh, next);
      for(int v = 0; v < mesh.number_of_vertices(); ++v)
        if(is_kept[v] || (degrees[v] != 0 && degrees[v] != 2))
          CHECK(next_degrees[v] == degrees[v]);
        else
          CHECK(next_degrees[v] == 0 || next_degrees[v] == 2);
      // Any of the ways can be taken without the others.
      for(const Straightening& s : straightenings(mesh, constraints, cut, is_kept, share))
      {
        Cut one = cut;
        s.apply_to(one);
        CHECK(make_chart(mesh, one).euler_characteristic() == 1 && cut_length(mesh, one) <= (1 + share) * cut_length(mesh, cut) * (1 + 1e-12));
      }
    }
    before += turning_of(mesh, cut, is_kept);
    after += turning_of(mesh, straightened(mesh, constraints, cut, is_kept, 0.1), is_kept);
  }
  CHECK(after < 0.9 * before);
  std::cout << "turning " << before << ", straightened " << after << "\n";
}

// Edges that must not be cut stay whole.
void test_forbidden(CGAL::Random& random)
{
  const Indexed_mesh mesh = test::random_star_shape(12, random);
  Edge_constraints constraints = unconstrained(mesh);
  const Cut cut = connect_terminals(mesh, constraints, {0, mesh.number_of_vertices() / 2, mesh.number_of_vertices() - 1}, {},
                                    Execution::SEQUENTIAL, always_go_further).cut;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(!cut[e])
      constraints.weights[e] = std::numeric_limits<double>::infinity();
  CHECK(straightened(mesh, constraints, cut, std::vector<char>(mesh.number_of_vertices(), 0), 1) == cut);
}

void test_maps()
{
  Surface_mesh mesh = test::make_mesh<Surface_mesh>(test::figure(20, 14, test::Diagonals::PARALLEL));
  auto is_cut = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, test::Point_2>("h:uv").first;
  const auto run = [&](const auto& np) { return SMC::unwrap(mesh, is_cut, uv, np.do_bijective(true)); };
  for(const double bound : {std::numeric_limits<double>::infinity(), 4.2})
  {
    const auto plain = run(CGAL::parameters::seam_smoothness(0).maximum_average_distortion(bound));
    const double jagged = *SMC::seam_report(mesh, is_cut, uv).jaggedness;
    const auto smooth = run(CGAL::parameters::seam_smoothness(1).maximum_average_distortion(bound));
    const double straight = *SMC::seam_report(mesh, is_cut, uv).jaggedness;
    CHECK(plain.status && smooth.status && test::is_valid_unwrap(mesh, is_cut, uv) && test::is_injective(mesh, is_cut, uv));
    CHECK(straight <= jagged && smooth.cut_length <= 1.01 * plain.cut_length * (1 + 1e-9));
    CHECK(smooth.average_distortion <= plain.average_distortion + 0.0031 && smooth.average_distortion <= bound);
    std::cout << "jaggedness " << jagged << ", straightened " << straight << "\n";
  }
  for(const double wrong : {-1., 101., std::numeric_limits<double>::quiet_NaN()})
    CHECK(run(CGAL::parameters::seam_smoothness(wrong)).status.code == SMC::Status_code::WRONG_PARAMETER);
}

} // namespace straight_seams_test

int main(int argc, char** argv)
{
  using namespace straight_seams_test;
  CGAL::Random random(argc > 1 ? unsigned(std::atoi(argv[1])) : 1);
  std::cout << "seed " << random.get_seed() << "\n";
  test_turning(random);
  test_random_trees(random);
  test_forbidden(random);
  test_maps();
  return test::exit_status();
}
