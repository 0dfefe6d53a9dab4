// Packed charts against a test of all pairs of border edges, known answers, and damage that the certificate must find.

#include "../BGL/check.h"
#include "charts_to_pack.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>

namespace pack_charts_test {

void test_random_charts(CGAL::Random& random)
{
  for(const int number : {2, 7, 30})
    for(const double margin : {0., 2., 7.5})
    {
      Charts charts = random_stars(random, number);
      Charts others = copy_of(charts);
      const auto np = parameters::margin(margin).texture_size(512);
      const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, np);
      CHECK(result && result.number_of_charts == number);
      check_distances(charts, margin, 512);
      check_similarity(charts, result.scale);
      CHECK(CGAL::Surface_mesh_cutting::certify_packing(charts.mesh, charts.is_cut, charts.uv, np));
      CHECK(std::abs(result.fill - area_of(charts)) < 1e-9);
      std::cout << number << " charts, margin " << margin << ": fill " << result.fill << std::endl;

      CGAL::Surface_mesh_cutting::pack_charts<CGAL::Parallel_if_available_tag>(others.mesh, others.is_cut, others.uv, np);
      for(const auto h : charts.mesh.halfedges())
        CHECK(charts.uv[h] == others.uv[h]);
    }
}

// Charts lie apart with any effort, and more effort does not fill much less: searches are different ones.
void test_efforts(CGAL::Random& random)
{
  for(const int number : {2, 9, 120})
  {
    const Charts charts = random_stars(random, number);
    double former = 0;
    for(const Effort effort : {Effort::FAST, Effort::DEFAULT, Effort::BEST})
    {
      if(number > 100 && effort != Effort::FAST)
        continue; // takes half a minute
      Charts packed = copy_of(charts);
      const auto np = parameters::effort(effort).texture_size(512);
      const auto result = CGAL::Surface_mesh_cutting::pack_charts(packed.mesh, packed.is_cut, packed.uv, np);
      CHECK(result && result.number_of_charts == number);
      CHECK(CGAL::Surface_mesh_cutting::certify_packing(packed.mesh, packed.is_cut, packed.uv, np));
      check_similarity(packed, result.scale);
      std::cout << number << " charts, effort " << int(effort) << ": fill " << result.fill << std::endl;
      CHECK(result.fill > 0.95 * former);
      former = result.fill;
    }
  }
}

void test_one_chart()
{
  Charts charts; // a square that stands on a corner
  charts.add({{3, 0}, {4, 1}, {3, 2}, {2, 1}}, {3, 1});
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, parameters::margin(16));
  const double side = 1 - 2 * 16. / 1024;
  CHECK(result && result.number_of_charts == 1);
  CHECK(std::abs(result.fill - side * side) < 1e-3 && std::abs(result.scale - side / std::sqrt(2)) < 1e-3);
  check_distances(charts, 16, 1024);
}

// A small chart lies in the bay of a large one, and another one in its hole.
void test_bay_and_hole()
{
  Charts charts;
  charts.add_triangles({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 7}, {4, 5, 6}, {4, 6, 7}});
  charts.add({{5, 5}, {6, 5}, {6, 5.5}, {5, 5.5}}, {5.5, 5.25});
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv);
  CHECK(result && result.scale > 0.97 / 3);

  Charts frame;
  frame.add_triangles({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}},
                      {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}});
  frame.add({{5, 5}, {5.8, 5}, {5.8, 5.8}, {5, 5.8}}, {5.4, 5.4});
  const auto framed = CGAL::Surface_mesh_cutting::pack_charts(frame.mesh, frame.is_cut, frame.uv);
  CHECK(framed && framed.scale > 0.97 / 3);
  check_distances(frame, 2, 1024);
}

// The long chart limits the scale; it has to lie along the diagonal, and the others beside it.
void test_limit()
{
  Charts charts;
  charts.add({{0, 0}, {10, 0}, {10, 1}, {0, 1}}, {5, 0.5});
  charts.add({{20, 0}, {21, 0}, {21, 1}, {20, 1}}, {20.5, 0.5});
  charts.add({{30, 0}, {31, 0}, {30, 1}}, {30.3, 0.3});
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv);
  const double limit = (1 - 4. / 1024) * std::sqrt(2) / 11; // a rectangle turned by 45 degrees
  CHECK(result && result.scale > 0.99 * limit && result.scale <= limit);
  check_distances(charts, 2, 1024);
}

// Polygons, whose triangles share corners: each corner keeps its place in its chart.
void test_polygons()
{
  Charts charts;
  for(const double x : {0., 5.}) // two strips of quadrilaterals
  {
    std::vector<Mesh::Vertex_index> vertices;
    for(int i = 0; i < 8; ++i)
      vertices.push_back(charts.mesh.add_vertex(Kernel::Point_3(x + i / 2 + 0.2 * (i % 2), 2 * (i % 2), 0)));
    for(std::size_t i = 0; i + 3 < vertices.size(); i += 2)
      charts.mesh.add_face(vertices[i], vertices[i + 2], vertices[i + 3], vertices[i + 1]);
  }
  charts.put_uvs();
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv);
  CHECK(result && result.number_of_charts == 2);
  check_similarity(charts, result.scale);
  check_distances(charts, 2, 1024);
  for(const auto v : charts.mesh.vertices())
    for(const auto h : halfedges_around_target(v, charts.mesh))
      for(const auto other : halfedges_around_target(v, charts.mesh))
        CHECK(charts.mesh.is_border(h) || charts.mesh.is_border(other) || charts.uv[h] == charts.uv[other]);
}

// The certificate finds a chart moved by a little, and one moved into another one's hole without a margin.
void test_damage(CGAL::Random& random)
{
  Charts charts = random_stars(random, 12);
  const auto certify = [&]
  { return CGAL::Surface_mesh_cutting::certify_packing(charts.mesh, charts.is_cut, charts.uv).code; };
  CHECK(certify() == Status_code::NOT_CERTIFIED);
  CHECK(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv));
  CHECK(certify() == Status_code::OK);
  // Turned about the middle of the square, all distances stay, but those to its border.
  for(const auto h : charts.mesh.halfedges())
    charts.uv[h] = Kernel::Point_2(charts.uv[h].x() - 0.002, charts.uv[h].y());
  CHECK(certify() == Status_code::NOT_CERTIFIED);

  Charts pair; // exactly the margin apart, which is a sixteenth here
  pair.add({{0.25, 0.25}, {0.375, 0.25}, {0.375, 0.375}, {0.25, 0.375}}, {0.3125, 0.3125});
  pair.add({{0.4375, 0.25}, {0.5, 0.25}, {0.5, 0.375}, {0.4375, 0.375}}, {0.46875, 0.3125});
  const auto sixteenth = parameters::margin(2).texture_size(32);
  const auto certify_pair = [&]
  { return CGAL::Surface_mesh_cutting::certify_packing(pair.mesh, pair.is_cut, pair.uv, sixteenth).code; };
  CHECK(certify_pair() == Status_code::OK);
  for(const auto h : pair.mesh.halfedges())
    if(pair.uv[h] == Kernel::Point_2(0.4375, 0.25))
      pair.uv[h] = Kernel::Point_2(std::nextafter(0.4375, 0.), 0.25);
  CHECK(certify_pair() == Status_code::NOT_CERTIFIED);
}

struct Stopping_visitor : CGAL::Surface_mesh_cutting::Default_visitor
{
  bool go_further() { return false; }
};

struct Recording_visitor : CGAL::Surface_mesh_cutting::Default_visitor
{
  void progress(CGAL::Surface_mesh_cutting::Phase phase, double fraction)
  {
    CHECK(phase == CGAL::Surface_mesh_cutting::Phase::PACK);
    fractions.push_back(fraction);
  }

  std::vector<double> fractions;
};

void test_progress(CGAL::Random& random)
{
  for(const int number : {1, 5, 101})
  {
    Charts charts = random_stars(random, number);
    Recording_visitor visitor;
    CHECK(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv,
                                                  parameters::visitor(std::ref(visitor))));
    CHECK(visitor.fractions.front() == 0 && visitor.fractions.back() == 1);
    CHECK(std::is_sorted(visitor.fractions.begin(), visitor.fractions.end()));
    CHECK(number == 1 || visitor.fractions.size() > 2);
  }
}

void test_errors(CGAL::Random& random)
{
  Charts charts = random_stars(random, 3);
  const std::vector<Kernel::Point_2> before(charts.uv.begin(), charts.uv.end());
  const auto code = [&](const auto& np)
  {
    const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, np);
    CHECK(result.has_result || std::equal(before.begin(), before.end(), charts.uv.begin()));
    return result.status.code;
  };
  CHECK(code(parameters::margin(-1)) == Status_code::WRONG_PARAMETER);
  CHECK(code(parameters::margin(8).texture_size(16)) == Status_code::WRONG_PARAMETER);
  CHECK(code(parameters::margin(std::nan(""))) == Status_code::WRONG_PARAMETER);
  CHECK(code(parameters::texture_size(0)) == Status_code::WRONG_PARAMETER);
  CHECK(code(parameters::margin(7.9).texture_size(16)) == Status_code::INFEASIBLE_CONSTRAINTS);
  const auto mirror = [&]
  {
    for(const auto h : charts.mesh.halfedges())
      charts.uv[h] = Kernel::Point_2(-charts.uv[h].x(), charts.uv[h].y());
  };
  mirror();
  const auto flipped = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv);
  CHECK(flipped.status.code == Status_code::NOT_CERTIFIED && flipped.status.faces.size() == charts.mesh.number_of_faces());
  mirror();
  CHECK(code(parameters::visitor(Stopping_visitor())) == Status_code::STOPPED);
  CHECK(code(parameters::maximum_running_time(-1.)) == Status_code::STOPPED);
  check_distances(charts, 2, 1024);
  CHECK(code(parameters::margin(1)) == Status_code::OK);
}

// Charts that are mirrored, and one that is folded: moved as they are, and apart.
void test_flips(CGAL::Random& random)
{
  Charts charts = random_stars(random, 9);
  const std::size_t star_faces = charts.mesh.number_of_faces();
  charts.add_triangles({{0, 0}, {2, 0}, {1, 1}, {1.2, 0.1}}, {{0, 1, 2}, {1, 0, 3}}); // the second one on the first one
  for(const auto face : charts.mesh.faces())
  {
    Mesh::Vertex_index middle(0); // of a star: its last vertex
    for(const auto v : vertices_around_face(charts.mesh.halfedge(face), charts.mesh))
      middle = (std::max)(middle, v);
    for(const auto h : halfedges_around_face(charts.mesh.halfedge(face), charts.mesh))
      if(std::size_t(face) < star_faces && std::size_t(middle) % 2 == 0)
        charts.uv[h] = Kernel::Point_2(-charts.uv[h].x(), charts.uv[h].y());
  }
  const std::vector<Kernel::Point_2> before(charts.uv.begin(), charts.uv.end());
  const auto np = parameters::do_bijective(false).texture_size(512);
  CHECK(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, np).status.code
        == Status_code::NOT_CERTIFIED);
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, np.allow_flips(true));
  CHECK(result && result.number_of_charts == 10 && result.fill > 0.3);
  check_distances(charts, 2, 512);
  for(const auto face : charts.mesh.faces())
  {
    const auto h = charts.mesh.halfedge(face), n = charts.mesh.next(h), p = charts.mesh.prev(h);
    const auto b = [&](Mesh::Halfedge_index i) { return before[std::size_t(i)]; };
    CHECK(CGAL::orientation(b(h), b(n), b(p)) == CGAL::orientation(charts.uv[h], charts.uv[n], charts.uv[p]));
    const double length = std::sqrt(CGAL::squared_distance(b(h), b(n)));
    CHECK(std::abs(std::sqrt(CGAL::squared_distance(charts.uv[h], charts.uv[n])) - result.scale * length) < 1e-9);
  }
}

// A fan of more than a full turn: its first triangle and its last one overlap.
void test_overlap()
{
  constexpr int triangles = 8;
  std::vector<Kernel::Point_2> points = {{0, 0}};
  std::vector<std::array<int, 3> > faces;
  for(int k = 0; k <= triangles; ++k)
    points.emplace_back(std::cos(0.9 * k), std::sin(0.9 * k));
  for(int k = 1; k <= triangles; ++k)
    faces.push_back({0, k, k + 1});
  Charts charts;
  charts.add_triangles(points, faces);
  const auto pack = [&](bool do_bijective)
  {
    return CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv,
                                                   parameters::do_bijective(do_bijective)).status.code;
  };
  const auto certify = [&](bool do_bijective)
  {
    return CGAL::Surface_mesh_cutting::certify_packing(charts.mesh, charts.is_cut, charts.uv,
                                                       parameters::do_bijective(do_bijective)).code;
  };
  CHECK(pack(true) == Status_code::NOT_CERTIFIED);
  CHECK(pack(false) == Status_code::OK);
  CHECK(certify(false) == Status_code::OK);
  CHECK(certify(true) == Status_code::NOT_CERTIFIED);
}

} // namespace pack_charts_test

int main(int argc, char** argv)
{
  using namespace pack_charts_test;
  const unsigned int seed = argc > 1 ? unsigned(std::atoi(argv[1])) : 1;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  test_one_chart();
  test_bay_and_hole();
  test_limit();
  test_polygons();
  test_damage(random);
  test_errors(random);
  test_progress(random);
  test_flips(random);
  test_overlap();
  test_random_charts(random);
  test_efforts(random);
  return test::exit_status();
}
