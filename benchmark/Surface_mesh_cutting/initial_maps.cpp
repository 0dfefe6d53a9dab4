// Which ways to a first map without flips work, on surfaces opened along one long path and along their final cut.
//
//   initial_maps [FOLDER [MESH_FILE...]]
//
// For each component of each mesh and each of the two cuts one line: the number of triangles; the flips of the
// spectral conformal map (-1: none found) and whether they could be removed; whether Tutte's embedding of the whole
// chart is free of flips in floating point; and from which stage of the hierarchy, by its number of vertices, a map
// of the whole chart was reached (0: from none). Surfaces with handles have only the final cut.

#include "mesh_files.h"

#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/candidates.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/first_cut.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/hierarchical_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_cutting;
using namespace CGAL::Surface_mesh_cutting::internal;
using namespace CGAL::Surface_mesh_parameterization::internal;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Adapter
  = Mesh_adapter<Surface_mesh, boost::property_map<Surface_mesh, CGAL::vertex_point_t>::const_type>;

struct Counts
{
  int charts = 0, spectral = 0, repaired = 0, tutte = 0, usual_stage = 0, coarser_stage = 0, none = 0;
};

constexpr int usual_stage = 250;

// The first stage, of those that are tried, from which the whole chart can be mapped.
int coarsest_stage(const Corner_table& chart, const std::vector<Point>& points)
{
  const Solvers linear_solvers = default_solvers();
  const auto optimize = [&](const Chart_hierarchy::Stage& stage, std::vector<Eigen::Vector2d>& uv)
  {
    Newton_solver solver(stage.chart.triangles(), stage.chart.number_of_vertices(), linear_solvers);
    return solver.minimize<Symmetric_Dirichlet_energy>(stage.shapes, area_weights(stage.shapes), uv, Newton_options())
      .outcome;
  };
  for(int size : {usual_stage, 60, 15, 4})
  {
    std::vector<Eigen::Vector2d> uv(chart.number_of_vertices(), Eigen::Vector2d::Zero());
    Chart_hierarchy hierarchy(chart, points);
    if(map_by_stages<Symmetric_Dirichlet_energy>(hierarchy, size, linear_solvers, optimize, uv)
         == Stages_outcome::MAPPED &&
       count_flips(chart.triangles(), uv) == 0)
      return size;
  }
  return 0;
}

void measure(const std::string& name, const Indexed_mesh& mesh, const Cut& cut, Counts& counts)
{
  const Corner_table chart = make_chart(mesh, cut);
  const std::vector<Point> points = chart_points(mesh, chart);
  const std::vector<Rest_shape> shapes = rest_shapes(mesh.triangles(), mesh.points());
  const Solvers linear_solvers = default_solvers();
  std::vector<Eigen::Vector2d> uv;
  int flips = -1;
  const bool has_spectral_map = spectral_conformal_map(chart, shapes, linear_solvers, uv, &flips);
  const bool is_repaired = has_spectral_map && flips > 0 && remove_flips(chart, points, uv);
  const bool has_tutte_map = tutte_map(chart, points, surface_area(shapes), linear_solvers, uv);

  const int stage = coarsest_stage(chart, points);

  std::cout << name << "," << chart.number_of_triangles() << "," << (has_spectral_map ? flips : -1) << ","
            << is_repaired << "," << has_tutte_map << "," << stage << std::endl;
  ++counts.charts;
  counts.spectral += has_spectral_map && flips == 0;
  counts.repaired += is_repaired;
  counts.tutte += has_tutte_map;
  counts.usual_stage += stage == usual_stage;
  counts.coarser_stage += 0 < stage && stage < usual_stage;
  counts.none += stage == 0 && !has_tutte_map;
}

void measure(const std::filesystem::path& file, Counts& path_counts, Counts& final_counts)
{
  Surface_mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file.string(), mesh))
    return;
  const Adapter adapter(mesh, get(CGAL::vertex_point, mesh));
  if(!adapter.status())
    return;
  auto is_cut = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:is_cut", false).first;
  const bool has_cut = bool(SMC::greedy_cut(mesh, is_cut, CGAL::parameters::effort(SMC::Effort::FAST)));
  const Cut final_cut = adapter.read_cut(is_cut);
  for(const Indexed_component& component : split_along(adapter.mesh(), Cut(adapter.mesh().number_of_edges(), 0)))
  {
    const Indexed_mesh& part = component.mesh;
    if(component.topology.genus() == 0 && component.topology.border_loops == 0)
      measure(file.filename().string() + ",path", part, make_cut(part, path_to_farthest_vertex(part, 0, 2)), path_counts);
    if(has_cut)
      measure(file.filename().string() + ",final", part, component.restriction(final_cut), final_counts);
  }
}

void print(const char* name, const Counts& c)
{
  std::cerr << name << ": " << c.charts << " charts; spectral without flips " << c.spectral << ", repaired "
            << c.repaired << "; Tutte of the whole " << c.tutte << "; hierarchy from the usual stage " << c.usual_stage
            << ", from a coarser one " << c.coarser_stage << "; neither hierarchy nor Tutte " << c.none << "\n";
}

int main(int argc, char** argv)
{
  Counts path_counts, final_counts;
  std::cout << "file,cut,triangles,spectral_flips,repaired,tutte,stage\n";
  for(const std::filesystem::path& file : mesh_files(argc, argv))
    measure(file, path_counts, final_counts);
  print("one path", path_counts);
  print("final cut", final_counts);
  return 0;
}
