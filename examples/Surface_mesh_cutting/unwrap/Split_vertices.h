// Vertices of a glTF file, repeated where their corners differ.

#ifndef UNWRAP_SPLIT_VERTICES_H
#define UNWRAP_SPLIT_VERTICES_H

#include "tangents.h"

#include <boost/functional/hash.hpp>

#include <cstddef>
#include <tuple>
#include <unordered_map>
#include <vector>

// First the vertices of the file, then repeated ones: each has one UV vertex, and one tangent where these are computed.
class Split_vertices
{
public:
  explicit Split_vertices(std::size_t number) : uvs(number, -1), tangents(number, Tangent{}) {}

  int find(int vertex, int uv, const Tangent& tangent)
  {
    const std::size_t v = std::size_t(vertex);
    if(uvs[v] < 0)
      std::tie(uvs[v], tangents[v]) = std::tie(uv, tangent);
    if(uvs[v] == uv && tangents[v] == tangent)
      return vertex;
    const auto inserted = m_repeated.emplace(Key(vertex, uv, tangent), int(uvs.size()));
    if(inserted.second)
    {
      uvs.push_back(uv);
      tangents.push_back(tangent);
      origins.push_back(v);
    }
    return inserted.first->second;
  }

  std::vector<int> uvs; // -1 where no triangle uses a vertex
  std::vector<Tangent> tangents;
  std::vector<std::size_t> origins; // of the repeated ones

private:
  using Key = std::tuple<int, int, Tangent>;

  std::unordered_map<Key, int, boost::hash<Key> > m_repeated;
};

#endif // UNWRAP_SPLIT_VERTICES_H
