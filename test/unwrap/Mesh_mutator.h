// Random damage to meshes: of kinds that files in the wild have, and some that they hardly have.

#ifndef MESH_MUTATOR_H
#define MESH_MUTATOR_H

#include "Polygon_soup.h"

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

// The same number gives the same mutation.
class Mesh_mutator
{
public:
  Mesh_mutator(const Polygon_soup& mesh, std::uint64_t number);

  // One to four mutations.
  void mutate();

  // A whole number from 0 to n - 1.
  int pick(int n) { return int(m_random() % std::uint64_t(n)); }

  Polygon_soup soup() const;

  // The kinds of mutations that were done.
  const std::string& description() const { return m_description; }

private:
  using Point = Polygon_soup::Point;
  using Triangle = std::array<int, 3>;
  using Mutation = void (Mesh_mutator::*)();

  struct Kind { const char* name; Mutation mutation; };
  static const std::vector<Kind>& kinds();

  void delete_faces();
  void delete_patch();
  void duplicate_face();
  void reverse_face();
  void reverse_all();
  void flip_edge();
  void collapse_edge();
  void collapse_in_place();
  void flatten_face();
  void flatten_patch();
  void insert_needle();
  void perturb_point();
  void perturb_all();
  void scale();
  void squash();
  void merge_vertices();
  void redirect_corner();
  void break_coordinate();
  void add_isolated_vertex();
  void add_copy();

  double uniform() { return double(m_random() >> 11) * 0x1p-53; }
  double power_of_ten(double low, double high);
  double size() const;
  Triangle& pick_face() { return m_faces[std::size_t(pick(int(m_faces.size())))]; }
  // A redirected corner may lead to a vertex that does not exist.
  Point& point(int v) { return v < int(m_points.size()) ? m_points[std::size_t(v)] : m_stray_point; }
  std::vector<int> patch();

  std::vector<Point> m_points;
  Point m_stray_point = {};
  std::vector<Triangle> m_faces;
  std::mt19937_64 m_random;
  std::string m_description;
};

#endif // MESH_MUTATOR_H
