// What weights and forbidden edges do to cuts: each mesh is unwrapped without and with them.
//
//   weighted_cuts front|visibility|sky|viewers|forbidden FOLDER [MESH_FILE...]
//
// For each mesh, or each of those named, one line: length of the cut and what is to be avoided, both over the bounding
// box diagonal; energy; seconds of processor time; first without, then with constraints. To be avoided is, with
//
//   front       the cost, where edges in the front half of the mesh, along its shortest axis, cost ten times their length;
//   visibility  the length times the share of the view from outside in which it is seen, by rays of its own;
//   sky         the same, seen from above only (y is up);
//   viewers     the same, seen from the front only, along the shortest axis;
//   forbidden   the length of the cut in the third of the vertices that is lowest along the longest axis, whose edges
//               are forbidden.
//
// Means and ratios go to standard error. Everything is measured here, from the cut and the texture coordinates.

#include "Seen_share.h"
#include "mesh_files.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>
#include <CGAL/Surface_mesh_cutting/visibility_weights.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_cutting;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Vector_3 = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Weights = Mesh::Property_map<Mesh::Edge_index, double>;

double length(const Mesh& mesh, Mesh::Edge_index e) { return PMP::edge_length(mesh.halfedge(e), mesh); }

double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
}

// The axes from that along which the mesh is shortest.
std::array<int, 3> axes_by_extent(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](int a, int b) { return box.max(a) - box.min(a) < box.max(b) - box.min(b); });
  return axes;
}

struct Measurement
{
  double length = 0, avoided = 0, energy = 0, seconds = 0;
};

// The symmetric Dirichlet energy at the best scale, by area.
template <typename UvMap>
double average_energy(const Mesh& mesh, UvMap uv)
{
  double area = 0, stretch = 0, compression = 0;
  for(const auto f : mesh.faces())
  {
    const auto h = mesh.halfedge(f), next = mesh.next(h), previous = mesh.prev(h);
    const auto& origin = mesh.point(mesh.target(h));
    const Vector_3 first = mesh.point(mesh.target(next)) - origin, second = mesh.point(mesh.target(previous)) - origin;
    const double base = std::sqrt(first.squared_length()), shift = first * second / base;
    const double height = std::sqrt(second.squared_length() - shift * shift), face_area = 0.5 * base * height;
    if(!(face_area > 0))
      continue;
    const auto along = (uv[next] - uv[h]) / base, across = (uv[previous] - uv[h] - shift * along) / height;
    const double determinant = along.x() * across.y() - along.y() * across.x();
    const double square = along.squared_length() + across.squared_length();
    area += face_area;
    stretch += face_area * square;
    compression += face_area * square / (determinant * determinant);
  }
  return 2 * std::sqrt(stretch * compression) / area;
}

// Unwraps with these weights, or by length, and measures the sum of `avoided` over the cut.
Measurement measure(Mesh& mesh, const std::vector<double>& avoided, const std::optional<Weights>& weights)
{
  const auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const std::clock_t start = std::clock();
  const auto result = weights ? SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::edge_weight_map(*weights))
                              : SMC::unwrap(mesh, is_cut, uv);
  Measurement measurement;
  measurement.seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  if(!result)
    throw std::runtime_error(result.status.message);
  if(!SMC::certify_unwrap(mesh, is_cut, uv))
    throw std::runtime_error("the result is not valid");
  const double unit = diagonal(mesh);
  for(const auto e : mesh.edges())
    if(is_cut[e])
    {
      measurement.length += length(mesh, e) / unit;
      measurement.avoided += avoided[e] / unit;
      if(weights && std::isinf((*weights)[e]))
        throw std::runtime_error("a forbidden edge is cut");
    }
  measurement.energy = average_energy(mesh, uv);
  return measurement;
}

// Each makes weights and returns for each edge how much of it is to be avoided.
using Task = std::function<std::vector<double>(const Mesh&, Weights)>;

std::vector<double> avoid_front(const Mesh& mesh, Weights weights)
{
  const int axis = axes_by_extent(mesh).front();
  const double middle = PMP::bbox(mesh).min(axis) + PMP::bbox(mesh).max(axis);
  std::vector<double> cost;
  for(const auto e : mesh.edges())
  {
    const bool is_in_front = mesh.point(mesh.vertex(e, 0))[axis] + mesh.point(mesh.vertex(e, 1))[axis] > middle;
    weights[e] = (is_in_front ? 10 : 1) * length(mesh, e);
    cost.push_back(weights[e]);
  }
  return cost;
}

std::vector<double> seen_lengths(const Mesh& mesh, const std::optional<Vector_3>& up)
{
  const Seen_share seen_share(mesh, up);
  std::vector<double> seen;
  for(const auto e : mesh.edges())
    seen.push_back(length(mesh, e) * seen_share(e));
  return seen;
}

std::vector<double> avoid_view(const Mesh& mesh, Weights weights)
{
  SMC::visibility_weights(mesh, weights);
  return seen_lengths(mesh, std::nullopt);
}

std::vector<double> avoid_view_from(const Vector_3& direction, const Mesh& mesh, Weights weights)
{
  const int number_of_rays = 64;
  const double smallest_factor = 0.25;
  SMC::visibility_weights(mesh, weights, CGAL::parameters::number_of_rays(number_of_rays).smallest_factor(smallest_factor)
                                           .up_direction(direction));
  return seen_lengths(mesh, direction);
}

std::vector<double> avoid_sky(const Mesh& mesh, Weights weights)
{
  return avoid_view_from(Vector_3(0, 1, 0), mesh, weights);
}

std::vector<double> avoid_viewers(const Mesh& mesh, Weights weights)
{
  std::array<double, 3> front = {0, 0, 0};
  front[axes_by_extent(mesh).front()] = 1;
  return avoid_view_from(Vector_3(front[0], front[1], front[2]), mesh, weights);
}

std::vector<double> avoid_lowest_third(const Mesh& mesh, Weights weights)
{
  const int axis = axes_by_extent(mesh).back();
  std::vector<double> heights;
  for(const auto v : mesh.vertices())
    heights.push_back(mesh.point(v)[axis]);
  std::vector<double> sorted = heights;
  std::sort(sorted.begin(), sorted.end());
  const double limit = sorted[sorted.size() / 3];
  std::vector<double> forbidden;
  for(const auto e : mesh.edges())
  {
    const bool is_low = (std::min)(heights[mesh.vertex(e, 0)], heights[mesh.vertex(e, 1)]) < limit;
    weights[e] = is_low ? std::numeric_limits<double>::infinity() : length(mesh, e);
    forbidden.push_back(is_low ? length(mesh, e) : 0);
  }
  return forbidden;
}

class Means
{
public:
  void add(const Measurement& m)
  {
    m_sum.length += m.length;
    m_sum.avoided += m.avoided;
    m_sum.energy += m.energy;
    m_sum.seconds += m.seconds;
    ++m_count;
  }

  double length() const { return m_sum.length / m_count; }
  double avoided() const { return m_sum.avoided / m_count; }
  double energy() const { return m_sum.energy / m_count; }
  double seconds() const { return m_sum.seconds / m_count; }

private:
  Measurement m_sum;
  int m_count = 0;
};

void print_means(const Means& without, const Means& with)
{
  const auto change = [](double before, double after) { return 100 * (after / before - 1); };
  std::cerr << "means: length " << without.length() << " to " << with.length() << " ("
            << change(without.length(), with.length()) << " %), to be avoided " << without.avoided() << " to "
            << with.avoided() << " (" << change(without.avoided(), with.avoided()) << " %), energy "
            << without.energy() << " to " << with.energy() << ", time " << with.seconds() / without.seconds()
            << " times\n";
}

std::ostream& operator<<(std::ostream& out, const Measurement& m)
{
  return out << m.length << ',' << m.avoided << ',' << m.energy << ',' << m.seconds;
}

int main(int argc, char** argv)
{
  const std::map<std::string, Task> tasks = {{"front", avoid_front}, {"visibility", avoid_view}, {"sky", avoid_sky},
                                             {"viewers", avoid_viewers}, {"forbidden", avoid_lowest_third}};
  const auto task = tasks.find(argc > 1 ? argv[1] : "");
  if(task == tasks.end())
  {
    std::cerr << argv[0] << " front|visibility|sky|viewers|forbidden FOLDER [MESH_FILE...]\n";
    return EXIT_FAILURE;
  }
  Means without, with;
  std::cout << "file,L,avoided,E,seconds,constrained_L,constrained_avoided,constrained_E,constrained_seconds" << std::endl;
  for(const std::filesystem::path& file : mesh_files(argc - 1, argv + 1))
    try
    {
      Mesh mesh;
      if(!CGAL::IO::read_polygon_mesh(file.string(), mesh))
        throw std::runtime_error("cannot be read");
      const Weights weights = mesh.add_property_map<Mesh::Edge_index, double>("e:weight").first;
      const std::vector<double> avoided = task->second(mesh, weights);
      const Measurement free = measure(mesh, avoided, std::nullopt), constrained = measure(mesh, avoided, weights);
      std::cout << file.filename().string() << ',' << free << ',' << constrained << std::endl;
      without.add(free);
      with.add(constrained);
    }
    catch(const std::exception& error)
    {
      std::cerr << file.filename().string() << ": " << error.what() << "\n";
      return EXIT_FAILURE;
    }
  print_means(without, with);
  return EXIT_SUCCESS;
}
