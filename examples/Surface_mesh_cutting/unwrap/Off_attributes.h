// The data of an OFF file besides points and polygons.

#ifndef UNWRAP_OFF_ATTRIBUTES_H
#define UNWRAP_OFF_ATTRIBUTES_H

#include "Off_header.h"
#include "mesh_file.h"
#include "point_uvs.h"

#include <limits>
#include <vector>

// Gathers it while the elements are read.
class Off_attributes
{
public:
  Off_attributes(const Off_header& header, Attributes attributes) : m_header(header), m_attributes(attributes) {}

  // `numbers` are those behind the coordinates of the latest point. What is no number is NaN.
  void add_point(const std::vector<double>& numbers, Polygon_soup& soup);
  // `numbers` are those behind the corners of the latest polygon.
  void add_polygon(const std::vector<double>& numbers, Polygon_soup& soup);
  // When all elements are there.
  void complete(Polygon_soup& soup) const;

private:
  void note_alpha(const double* color, std::size_t size);

  const Off_header m_header;
  const Attributes m_attributes;
  Point_uvs m_uvs;
  double m_largest_channel = 0, m_smallest_alpha = std::numeric_limits<double>::infinity();
};

#endif // UNWRAP_OFF_ATTRIBUTES_H
