// UVs in maps that hold fewer digits than the library computes with, and of triangles that it maps as if they were
// thicker: what is promised holds for what can be read back from the map.

#include "../BGL/check.h"
#include "held_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace held_maps_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Status_code;
using Mesh = test::Surface_mesh;

// Keeps as many bits of each coordinate as a `half` number.
class Coarse_point
{
public:
  Coarse_point() = default;
  Coarse_point(double x, double y) : m_x(rounded(x)), m_y(rounded(y)) {}
  float x() const { return m_x; }
  float y() const { return m_y; }
  bool operator==(const Coarse_point& other) const { return m_x == other.m_x && m_y == other.m_y; }

private:
  static float rounded(double x)
  {
    constexpr int number_of_bits = 12;
    int exponent;
    const double mantissa = std::frexp(x, &exponent);
    return float(std::ldexp(std::round(std::ldexp(mantissa, number_of_bits)), exponent - number_of_bits));
  }

  float m_x = 0, m_y = 0;
};

// How often which status was returned.
using Counts = std::map<Status_code, int>;

template <typename Point_2>
void test_map(Mesh mesh, bool do_bijective, const std::string& name, Counts& counts)
{
  const Point_2 untouched(-7, -7);
  auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", true).first;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv", untouched).first;
  const auto np = CGAL::parameters::do_bijective(do_bijective);
  const auto result = SMC::unwrap(mesh, is_cut, uv, np.effort(SMC::Effort::FAST));
  ++counts[result.status.code];
  CHECK(result.has_result == bool(result), name + ": a result unless it is refused");
  if(!result)
  {
    CHECK(result.status.code == Status_code::NOT_CERTIFIED, name + ": " + result.status.message);
    CHECK(std::all_of(edges(mesh).begin(), edges(mesh).end(), [&](auto e) { return is_cut[e]; }) &&
          std::all_of(halfedges(mesh).begin(), halfedges(mesh).end(), [&](auto h) { return uv[h] == untouched; }),
          name + ": maps that stay as they are");
    return;
  }
  const test::Held_map held(mesh, uv);
  CHECK(held.flips == 0 && result.flips == 0, name + ": flips");
  CHECK(SMC::certify_unwrap(mesh, is_cut, uv, np), name + ": certificate");
  CHECK(!do_bijective || (result.overlaps && *result.overlaps == 0), name + ": overlaps");
  CHECK(std::abs(result.average_distortion - held.average) <= 1e-9 * held.average, name + ": average energy");
  CHECK(std::abs(result.largest_face_distortion - held.maximum) <= 1e-9 * held.maximum, name + ": largest energy");
}

template <typename Point_2>
void test_maps(const std::vector<std::pair<std::string, Mesh> >& meshes, const std::string& type, double least_share)
{
  Counts counts;
  for(const auto& mesh : meshes)
    for(bool do_bijective : {false, true})
      test_map<Point_2>(mesh.second, do_bijective, type + ", " + mesh.first + (do_bijective ? ", bijective" : ""),
                        counts);
  std::cout << type << ": " << counts[Status_code::OK] << " maps, " << counts[Status_code::NOT_CERTIFIED]
            << " refused" << std::endl;
  CHECK(counts[Status_code::OK] >= least_share * 2 * double(meshes.size()), type + ": most maps can be held");
}

// Every so many vertices are moved almost onto a neighbor.
test::Soup with_needles(test::Soup soup, double gap, int step)
{
  std::vector<char> is_moved(soup.points.size(), 0);
  for(std::size_t f = 0; f < soup.faces.size(); f += step)
  {
    const std::size_t a = soup.faces[f][0], b = soup.faces[f][1];
    if(is_moved[a] || is_moved[b])
      continue;
    is_moved[a] = is_moved[b] = 1;
    for(int i = 0; i < 3; ++i)
      soup.points[a][i] = (1 - gap) * soup.points[b][i] + gap * soup.points[a][i];
  }
  return soup;
}

Mesh read_mesh(const std::string& name)
{
  Mesh mesh;
  CHECK(CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name), mesh), name + " is there");
  return mesh;
}

void test_value_types()
{
  std::vector<std::pair<std::string, Mesh> > meshes;
  const auto add = [&](const std::string& name, const test::Soup& soup)
  { meshes.emplace_back(name, test::make_mesh<Mesh>(soup)); };
  add("sphere", test::bumpy_sphere(12));
  add("torus", test::torus(24, 12));
  for(double gap : {1e-3, 1e-6})
    add("needles of " + std::to_string(gap), with_needles(test::bumpy_sphere(12), gap, 7));
  test::Soup several = test::bumpy_sphere(6);
  several.add(test::torus(16, 8));
  add("components", several);
  for(const char* name : {"eight.off", "nefertiti.off", "oblong.off", "part.off"})
    meshes.emplace_back(name, read_mesh(name));
  test_maps<CGAL::Simple_cartesian<double>::Point_2>(meshes, "double", 1);
  test_maps<test::Exact_kernel::Point_2>(meshes, "exact", 1);
  test_maps<CGAL::Simple_cartesian<float>::Point_2>(meshes, "float", 1);
  test_maps<Coarse_point>(meshes, "12 bits", 0.5);
}

// Bounds hold for the triangles as they are, however thin.
void test_thin_triangles()
{
  using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
  test::Soup far = test::bumpy_sphere(8), high = far;
  far.points[0] = {1e8, 0, 0};
  for(std::array<double, 3>& p : high.points)
    p[2] *= 1e8;
  for(const test::Soup& soup : {far, high})
    for(double bound : {4.1, std::numeric_limits<double>::infinity()})
    {
      Mesh mesh = test::make_mesh<Mesh>(soup);
      auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut").first;
      auto uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
      const auto result
        = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::maximum_average_distortion(bound).effort(SMC::Effort::FAST));
      CHECK(result.has_result, "thin triangles: " + result.status.message);
      if(!result.has_result)
        continue;
      const test::Held_map held(mesh, uv);
      std::cout << "thin triangles: energy " << result.average_distortion << ", exactly " << held.average << std::endl;
      CHECK(std::abs(result.average_distortion - held.average) <= 1e-6 * held.average, "energy of thin triangles");
      CHECK(std::abs(result.largest_face_distortion - held.maximum) <= 1e-6 * held.maximum, "largest energy of thin triangles");
      CHECK(result.status.code == (held.average <= bound ? Status_code::OK : Status_code::BOUND_NOT_REACHED),
            "a bound for thin triangles");
    }
}

} // namespace held_maps_test

int main()
{
  using namespace held_maps_test;
  test_value_types();
  test_thin_triangles();
  return test::exit_status();
}
