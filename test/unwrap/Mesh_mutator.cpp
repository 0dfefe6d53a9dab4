#include "Mesh_mutator.h"

#include "to_soup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

bool is_around(const std::vector<int>& vertices, int v)
{
  return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
}

} // namespace

Mesh_mutator::Mesh_mutator(const Polygon_soup& mesh, std::uint64_t number) : m_points(mesh.points), m_random(number)
{
  for(int f = 0; f < mesh.number_of_polygons(); ++f)
    m_faces.push_back({{mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2)}});
}

const std::vector<Mesh_mutator::Kind>& Mesh_mutator::kinds()
{
  static const std::vector<Kind> kinds = {
    {"delete faces", &Mesh_mutator::delete_faces},
    {"delete patch", &Mesh_mutator::delete_patch},
    {"duplicate face", &Mesh_mutator::duplicate_face},
    {"reverse face", &Mesh_mutator::reverse_face},
    {"reverse all", &Mesh_mutator::reverse_all},
    {"flip edge", &Mesh_mutator::flip_edge},
    {"collapse edge", &Mesh_mutator::collapse_edge},
    {"collapse in place", &Mesh_mutator::collapse_in_place},
    {"flatten face", &Mesh_mutator::flatten_face},
    {"flatten patch", &Mesh_mutator::flatten_patch},
    {"insert needle", &Mesh_mutator::insert_needle},
    {"perturb point", &Mesh_mutator::perturb_point},
    {"perturb all", &Mesh_mutator::perturb_all},
    {"scale", &Mesh_mutator::scale},
    {"squash", &Mesh_mutator::squash},
    {"merge vertices", &Mesh_mutator::merge_vertices},
    {"redirect corner", &Mesh_mutator::redirect_corner},
    {"break coordinate", &Mesh_mutator::break_coordinate},
    {"add isolated vertex", &Mesh_mutator::add_isolated_vertex},
    {"add copy", &Mesh_mutator::add_copy}};
  return kinds;
}

void Mesh_mutator::mutate()
{
  const int number = pick(5) < 3 ? 1 : 2 + pick(3);
  for(int i = 0; i < number && !m_faces.empty(); ++i)
  {
    const Kind& kind = kinds()[std::size_t(pick(int(kinds().size())))];
    (this->*kind.mutation)();
    m_description += (i > 0 ? ", " : "") + std::string(kind.name);
  }
}

Polygon_soup Mesh_mutator::soup() const { return to_soup(m_points, m_faces); }

double Mesh_mutator::power_of_ten(double low, double high) { return std::pow(10, low + uniform() * (high - low)); }

double Mesh_mutator::size() const
{
  double largest = 0;
  for(const Point& p : m_points)
    for(const double x : p)
      if(std::isfinite(x))
        largest = (std::max)(largest, std::abs(x));
  return largest;
}

// The vertices around a face, some rings wide.
std::vector<int> Mesh_mutator::patch()
{
  const Triangle start = pick_face();
  std::vector<int> vertices(start.begin(), start.end());
  for(int ring = pick(3); ring > 0; --ring)
  {
    const std::vector<int> inner = vertices;
    for(const Triangle& t : m_faces)
      if(is_around(inner, t[0]) || is_around(inner, t[1]) || is_around(inner, t[2]))
        vertices.insert(vertices.end(), t.begin(), t.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return vertices;
}

void Mesh_mutator::delete_faces()
{
  for(int i = 1 + pick(pick(2) == 0 ? 3 : 30); i > 0 && m_faces.size() > 1; --i)
    m_faces.erase(m_faces.begin() + pick(int(m_faces.size())));
}

void Mesh_mutator::delete_patch()
{
  const std::vector<int> vertices = patch();
  const auto is_in_patch = [&](const Triangle& t)
  { return is_around(vertices, t[0]) && is_around(vertices, t[1]) && is_around(vertices, t[2]); };
  m_faces.erase(std::remove_if(m_faces.begin(), m_faces.end(), is_in_patch), m_faces.end());
}

void Mesh_mutator::duplicate_face()
{
  Triangle t = pick_face();
  if(pick(2) == 0)
    std::swap(t[0], t[1]);
  m_faces.push_back(t);
}

void Mesh_mutator::reverse_face()
{
  Triangle& t = pick_face();
  std::swap(t[0], t[1]);
}

void Mesh_mutator::reverse_all()
{
  for(Triangle& t : m_faces)
    std::swap(t[0], t[1]);
}

void Mesh_mutator::flip_edge()
{
  for(int repetitions = 1 + pick(20); repetitions > 0; --repetitions)
  {
    Triangle& t = pick_face();
    std::rotate(t.begin(), t.begin() + pick(3), t.end());
    for(Triangle& other : m_faces)
      for(std::size_t k = 0; k < 3; ++k)
        if(other[k] == t[1] && other[(k + 1) % 3] == t[0])
        {
          const int opposite = other[(k + 2) % 3];
          other = {{opposite, t[2], t[0]}};
          t = {{t[2], opposite, t[1]}};
          k = 3;
        }
  }
}

void Mesh_mutator::collapse_edge()
{
  for(int repetitions = 1 + pick(10); repetitions > 0 && m_faces.size() > 1; --repetitions)
  {
    const Triangle t = pick_face();
    for(Triangle& other : m_faces)
      std::replace(other.begin(), other.end(), t[0], t[1]);
    const auto is_edge = [](const Triangle& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; };
    m_faces.erase(std::remove_if(m_faces.begin(), m_faces.end(), is_edge), m_faces.end());
    if(m_faces.empty())
      m_faces.push_back(t);
  }
}

void Mesh_mutator::collapse_in_place()
{
  const Triangle t = pick_face();
  point(t[0]) = point(t[1]);
  if(pick(3) == 0)
    point(t[2]) = point(t[1]);
}

void Mesh_mutator::flatten_face()
{
  const Triangle t = pick_face();
  const double share = uniform();
  for(std::size_t i = 0; i < 3; ++i)
    point(t[0])[i] = point(t[1])[i] + share * (point(t[2])[i] - point(t[1])[i]);
}

// Onto a plane, a line or a point.
void Mesh_mutator::flatten_patch()
{
  const std::vector<int> vertices = patch();
  const std::size_t lost = std::size_t(1 + pick(3));
  const Point target = point(vertices.front());
  for(const int v : vertices)
    std::copy_n(target.begin(), lost, point(v).begin());
}

// Splits a face at a point next to a corner or an edge.
void Mesh_mutator::insert_needle()
{
  for(int repetitions = 1 + pick(5); repetitions > 0; --repetitions)
  {
    Triangle& t = pick_face();
    const double near = power_of_ten(-14, -1), along = uniform();
    Point p;
    for(std::size_t i = 0; i < 3; ++i)
      p[i] = (1 - near) * (along * point(t[0])[i] + (1 - along) * point(t[1])[i]) + near * point(t[2])[i];
    const int v = int(m_points.size());
    m_points.push_back(p);
    const Triangle old = t;
    t = {{old[0], old[1], v}};
    m_faces.push_back({{old[1], old[2], v}});
    m_faces.push_back({{old[2], old[0], v}});
  }
}

void Mesh_mutator::perturb_point()
{
  const double amplitude = size() * power_of_ten(-12, 4);
  for(double& x : point(pick_face()[0]))
    x += amplitude * (2 * uniform() - 1);
}

void Mesh_mutator::perturb_all()
{
  const double amplitude = size() * power_of_ten(-12, 2);
  for(Point& p : m_points)
    for(double& x : p)
      x += amplitude * (2 * uniform() - 1);
}

void Mesh_mutator::scale()
{
  const double factor = pick(3) > 0 ? (pick(2) == 0 ? 1e-150 : 1e150) : power_of_ten(-300, 300);
  for(Point& p : m_points)
    for(double& x : p)
      x *= factor;
}

void Mesh_mutator::squash()
{
  const double factor = power_of_ten(-20, -1);
  const std::size_t axis = std::size_t(pick(3));
  for(Point& p : m_points)
    p[axis] *= factor;
}

void Mesh_mutator::merge_vertices()
{
  const int kept = pick_face()[0], removed = pick_face()[0];
  for(Triangle& t : m_faces)
    std::replace(t.begin(), t.end(), removed, kept);
}

void Mesh_mutator::redirect_corner() { pick_face()[0] = pick(int(m_points.size()) + 2); }

void Mesh_mutator::break_coordinate()
{
  using Limits = std::numeric_limits<double>;
  const double values[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), (Limits::max)(),
                           -(Limits::max)(), Limits::denorm_min(), -0.};
  point(pick_face()[0])[std::size_t(pick(3))] = values[pick(7)];
}

void Mesh_mutator::add_isolated_vertex() { m_points.push_back(m_points.front()); }

void Mesh_mutator::add_copy()
{
  const int shift = int(m_points.size());
  const double distance = pick(3) == 0 ? 0 : size() * power_of_ten(-3, 3);
  const std::size_t number_of_faces = m_faces.size();
  for(int v = 0; v < shift; ++v)
  {
    Point p = point(v);
    p[0] += distance;
    m_points.push_back(p);
  }
  for(std::size_t f = 0; f < number_of_faces; ++f)
    m_faces.push_back({{m_faces[f][0] + shift, m_faces[f][1] + shift, m_faces[f][2] + shift}});
}
