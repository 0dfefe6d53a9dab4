// Where the plane has no room for a surface in one piece: a ramp that winds around several times overlaps itself laid
// flat. Without distortion, each chart may cover less than one turn.

#include "../BGL/check.h"
#include "soups.h"
#include "surface_meshes.h"
#include "valid_unwrap.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <cmath>
#include <string>
#include <vector>

namespace divided_charts_test {

namespace SMC = CGAL::Surface_mesh_cutting;

using test::Surface_mesh;
using Point_2 = test::Point_2;
using Cut_map = Surface_mesh::Property_map<Surface_mesh::Edge_index, bool>;
using UV_map = Surface_mesh::Property_map<Surface_mesh::Halfedge_index, Point_2>;

constexpr int steps_per_turn = 48, width = 4;

Surface_mesh make_ramp(double turns)
{
  const int length = int(steps_per_turn * turns);
  test::Soup soup = test::patch(length, width);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    const double angle = 2 * CGAL_PI * turns * double(v / (width + 1)) / length;
    const double radius = 2 + double(v % (width + 1)) / width;
    soup.points[v] = {radius * std::cos(angle), radius * std::sin(angle), angle / 20};
  }
  return test::make_mesh<Surface_mesh>(soup);
}

// The outlines of the charts.
std::vector<CGAL::Polygon_2<test::Exact_kernel_2> > outlines(const Surface_mesh& mesh, Cut_map is_cut, UV_map uv)
{
  std::vector<CGAL::Polygon_2<test::Exact_kernel_2> > result;
  for(const auto& loop : test::chart_borders(mesh, is_cut))
  {
    result.emplace_back();
    for(const auto h : loop)
      result.back().push_back({uv[h].x(), uv[h].y()});
  }
  return result;
}

// They lie in boxes of their own.
bool are_apart(const std::vector<CGAL::Polygon_2<test::Exact_kernel_2> >& polygons)
{
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(CGAL::do_overlap(polygons[i].bbox(), polygons[j].bbox()))
        return false;
  return true;
}

struct Maps
{
  Cut_map is_cut;
  UV_map uv;

  explicit Maps(Surface_mesh& mesh)
    : is_cut(mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:is_cut", false).first),
      uv(mesh.add_property_map<Surface_mesh::Halfedge_index, Point_2>("h:uv").first)
  {}
};

void check_charts(const Surface_mesh& mesh, const Maps& maps, std::size_t least_number, const std::string& name)
{
  CHECK(test::is_valid_unwrap(mesh, maps.is_cut, maps.uv), name + ": disks without flips");
  const auto polygons = outlines(mesh, maps.is_cut, maps.uv);
  for(const auto& polygon : polygons)
    CHECK(polygon.is_simple(), name + ": a chart overlaps itself");
  CHECK(are_apart(polygons), name + ": charts overlap");
  CHECK(polygons.size() >= least_number && 2 * polygons.size() <= 3 * least_number + 1,
        name + ": " + std::to_string(polygons.size()) + " charts");
}

constexpr double bound = 4.0005; // no map of more than a turn in one piece keeps it

void test_bound(double turns)
{
  const std::string name = std::to_string(turns) + " turns";
  Surface_mesh mesh = make_ramp(turns);
  Maps maps(mesh);
  const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv,
                                  CGAL::parameters::do_bijective(true).maximum_average_distortion(bound));
  CHECK(result && result.overlaps == 0, name + ": " + result.status.message);
  CHECK(result.average_distortion <= bound, name + ": bound");
  check_charts(mesh, maps, std::size_t(std::ceil(turns)), name);
}

// Where the bound leaves room to bend, a chart may cover more than one turn: a few seams, or slits that let a single chart
// turn aside, cost less than a seam for each turn.
void test_bent_charts()
{
  constexpr double loose_bound = 4.01, turns = 4.25;
  Surface_mesh mesh = make_ramp(turns);
  Maps maps(mesh);
  const auto tight = SMC::unwrap(mesh, maps.is_cut, maps.uv,
                                 CGAL::parameters::do_bijective(true).maximum_average_distortion(bound));
  const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv,
                                  CGAL::parameters::do_bijective(true).maximum_average_distortion(loose_bound));
  CHECK(result && result.overlaps == 0, "bent charts: " + result.status.message);
  CHECK(result.average_distortion <= loose_bound, "bent charts: bound");
  CHECK(result.cut_length < 0.5 * tight.cut_length, "bent charts: long cut");
  check_charts(mesh, maps, 1, "bent charts");
}

// Seams are as short as the width of the ramp. Without a bound, there are fewer, as long as the energy is hardly above that of
// the map with overlaps.
void test_many_turns()
{
  constexpr double turns = 20, little = 1e-6, tolerance = 0.02;
  Surface_mesh mesh = make_ramp(turns);
  Maps maps(mesh);
  const auto overlapping = SMC::unwrap(mesh, maps.is_cut, maps.uv, CGAL::parameters::do_bijective(false));
  const double energy = overlapping.average_distortion;
  const auto same = SMC::unwrap(mesh, maps.is_cut, maps.uv,
                                CGAL::parameters::do_bijective(true).maximum_average_distortion(energy + little));
  CHECK(same && same.overlaps == 0, "many turns: " + same.status.message);
  check_charts(mesh, maps, std::size_t(turns), "many turns");
  CHECK(same.average_distortion <= energy + little, "many turns: distortion");
  CHECK(same.cut_length - overlapping.cut_length < 1.5 * turns, "many turns: long seams");

  const auto bent = SMC::unwrap(mesh, maps.is_cut, maps.uv, CGAL::parameters::do_bijective(true));
  CHECK(bent && bent.overlaps == 0, "many bent turns: " + bent.status.message);
  CHECK(bent.average_distortion <= energy + tolerance, "many bent turns: distortion");
  CHECK(bent.cut_length < 0.5 * same.cut_length, "many bent turns: long seams");
  check_charts(mesh, maps, 1, "many bent turns");
}

// With nowhere to divide, a distorted map is all there is.
void test_forbidden()
{
  Surface_mesh mesh = make_ramp(1.5);
  Maps maps(mesh);
  auto is_forbidden = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:is_forbidden", true).first;
  const auto result = SMC::unwrap(mesh, maps.is_cut, maps.uv,
                                  CGAL::parameters::do_bijective(true).maximum_average_distortion(bound)
                                    .edge_is_forbidden_map(is_forbidden));
  CHECK(result.status.code == SMC::Status_code::BOUND_NOT_REACHED, "forbidden: " + result.status.message);
  CHECK(result.has_result && result.cut_length == 0 && result.average_distortion > bound, "forbidden: distortion");
  check_charts(mesh, maps, 1, "forbidden");
}

} // namespace divided_charts_test

int main()
{
  using namespace divided_charts_test;
  for(double turns : {0.5, 1.5, 2.5, 4.25})
    test_bound(turns);
  test_bent_charts();
  test_many_turns();
  test_forbidden();
  return test::exit_status();
}
