// UVs as glTF holds them.

#ifndef UNWRAP_SINGLE_PRECISION_H
#define UNWRAP_SINGLE_PRECISION_H

#include "Mesh.h"
#include "outcome.h"

#include <boost/property_map/property_map.hpp>

// In single precision, measured from the top.
class Single_precision_uv
{
public:
  Single_precision_uv(double u, double v) : m_u(float(u)), m_from_top(float(1 - v)) {}

  double x() const { return m_u; }
  double y() const { return 1 - double(m_from_top); }

private:
  float m_u, m_from_top;
};

// Reads any UVs, and rounds those that are written.
struct Single_precision_uvs
{
  using key_type = Halfedge;
  using value_type = Single_precision_uv;
  using reference = Kernel::Point_2;
  using category = boost::read_write_property_map_tag;

  UV_map uvs;

  friend Kernel::Point_2 get(const Single_precision_uvs& map, Halfedge h) { return map.uvs[h]; }
  friend void put(const Single_precision_uvs& map, Halfedge h, const Single_precision_uv& uv)
  {
    map.uvs[h] = Kernel::Point_2(uv.x(), uv.y());
  }
};

// Rounds UVs, and tells of triangles that this flips and of overlaps that it makes.
void hold_in_single_precision(const Mesh& mesh, Cut_map is_cut, UV_map uvs, bool is_injective, Outcome& outcome);

#endif // UNWRAP_SINGLE_PRECISION_H
