// Surfaces with random handles, holes and components under random constraints: a valid result wherever
// there is one, and a typed refusal otherwise, also where features are found on a coarser version. Whether there is a
// result is decided by Euler's formula.
//
// usage: test_random_topology [seed [number of cases]]

#include "random_surfaces.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace random_topology_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Status_code;

using Mesh = test::Surface_mesh;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

struct Case
{
  Mesh mesh;
  Mesh::Property_map<Edge, bool> must, never, is_cut;
  Mesh::Property_map<Edge, double> weight;
  Mesh::Property_map<Vertex, bool> is_terminal;
  Mesh::Property_map<Halfedge, CGAL::Simple_cartesian<double>::Point_2> uv;
  int components = 0, genus = 0, borders = 0;

  explicit Case(CGAL::Random& random)
  {
    add_surfaces(random);
    must = mesh.add_property_map<Edge, bool>("e:must", false).first;
    never = mesh.add_property_map<Edge, bool>("e:never", false).first;
    is_cut = mesh.add_property_map<Edge, bool>("e:is_cut", false).first;
    weight = mesh.add_property_map<Edge, double>("e:weight", 0).first;
    is_terminal = mesh.add_property_map<Vertex, bool>("v:is_terminal", false).first;
    uv = mesh.add_property_map<Halfedge, CGAL::Simple_cartesian<double>::Point_2>("h:uv").first;
    choose_must(random);
    choose_never(random);
    const int number_of_terminals = random.get_int(0, 2) * random.get_int(0, 8);
    for(int i = 0; i < number_of_terminals; ++i)
      is_terminal[random_vertex(random)] = true;
    const double cheap = random.get_int(0, 3) == 0 ? 0 : 0.1;
    const bool is_weighted = random.get_bool();
    for(Edge e : mesh.edges())
      weight[e] = CGAL::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))))
                * (is_weighted ? random.get_double(cheap, 3) * random.get_int(cheap > 0, 2) : 1);
  }

  Vertex random_vertex(CGAL::Random& random) const
  {
    return Vertex(Mesh::size_type(random.get_int(0, int(mesh.number_of_vertices()))));
  }

private:
  void add_surfaces(CGAL::Random& random)
  {
    test::Soup soup;
    components = (std::max)(1, random.get_int(-4, 5));
    for(int i = 0; i < components; ++i)
    {
      const int m = random.get_int(8, components > 1 ? 12 : 17), n = random.get_int(6, components > 1 ? 10 : 17);
      const test::Random_surface surface
        = test::random_surface(m, n, random.get_bool() ? random.get_int(0, 9) : 0,
                               random.get_bool() ? random.get_int(0, 7) : 0, random);
      soup.add(surface.soup);
      genus += surface.genus;
      borders += surface.borders;
    }
    mesh = test::make_mesh<Mesh>(soup);
  }

  // Nothing, single edges, walks, or loops around vertices.
  void choose_must(CGAL::Random& random)
  {
    const int kind = random.get_int(0, 6), number = random.get_int(1, 5);
    for(int i = 0; kind > 2 && i < number; ++i)
    {
      Vertex v = random_vertex(random);
      if(kind == 3)
        must[mesh.edge(mesh.halfedge(v))] = true;
      for(int length = kind == 4 ? random.get_int(2, 30) : 0; length > 0; --length)
      {
        Halfedge h = mesh.halfedge(v);
        for(int turns = random.get_int(0, 6); turns > 0; --turns)
          h = mesh.opposite(mesh.next(h));
        must[mesh.edge(h)] = true;
        v = mesh.source(h);
      }
      if(kind == 5)
        for(Halfedge h : halfedges_around_target(v, mesh))
          must[mesh.edge(mesh.prev(h))] = true;
    }
  }

  // Nothing, scattered edges, or all edges in a slab, but most of those that must be cut.
  void choose_never(CGAL::Random& random)
  {
    const int kind = random.get_int(0, 5);
    const double share = random.get_double(0, 0.9), low = random.get_double(8, 25),
                 high = low + random.get_double(0, 8);
    for(Edge e : mesh.edges())
    {
      const double height = mesh.point(mesh.vertex(e, 0)).z();
      if(kind == 2 || kind == 3)
        never[e] = random.get_double() < (kind == 2 ? share : 0.1 * share);
      else if(kind == 4)
        never[e] = low < height && height < high;
      if(must[e] && random.get_int(0, 1000) != 0)
        never[e] = false;
    }
  }
};

class Sets
{
public:
  explicit Sets(std::size_t size) : m_rank(size, 0), m_parent(size), m_sets(m_rank.data(), m_parent.data())
  {
    for(std::size_t i = 0; i < size; ++i)
      m_parent[i] = int(i);
  }
  int operator[](std::size_t i) { return m_sets.find_set(int(i)); }
  void unite(std::size_t i, std::size_t j) { m_sets.union_set(int(i), int(j)); }

private:
  std::vector<int> m_rank, m_parent;
  boost::disjoint_sets<int*, int*> m_sets;
};

// Whether some cut satisfies the constraints. In each part that the edges to be cut leave, let borders
// be contracted to points, which leaves a closed surface. Of the graph of the edges that may be cut,
// one connected component has to hold all borders and terminals, and to satisfy Euler's formula for
// the surface, V - E + F = 2 - 2g, which it does iff all its faces are disks.
class Feasibility
{
public:
  explicit Feasibility(const Case& c)
    : m_case(c), m_part(c.mesh.number_of_faces()), m_corner(c.mesh.number_of_halfedges()),
      m_node(c.mesh.number_of_halfedges()), m_island(c.mesh.number_of_halfedges())
  {
    for(Edge e : c.mesh.edges())
      for(Halfedge h : {c.mesh.halfedge(e, 0), c.mesh.halfedge(e, 1)})
        if(is_open(e))
        {
          if(!c.mesh.is_border(h))
          {
            m_node.unite(h, c.mesh.prev(h)); // along the border
            m_island.unite(h, c.mesh.prev(h));
          }
        }
        else
        {
          const Halfedge around = c.mesh.prev(c.mesh.opposite(h));
          m_part.unite(c.mesh.face(h), c.mesh.face(c.mesh.opposite(h)));
          m_corner.unite(h, around);
          m_node.unite(h, around);
          m_island.unite(h, around);
          if(!c.never[e])
            m_island.unite(h, c.mesh.prev(h));
        }
  }

  bool operator()()
  {
    for(Edge e : m_case.mesh.edges())
      if(m_case.must[e] && m_case.never[e] && !m_case.mesh.is_border(e))
        return false;
    std::set<int> parts;
    for(Face f : m_case.mesh.faces())
      parts.insert(m_part[f]);
    return std::all_of(parts.begin(), parts.end(), [this](int part) { return is_feasible(part); });
  }

private:
  bool is_open(Edge e) const { return m_case.mesh.is_border(e) || m_case.must[e]; }

  // Corners are named by the halfedges that lead to them.
  bool is_feasible(int part)
  {
    const Mesh& mesh = m_case.mesh;
    std::set<int> vertices, nodes, border_nodes, required, islands;
    int edges = 0, border_edges = 0, faces = 0;
    for(Face f : mesh.faces())
      if(m_part[f] == part)
      {
        ++faces;
        for(Halfedge h : halfedges_around_face(mesh.halfedge(f), mesh))
        {
          vertices.insert(m_corner[h]);
          nodes.insert(m_node[h]);
          islands.insert(m_island[h]);
          edges += is_open(mesh.edge(h)) ? 2 : 1; // halves
          if(is_open(mesh.edge(h)))
          {
            ++border_edges;
            border_nodes.insert(m_node[h]);
            required.insert(m_island[h]);
          }
        }
      }
    for(Face f : mesh.faces())
      if(m_part[f] == part)
        for(Halfedge h : halfedges_around_face(mesh.halfedge(f), mesh))
          if(m_case.is_terminal[mesh.target(h)] && border_nodes.count(m_node[h]) == 0)
            required.insert(m_island[h]);
    if(required.size() > 1)
      return false;
    if(!required.empty())
      islands = required;
    const int characteristic = int(vertices.size()) - edges / 2 + faces + int(border_nodes.size());
    return std::any_of(islands.begin(), islands.end(), [&](int island)
    {
      const int size = int(std::count_if(nodes.begin(), nodes.end(), [&](int n) { return m_island[n] == island; }));
      const bool is_large_enough = border_nodes.empty() ? size >= 3 : border_edges >= 3 || size >= 2;
      return is_large_enough && size - edges_of(part, island) + faces_of(part, island) == characteristic;
    });
  }

  bool is_of(Edge e, int island)
  {
    return !is_open(e) && !m_case.never[e] && m_island[m_case.mesh.halfedge(e)] == island;
  }

  int edges_of(int part, int island)
  {
    int edges = 0;
    for(Edge e : m_case.mesh.edges())
      edges += is_of(e, island) && m_part[m_case.mesh.face(m_case.mesh.halfedge(e))] == part;
    return edges;
  }

  int faces_of(int part, int island)
  {
    const Mesh& mesh = m_case.mesh;
    Sets faces(mesh.number_of_faces());
    for(Edge e : mesh.edges())
      if(!is_open(e) && !is_of(e, island))
        faces.unite(mesh.face(mesh.halfedge(e, 0)), mesh.face(mesh.halfedge(e, 1)));
    std::set<int> different;
    for(Face f : mesh.faces())
      if(m_part[f] == part)
        different.insert(faces[f]);
    return int(different.size());
  }

  const Case& m_case;
  // Faces that belong together; corners at the same vertex of the opened surface, at the same one after
  // contraction of the borders, and in the same island.
  Sets m_part, m_corner, m_node, m_island;
};

// What is wrong with a result; empty if nothing is.
std::string find_error(const Case& c, const SMC::Unwrap_result<Mesh>& result)
{
  if(!SMC::certify_unwrap(c.mesh, c.is_cut, c.uv) || result.flips != 0)
    return "certificate";
  if(result.components != c.components || result.genus != c.genus || result.borders != c.borders)
    return "topology";
  for(Edge e : c.mesh.edges())
  {
    if(c.mesh.is_border(e) ? c.is_cut[e] : c.must[e] && !c.is_cut[e])
      return "an edge that must be cut";
    if(c.is_cut[e] && c.never[e])
      return "an edge that must not be cut";
  }
  for(Vertex v : c.mesh.vertices())
  {
    bool is_open = !c.is_terminal[v];
    for(Halfedge h : halfedges_around_target(v, c.mesh))
      is_open = is_open || c.is_cut[c.mesh.edge(h)] || c.mesh.is_border(c.mesh.edge(h));
    if(!is_open)
      return "a terminal";
  }
  return "";
}

} // namespace random_topology_test

int main(int argc, char** argv)
{
  using namespace random_topology_test;
  const unsigned int seed = argc > 1 ? unsigned(std::atoi(argv[1])) : 1;
  const int number = argc > 2 ? std::atoi(argv[2]) : 1000;
  int refused = 0, failures = 0;
  for(int i = 0; i < number; ++i)
  {
    CGAL::Random random(seed + unsigned(i));
    Case c(random);
    const bool is_feasible = Feasibility(c)();
    // every other time on a coarser version, which knows of the constraints, too
    const int coarse_number_of_faces = i % 2 == 0 ? 0 : int(c.mesh.number_of_faces()) / 4;
    const SMC::Unwrap_result<Mesh> result
      = SMC::unwrap<CGAL::Parallel_if_available_tag>(c.mesh, c.is_cut, c.uv,
                                                     CGAL::parameters::edge_is_constrained_map(c.must)
                                                       .edge_is_forbidden_map(c.never).edge_weight_map(c.weight)
                                                       .vertex_is_constrained_map(c.is_terminal)
                                                       .coarse_number_of_faces(coarse_number_of_faces));
    std::string error;
    if(result)
      error = is_feasible ? find_error(c, result) : "a result where there is none";
    else if(is_feasible || result.status.code != Status_code::INFEASIBLE_CONSTRAINTS)
      error = std::string(is_feasible ? "feasible" : "infeasible") + ", but " + result.status.message;
    refused += !result;
    if(error.empty())
      continue;
    ++failures;
    std::cerr << "failed: seed " << seed + unsigned(i) << " (" << c.mesh.number_of_faces() << " faces, "
              << c.components << " components, genus " << c.genus << ", " << c.borders << " borders): " << error
              << std::endl;
  }
  std::cout << "seeds " << seed << " to " << seed + unsigned(number) - 1 << ": " << number << " cases, " << refused
            << " refused, " << failures << " failures" << std::endl;
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  return test::exit_status();
}
