// Packed charts against a test of all pairs of border edges, known answers, and damage that the certificate must find.

#undef NDEBUG
#include <CGAL/Surface_mesh_cutting/certify_packing.h>
#include <CGAL/Surface_mesh_cutting/pack_charts.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <iostream>
#include <utility>
#include <vector>

namespace {

using CGAL::Surface_mesh_cutting::Chart_rotation;
using CGAL::Surface_mesh_cutting::Effort;
using CGAL::Surface_mesh_cutting::Status_code;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Cut_map = Mesh::Property_map<Mesh::Edge_index, bool>;
namespace parameters = CGAL::parameters;

// Charts without any cut: each a part of the mesh. Their UVs are their points.
struct Charts
{
  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  Cut_map is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;

  // A polygon that sees its whole border from `center`.
  void add(const std::vector<Kernel::Point_2>& polygon, const Kernel::Point_2& center)
  {
    std::vector<Mesh::Vertex_index> vertices;
    for(const Kernel::Point_2& p : polygon)
      vertices.push_back(mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), 0)));
    const Mesh::Vertex_index middle = mesh.add_vertex(Kernel::Point_3(center.x(), center.y(), 0));
    for(std::size_t i = 0; i < vertices.size(); ++i)
      mesh.add_face(vertices[i], vertices[(i + 1) % vertices.size()], middle);
    put_uvs();
  }

  void add_triangles(const std::vector<Kernel::Point_2>& points, const std::vector<std::array<int, 3> >& triangles)
  {
    std::vector<Mesh::Vertex_index> vertices;
    for(const Kernel::Point_2& p : points)
      vertices.push_back(mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), 0)));
    for(const auto& t : triangles)
      mesh.add_face(vertices[std::size_t(t[0])], vertices[std::size_t(t[1])], vertices[std::size_t(t[2])]);
    put_uvs();
  }

  void put_uvs()
  {
    for(const Mesh::Halfedge_index h : mesh.halfedges())
    {
      const Kernel::Point_3& p = mesh.point(mesh.target(h));
      uv[h] = Kernel::Point_2(p.x(), p.y());
    }
  }
};

// With property maps of its own.
Charts copy_of(const Charts& charts)
{
  Charts copy;
  copy.mesh = charts.mesh;
  copy.uv = copy.mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  copy.is_cut = copy.mesh.add_property_map<Mesh::Edge_index, bool>("e:cut").first;
  return copy;
}

Charts random_stars(CGAL::Random& random, int number)
{
  Charts charts;
  for(int i = 0; i < number; ++i)
  {
    const double size = std::exp(random.get_double(-1.5, 1));
    const int corners = random.get_int(3, 24);
    const Kernel::Point_2 center(random.get_double(0, 5), random.get_double(0, 5));
    std::vector<Kernel::Point_2> polygon;
    for(int k = 0; k < corners; ++k)
    {
      const double angle = 2 * CGAL_PI * k / corners, radius = size * random.get_double(0.3, 1);
      polygon.emplace_back(center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle));
    }
    charts.add(polygon, center);
  }
  return charts;
}

// From the definition: all pairs of border edges, in exact arithmetic.
void check_distances(const Charts& charts, double texels, int texture_size)
{
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const auto exact = [](const Kernel::Point_2& p) { return Exact::Point_2(p.x(), p.y()); };
  const Mesh& mesh = charts.mesh;
  auto part = mesh.number_of_faces() > 0 ? std::vector<int>(mesh.number_of_vertices(), -1) : std::vector<int>();
  int parts = 0;
  for(const auto v : mesh.vertices()) // by flooding
  {
    if(part[v] >= 0)
      continue;
    std::vector<Mesh::Vertex_index> stack(1, v);
    part[v] = parts;
    while(!stack.empty())
    {
      const Mesh::Vertex_index u = stack.back();
      stack.pop_back();
      for(const auto h : halfedges_around_target(u, mesh))
        if(part[source(h, mesh)] < 0)
        {
          part[source(h, mesh)] = parts;
          stack.push_back(source(h, mesh));
        }
    }
    ++parts;
  }
  std::vector<std::pair<int, Exact::Segment_2> > borders;
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h) && mesh.is_border(mesh.opposite(h)))
      borders.emplace_back(part[target(h, mesh)],
                           Exact::Segment_2(exact(charts.uv[mesh.prev(h)]), exact(charts.uv[h])));
  const CGAL::Exact_rational least = CGAL::Exact_rational(texels) * texels, size = texture_size;
  for(std::size_t i = 0; i < borders.size(); ++i)
  {
    for(const Exact::Point_2& p : {borders[i].second.source(), borders[i].second.target()})
      for(const auto& coordinate : {p.x(), p.y()})
        assert(coordinate * size >= texels && (1 - coordinate) * size >= texels);
    for(std::size_t j = 0; j < i; ++j)
      if(borders[i].first != borders[j].first)
        assert(CGAL::squared_distance(borders[i].second, borders[j].second) * size * size >= least);
  }
}

// Every triangle is similar to what it was, by the same factor, and not mirrored.
void check_similarity(const Charts& charts, double scale)
{
  for(const auto f : charts.mesh.faces())
  {
    const auto h = charts.mesh.halfedge(f), n = charts.mesh.next(h);
    const auto former = [&](Mesh::Halfedge_index i)
    {
      const Kernel::Point_3& p = charts.mesh.point(charts.mesh.target(i));
      return Kernel::Point_2(p.x(), p.y());
    };
    const Kernel::Vector_2 a = former(n) - former(h), b = charts.uv[n] - charts.uv[h];
    assert(std::abs(std::sqrt(b * b) - scale * std::sqrt(a * a)) < 1e-12);
    const auto p = charts.mesh.prev(h);
    assert(CGAL::orientation(charts.uv[h], charts.uv[n], charts.uv[p]) == CGAL::LEFT_TURN);
  }
}

void test_random_charts(CGAL::Random& random)
{
  for(const int number : {2, 7, 30})
    for(const double margin : {0., 2., 7.5})
    {
      Charts charts = random_stars(random, number);
      Charts others = copy_of(charts);
      const auto np = parameters::margin(margin).texture_size(512);
      const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, np);
      assert(result && result.number_of_charts == number);
      check_distances(charts, margin, 512);
      check_similarity(charts, result.scale);
      assert(CGAL::Surface_mesh_cutting::certify_packing(charts.mesh, charts.is_cut, charts.uv, np));
      double area = 0;
      for(const auto f : charts.mesh.faces())
      {
        const auto h = charts.mesh.halfedge(f);
        area += CGAL::area(charts.uv[h], charts.uv[charts.mesh.next(h)], charts.uv[charts.mesh.prev(h)]);
      }
      assert(std::abs(result.fill - area) < 1e-9);
      std::cout << number << " charts, margin " << margin << ": fill " << result.fill << std::endl;

      CGAL::Surface_mesh_cutting::pack_charts<CGAL::Parallel_if_available_tag>(others.mesh, others.is_cut, others.uv, np);
      for(const auto h : charts.mesh.halfedges())
        assert(charts.uv[h] == others.uv[h]);
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
      assert(result && result.number_of_charts == number);
      assert(CGAL::Surface_mesh_cutting::certify_packing(packed.mesh, packed.is_cut, packed.uv, np));
      check_similarity(packed, result.scale);
      std::cout << number << " charts, effort " << int(effort) << ": fill " << result.fill << std::endl;
      assert(result.fill > 0.95 * former);
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
  assert(result && result.number_of_charts == 1);
  assert(std::abs(result.fill - side * side) < 1e-3 && std::abs(result.scale - side / std::sqrt(2)) < 1e-3);
  check_distances(charts, 16, 1024);
}

// Crosses, each turned by some angle.
Charts turned_crosses(CGAL::Random& random, int number)
{
  Charts charts;
  for(int i = 0; i < number; ++i)
  {
    const double turn = random.get_double(0, 2 * CGAL_PI), c = std::cos(turn), s = std::sin(turn);
    const double length = random.get_double(1, 3), width = random.get_double(0.2, 0.8);
    std::vector<Kernel::Point_2> polygon;
    for(const auto& [x, y] : std::vector<std::pair<double, double> >{
          {length, -width}, {length, width}, {width, width}, {width, 1}, {-width, 1}, {-width, width},
          {-1, width}, {-1, -width}, {-width, -width}, {-width, -1}, {width, -1}, {width, -width}})
      polygon.emplace_back(9 * i + c * x - s * y, s * x + c * y);
    charts.add(polygon, {9. * i, 0});
  }
  return charts;
}

// By which each triangle was turned, from 0 to `period`.
std::vector<double> turns(const Charts& charts, double period)
{
  std::vector<double> result;
  for(const auto f : charts.mesh.faces())
  {
    const auto h = charts.mesh.halfedge(f), n = charts.mesh.next(h);
    const Kernel::Vector_3 a = charts.mesh.point(charts.mesh.target(n)) - charts.mesh.point(charts.mesh.target(h));
    const Kernel::Vector_2 b = charts.uv[n] - charts.uv[h];
    const double turn = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
    result.push_back(turn - period * std::floor(turn / period));
  }
  return result;
}

double distance_to_multiple(double number, double period)
{
  return std::abs(number - period * std::round(number / period));
}

void test_rotations(CGAL::Random& random)
{
  for(const int number : {1, 2, 9, 101})
    for(const bool are_stars : {false, true})
    {
      const Charts charts = are_stars ? random_stars(random, number) : turned_crosses(random, number);
      double fill_of_any = 0;
      for(const Chart_rotation rotation :
          {Chart_rotation::ANY, Chart_rotation::AUTOMATIC, Chart_rotation::QUARTER, Chart_rotation::NONE})
      {
        Charts packed = copy_of(charts);
        const auto np = parameters::chart_rotation(rotation).effort(Effort::FAST).texture_size(512);
        const auto result = CGAL::Surface_mesh_cutting::pack_charts(packed.mesh, packed.is_cut, packed.uv, np);
        assert(result && CGAL::Surface_mesh_cutting::certify_packing(packed.mesh, packed.is_cut, packed.uv, np));
        if(number < 20)
          check_distances(packed, 2, 512);
        check_similarity(packed, result.scale);
        std::cout << number << (are_stars ? " stars" : " crosses") << ", rotation " << int(rotation) << ": fill "
                  << result.fill << std::endl;
        if(rotation == Chart_rotation::NONE)
          for(const double turn : turns(packed, 2 * CGAL_PI))
            assert(distance_to_multiple(turn, 2 * CGAL_PI) < 1e-9);
        const bool is_one_cross = number == 1 && !are_stars;
        if((rotation == Chart_rotation::QUARTER && !are_stars) || (rotation == Chart_rotation::AUTOMATIC && is_one_cross))
          for(const auto h : packed.mesh.halfedges())
            if(packed.mesh.is_border(packed.mesh.opposite(h)))
            {
              const Kernel::Vector_2 along = packed.uv[h] - packed.uv[packed.mesh.prev(h)];
              assert(distance_to_multiple(std::atan2(along.y(), along.x()), CGAL_PI / 2) < 1e-9);
            }
        if(rotation == Chart_rotation::ANY)
          fill_of_any = result.fill;
        else if(rotation == Chart_rotation::AUTOMATIC && number <= 100 && !is_one_cross)
          assert(result.fill > 0.9699 * fill_of_any);
      }
    }
}

// A chart that no direction of its border stands out of is aligned by the smallest rectangle around it; charts that are
// aligned once stay as they are.
void test_alignment(CGAL::Random& random)
{
  const auto quarter = parameters::chart_rotation(Chart_rotation::QUARTER);
  for(int round = 0; round < 20; ++round)
  {
    Charts charts; // a triangle of angles from 60 to 90 degrees
    const double turn = random.get_double(0, 2 * CGAL_PI), height = random.get_double(0.88, 1.2);
    const auto turned = [turn](double x, double y)
    { return Kernel::Point_2(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y); };
    charts.add({turned(0, 0), turned(1, 0), turned(0.5, height)}, turned(0.5, 0.3));
    const auto box_area = [&charts](double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      double low[2] = {9, 9}, high[2] = {-9, -9};
      for(const auto h : charts.mesh.halfedges())
        if(!charts.mesh.is_border(h))
        {
          const double p[2] = {c * charts.uv[h].x() - s * charts.uv[h].y(), s * charts.uv[h].x() + c * charts.uv[h].y()};
          for(int k = 0; k < 2; ++k)
          {
            low[k] = (std::min)(low[k], p[k]);
            high[k] = (std::max)(high[k], p[k]);
          }
        }
      return (high[0] - low[0]) * (high[1] - low[1]);
    };
    assert(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, quarter));
    for(int degree = 0; degree < 90; ++degree)
      assert(box_area(0) <= box_area(degree * CGAL_PI / 180) * (1 + 1e-9));
    const std::vector<Kernel::Point_2> before(charts.uv.begin(), charts.uv.end());
    assert(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, quarter));
    for(const auto h : charts.mesh.halfedges())
      if(!charts.mesh.is_border(h))
        assert(CGAL::squared_distance(before[std::size_t(h)], charts.uv[h]) < 1e-9);
  }
}

// A small chart lies in the bay of a large one, and another one in its hole.
void test_bay_and_hole()
{
  Charts charts;
  charts.add_triangles({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}},
                       {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 7}, {4, 5, 6}, {4, 6, 7}});
  charts.add({{5, 5}, {6, 5}, {6, 5.5}, {5, 5.5}}, {5.5, 5.25});
  const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv);
  assert(result && result.scale > 0.97 / 3);

  Charts frame;
  frame.add_triangles({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {1, 1}, {2, 1}, {2, 2}, {1, 2}},
                      {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}});
  frame.add({{5, 5}, {5.8, 5}, {5.8, 5.8}, {5, 5.8}}, {5.4, 5.4});
  const auto framed = CGAL::Surface_mesh_cutting::pack_charts(frame.mesh, frame.is_cut, frame.uv);
  assert(framed && framed.scale > 0.97 / 3);
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
  assert(result && result.scale > 0.99 * limit && result.scale <= limit);
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
  assert(result && result.number_of_charts == 2);
  check_similarity(charts, result.scale);
  check_distances(charts, 2, 1024);
  for(const auto v : charts.mesh.vertices())
    for(const auto h : halfedges_around_target(v, charts.mesh))
      for(const auto other : halfedges_around_target(v, charts.mesh))
        assert(charts.mesh.is_border(h) || charts.mesh.is_border(other) || charts.uv[h] == charts.uv[other]);
}

// The certificate finds a chart moved by a little, and one moved into another one's hole without a margin.
void test_damage(CGAL::Random& random)
{
  Charts charts = random_stars(random, 12);
  const auto certify = [&]
  { return CGAL::Surface_mesh_cutting::certify_packing(charts.mesh, charts.is_cut, charts.uv).code; };
  assert(certify() == Status_code::NOT_CERTIFIED);
  assert(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv));
  assert(certify() == Status_code::OK);
  // Turned about the middle of the square, all distances stay, but those to its border.
  for(const auto h : charts.mesh.halfedges())
    charts.uv[h] = Kernel::Point_2(charts.uv[h].x() - 0.002, charts.uv[h].y());
  assert(certify() == Status_code::NOT_CERTIFIED);

  Charts pair; // exactly the margin apart, which is a sixteenth here
  pair.add({{0.25, 0.25}, {0.375, 0.25}, {0.375, 0.375}, {0.25, 0.375}}, {0.3125, 0.3125});
  pair.add({{0.4375, 0.25}, {0.5, 0.25}, {0.5, 0.375}, {0.4375, 0.375}}, {0.46875, 0.3125});
  const auto sixteenth = parameters::margin(2).texture_size(32);
  const auto certify_pair = [&]
  { return CGAL::Surface_mesh_cutting::certify_packing(pair.mesh, pair.is_cut, pair.uv, sixteenth).code; };
  assert(certify_pair() == Status_code::OK);
  for(const auto h : pair.mesh.halfedges())
    if(pair.uv[h] == Kernel::Point_2(0.4375, 0.25))
      pair.uv[h] = Kernel::Point_2(std::nextafter(0.4375, 0.), 0.25);
  assert(certify_pair() == Status_code::NOT_CERTIFIED);
}

struct Stopping_visitor : CGAL::Surface_mesh_cutting::Default_visitor
{
  bool go_further() { return false; }
};

struct Recording_visitor : CGAL::Surface_mesh_cutting::Default_visitor
{
  void progress(CGAL::Surface_mesh_cutting::Phase phase, double fraction)
  {
    assert(phase == CGAL::Surface_mesh_cutting::Phase::PACK);
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
    assert(CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv,
                                                   parameters::visitor(std::ref(visitor))));
    assert(visitor.fractions.front() == 0 && visitor.fractions.back() == 1);
    assert(std::is_sorted(visitor.fractions.begin(), visitor.fractions.end()));
    assert(number == 1 || visitor.fractions.size() > 2);
  }
}

void test_errors(CGAL::Random& random)
{
  Charts charts = random_stars(random, 3);
  const std::vector<Kernel::Point_2> before(charts.uv.begin(), charts.uv.end());
  const auto code = [&](const auto& np)
  {
    const auto result = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv, np);
    assert(result.has_result || std::equal(before.begin(), before.end(), charts.uv.begin()));
    return result.status.code;
  };
  assert(code(parameters::margin(-1)) == Status_code::WRONG_PARAMETER);
  assert(code(parameters::margin(8).texture_size(16)) == Status_code::WRONG_PARAMETER);
  assert(code(parameters::margin(std::nan(""))) == Status_code::WRONG_PARAMETER);
  assert(code(parameters::texture_size(0)) == Status_code::WRONG_PARAMETER);
  assert(code(parameters::margin(7.9).texture_size(16)) == Status_code::INFEASIBLE_CONSTRAINTS);
  const auto mirror = [&]
  {
    for(const auto h : charts.mesh.halfedges())
      charts.uv[h] = Kernel::Point_2(-charts.uv[h].x(), charts.uv[h].y());
  };
  mirror();
  const auto flipped = CGAL::Surface_mesh_cutting::pack_charts(charts.mesh, charts.is_cut, charts.uv);
  assert(flipped.status.code == Status_code::NOT_CERTIFIED && flipped.status.faces.size() == charts.mesh.number_of_faces());
  mirror();
  assert(code(parameters::visitor(Stopping_visitor())) == Status_code::STOPPED);
  check_distances(charts, 2, 1024);
  assert(code(parameters::margin(1)) == Status_code::OK);
}

} // namespace

int main(int argc, char** argv)
{
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
  test_random_charts(random);
  test_efforts(random);
  test_alignment(random);
  test_rotations(random);
  return EXIT_SUCCESS;
}
