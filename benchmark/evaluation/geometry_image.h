#ifndef EVALUATION_GEOMETRY_IMAGE_H
#define EVALUATION_GEOMETRY_IMAGE_H

#include "mean_value_map.h"
#include "Surface.h"

#include <algorithm>
#include <iterator>
#include <limits>

// Geometry images [GGH02]: the surface is mapped to a disk, the cut is extended to the vertex that is
// stretched most, and so on as long as the stretch of the whole map decreases.
class Geometry_image
{
public:
  explicit Geometry_image(const Surface& surface)
    : m_mesh(surface.mesh), m_shapes(surface.shapes), m_cut(surface.mesh.number_of_edges(), 0)
  {}

  Detection operator()()
  {
    constexpr int maximum_number_of_points = 200;
    Detection detection;
    start();
    double stretch = std::numeric_limits<double>::infinity();
    for(int i = 0; i < maximum_number_of_points; ++i)
    {
      std::vector<double> vertex_stretch;
      const double former = stretch;
      stretch = map_to_disk(vertex_stretch);
      if(!(stretch < former))
      {
        if(!detection.features.empty())
          detection.features.pop_back(); // it did not help
        break;
      }
      const int worst = int(std::max_element(vertex_stretch.begin(), vertex_stretch.end()) - vertex_stretch.begin());
      if(!connect(worst))
        break;
      detection.features.push_back(worst);
    }
    if(detection.features.size() < 2)
      detection.features.push_back(m_start);
    std::sort(detection.features.begin(), detection.features.end());
    return detection;
  }

private:
  // Two edges with a common end; any will do.
  void start()
  {
    const auto& arcs = m_mesh.graph().arcs;
    const int first = m_mesh.graph().offsets[m_start], degree = m_mesh.graph().degree(m_start);
    m_cut[arcs[first].edge] = m_cut[arcs[first + degree / 2].edge] = 1;
  }

  bool connect(int v)
  {
    const std::vector<char> is_open = Internal::open_vertices(m_mesh, m_cut);
    if(is_open[v])
      return false;
    Internal::Shortest_paths paths(m_mesh.graph());
    paths.add_source(v);
    int end = v;
    paths.run([&](int w) { end = w; return !is_open[w]; });
    std::vector<int> edges;
    paths.path(end, std::back_inserter(edges));
    for(int e : edges)
      m_cut[e] = 1;
    return true;
  }

  // The square of the geometric stretch, which is at least 1, and its share per vertex. Infinite if the
  // map is not valid.
  double map_to_disk(std::vector<double>& vertex_stretch) const
  {
    const Internal::Corner_table chart = Internal::make_chart(m_mesh, m_cut);
    std::vector<Eigen::Vector2d> uv(chart.number_of_vertices());
    if(!mean_value_map(m_mesh, chart, uv))
      return std::numeric_limits<double>::infinity();
    std::vector<double> stretch(m_shapes.size());
    double image = 0, area = 0;
    for(std::size_t t = 0; t < m_shapes.size(); ++t)
    {
      const Internal::Triangle& v = chart.triangles()[t];
      const auto d = SMP::wirtinger_derivatives(m_shapes[t], uv[v[0]], uv[v[1]], uv[v[2]]);
      const double determinant = d.x() - d.y();
      stretch[t] = determinant > 0 ? (d.x() + d.y()) / (determinant * determinant)
                                   : std::numeric_limits<double>::infinity();
      image += m_shapes[t].area * determinant;
      area += m_shapes[t].area;
    }
    vertex_stretch = SMP::vertex_averages(m_shapes, m_mesh.triangles(), stretch, m_mesh.number_of_vertices());
    return SMP::area_average(m_shapes, stretch) * image / area;
  }

  const Internal::Indexed_mesh& m_mesh;
  const std::vector<SMP::Rest_shape>& m_shapes;
  const int m_start = 0;
  Internal::Cut m_cut;
};

#endif // EVALUATION_GEOMETRY_IMAGE_H
