#include "soup_checks.h"

#include "outcome.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <tuple>

namespace {

// The occurrences of one kind of defect.
class Defects
{
public:
  explicit Defects(Witness::Kind kind) { m_witness.kind = kind; }

  // `message` describes this occurrence, at the elements `indices`.
  template <typename Message>
  void add(std::initializer_list<int> indices, Message message)
  {
    if(m_count++ == 0)
      m_message = message();
    if(m_witness.indices.size() < maximum_number_of_indices)
      m_witness.indices.insert(m_witness.indices.end(), indices);
  }

  void fail_if_any() const
  {
    if(m_count == 0)
      return;
    const std::string others = m_count == 1 ? "" : "; " + std::to_string(m_count) + " such places";
    throw Failure(Exit_code::UNSUPPORTED, m_message + " (counted from 0" + others + ")", m_witness);
  }

private:
  static constexpr std::size_t maximum_number_of_indices = 100;

  Witness m_witness;
  std::string m_message;
  int m_count = 0;
};

// A side of a triangle, which leads from corner `corner` to the next one.
struct Side
{
  int low, high; // its vertices
  int corner;
  bool is_upward; // whether it leads from `low` to `high`

  int face() const { return corner / 3; }
  bool operator<(const Side& other) const
  {
    return std::tie(low, high, corner) < std::tie(other.low, other.high, other.corner);
  }
  bool has_same_vertices(const Side& other) const { return low == other.low && high == other.high; }
};

// Sorts items by their lowest vertex, which takes linear time, and then among themselves.
template <typename Item, typename LowestVertex>
std::vector<Item> sorted(const std::vector<Item>& items, int number_of_points,
                         LowestVertex lowest_vertex)
{
  std::vector<std::size_t> ends(std::size_t(number_of_points) + 1, 0);
  for(const Item& item : items)
    ++ends[std::size_t(lowest_vertex(item)) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());

  std::vector<Item> result(items.size());
  for(const Item& item : items)
    result[ends[std::size_t(lowest_vertex(item))]++] = item;
  std::size_t first = 0;
  for(std::size_t v = 0; v + 1 < ends.size(); first = ends[v++])
    std::sort(result.begin() + std::ptrdiff_t(first), result.begin() + std::ptrdiff_t(ends[v]));
  return result;
}

int next_corner(int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

// All sides; those with the same vertices stand next to each other.
std::vector<Side> sorted_sides(const Polygon_soup& soup)
{
  std::vector<Side> sides;
  sides.reserve(soup.corners.size());
  for(int corner = 0; corner < int(soup.corners.size()); ++corner)
  {
    const int source = soup.corners[std::size_t(corner)];
    const int target = soup.corners[std::size_t(next_corner(corner))];
    sides.push_back({(std::min)(source, target), (std::max)(source, target), corner,
                     source < target});
  }
  return sorted(sides, soup.number_of_points(), [](const Side& side) { return side.low; });
}

// Calls `visit(first, last)` for each group of sides with the same vertices.
template <typename Visitor>
void for_each_edge(const std::vector<Side>& sides, Visitor visit)
{
  for(std::size_t first = 0, last; first < sides.size(); first = last)
  {
    last = first + 1;
    while(last < sides.size() && sides[first].has_same_vertices(sides[last]))
      ++last;
    visit(first, last);
  }
}

// The same for the edges that have two faces.
template <typename Visitor>
void for_each_inner_edge(const std::vector<Side>& sides, Visitor visit)
{
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    if(last - first == 2)
      visit(sides[first], sides[first + 1]);
  });
}

void check_triangles(const Polygon_soup& soup)
{
  Defects polygons(Witness::Kind::FACES);
  for(int f = 0; f < soup.number_of_polygons(); ++f)
    if(soup.number_of_corners(f) != 3)
      polygons.add({f}, [&] { return "face " + std::to_string(f) + " is not a triangle: it has "
                                     + std::to_string(soup.number_of_corners(f)) + " corners"; });
  polygons.fail_if_any();

  Defects repetitions(Witness::Kind::FACES);
  for(int f = 0; f < soup.number_of_polygons(); ++f)
    for(int k = 0; k < 3; ++k)
      if(soup.corner(f, k) == soup.corner(f, (k + 1) % 3))
      {
        repetitions.add({f}, [&] { return "face " + std::to_string(f) + " uses vertex "
                                          + std::to_string(soup.corner(f, k)) + " twice"; });
        break;
      }
  repetitions.fail_if_any();
}

// A face with the same corners as another one, in the same cyclic order.
void check_duplicates(const Polygon_soup& soup)
{
  using Face = std::array<int, 4>; // corners from the lowest one on, index
  std::vector<Face> faces;
  faces.reserve(soup.polygon_ends.size());
  for(int f = 0; f < soup.number_of_polygons(); ++f)
  {
    Face face = {{soup.corner(f, 0), soup.corner(f, 1), soup.corner(f, 2), f}};
    std::rotate(face.begin(), std::min_element(face.begin(), face.begin() + 3), face.begin() + 3);
    faces.push_back(face);
  }
  faces = sorted(faces, soup.number_of_points(), [](const Face& face) { return face[0]; });

  Defects defects(Witness::Kind::FACES);
  for(std::size_t i = 1; i < faces.size(); ++i)
    if(std::equal(faces[i].begin(), faces[i].begin() + 3, faces[i - 1].begin()))
      defects.add({faces[i - 1][3], faces[i][3]}, [&] {
        return "faces " + std::to_string(faces[i - 1][3]) + " and " + std::to_string(faces[i][3])
               + " are the same";
      });
  defects.fail_if_any();
}

void check_edges(const std::vector<Side>& sides)
{
  Defects defects(Witness::Kind::EDGES);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    const Side& side = sides[first];
    if(last - first > 2)
      defects.add({side.low, side.high}, [&] {
        return "not a manifold: the edge between vertices " + std::to_string(side.low) + " and "
               + std::to_string(side.high) + " has " + std::to_string(last - first) + " faces";
      });
  });
  defects.fail_if_any();
}

// Whether turning some of the faces would make all orientations agree.
bool is_orientable(const Polygon_soup& soup, const std::vector<Side>& sides)
{
  // Each face has two nodes, one per orientation; those that agree are in one set.
  const int n = soup.number_of_polygons();
  boost::disjoint_sets_with_storage<> orientations(2 * std::size_t(n));
  for_each_inner_edge(sides, [&](const Side& a, const Side& b) {
    const bool do_agree = a.is_upward != b.is_upward;
    orientations.union_set(a.face(), b.face() + (do_agree ? 0 : n));
    orientations.union_set(a.face() + n, b.face() + (do_agree ? n : 0));
  });
  for(int f = 0; f < n; ++f)
    if(orientations.find_set(f) == orientations.find_set(f + n))
      return false;
  return true;
}

void check_orientation(const Polygon_soup& soup, const std::vector<Side>& sides)
{
  Defects defects(Witness::Kind::FACES);
  for_each_inner_edge(sides, [&](const Side& a, const Side& b) {
    if(a.is_upward == b.is_upward)
      defects.add({a.face(), b.face()}, [&] {
        const std::string reason = is_orientable(soup, sides) ? "inconsistently oriented"
                                                              : "not orientable";
        return reason + ": the neighboring faces " + std::to_string(a.face()) + " and "
               + std::to_string(b.face()) + " disagree about which side is up";
      });
  });
  defects.fail_if_any();
}

// The corners at a vertex must form a single fan.
void check_vertices(const Polygon_soup& soup, const std::vector<Side>& sides)
{
  boost::disjoint_sets_with_storage<> fans(soup.corners.size());
  for_each_inner_edge(sides, [&](const Side& a, const Side& b) { // oriented oppositely
    fans.union_set(a.corner, next_corner(b.corner));
    fans.union_set(next_corner(a.corner), b.corner);
  });

  Defects defects(Witness::Kind::VERTICES);
  std::vector<int> fan_of_vertex(soup.points.size(), -1);
  for(int corner = 0; corner < int(soup.corners.size()); ++corner)
  {
    const int vertex = soup.corners[std::size_t(corner)];
    int& fan = fan_of_vertex[std::size_t(vertex)];
    const int fan_of_corner = int(fans.find_set(corner));
    if(fan == -1)
      fan = fan_of_corner;
    else if(fan != fan_of_corner && fan != -2)
    {
      fan = -2; // reported
      defects.add({vertex}, [&] { return "not a manifold: the faces at vertex "
                                         + std::to_string(vertex) + " form more than one fan"; });
    }
  }
  defects.fail_if_any();
}

} // namespace

void check_points(const Polygon_soup& soup)
{
  if(soup.number_of_polygons() == 0)
    throw Failure(Exit_code::UNSUPPORTED, "the mesh has no face");
  std::vector<char> is_used(soup.points.size(), 0);
  for(const int v : soup.corners)
    is_used[std::size_t(v)] = 1;
  Defects defects(Witness::Kind::VERTICES);
  for(int v = 0; v < soup.number_of_points(); ++v)
    for(const double coordinate : soup.points[std::size_t(v)])
      if(is_used[std::size_t(v)] && !std::isfinite(coordinate))
      {
        defects.add({v}, [&] { return "vertex " + std::to_string(v)
                                      + " has a coordinate that is infinite or not a number"; });
        break;
      }
  defects.fail_if_any();
}

void check_soup(const Polygon_soup& soup)
{
  check_points(soup);
  check_triangles(soup);
  check_duplicates(soup);
  const std::vector<Side> sides = sorted_sides(soup);
  check_edges(sides);
  check_orientation(soup, sides);
  check_vertices(soup, sides);
}
