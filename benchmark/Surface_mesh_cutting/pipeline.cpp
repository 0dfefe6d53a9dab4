// Runs the whole method on meshes and prints a line of CSV for each mesh and seed: counts, length of the cut
// over the bounding box diagonal, distortion, seconds, and memory.
//
//   pipeline [FOLDER|FILE...] [--effort fast|default|best] [--faithful] [--connect mst|sph|greedy|exact|best]
//            [--conformal kp-newton|spectral] [--coarse FACES] [--max-distortion B] [--bijective]
//            [--solver supernodal|eigen|cholmod] [--threads N] [--seeds N] [--repetitions R] [--cold-map] [--baseline FILE.csv]
//
// The default is CGAL's data set. The solver `supernodal` is the package's own factorization, `eigen` Eigen's
// SimplicialLDLT. Times are medians over the repetitions, those of the phases and `cut_s`, all
// without the final UVs, are processor seconds. `--coarse 0` stays at full resolution. With `--cold-map`, `cold_s`
// is what a symmetric Dirichlet parameterization of the surface opened along the final cut takes from nothing
// (connected surfaces only), and `cold_tutte_s` the same the usual way, by Newton's method at full resolution from
// Tutte's embedding. With `--baseline`, the last column says how many times as long that took.
// Means and ratios follow on the standard error output.

#include "Baseline.h"
#include "peak_memory.h"
#include "pipeline_options.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/Surface_mesh_cutting/make_seam_mesh.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>
#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Mesh_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/initial_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <Eigen/SparseCholesky>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>

namespace SMC = CGAL::Surface_mesh_cutting;
namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double>                 Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>            Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef Mesh::Property_map<edge_descriptor, bool>      Cut_map;
typedef SMC::Unwrap_result<Mesh>                       Result;
typedef Eigen::SparseMatrix<double>                    Matrix;

// Of one phase, over the repetitions.
double median_seconds(const std::vector<SMC::Phase_times>& times, double SMC::Phase_times::* phase)
{
  std::vector<double> values;
  for(const SMC::Phase_times& t : times)
    values.push_back(t.*phase);
  return median(values);
}

// What everyone pays who wants UVs: one map from nothing of the surface opened along the cut.
struct Cold_map_seconds
{
  double hierarchical; // by the package
  double from_tutte;   // the usual way, all at full resolution: Tutte's embedding, then Newton's method
};

struct Measurement
{
  Result result;
  std::vector<SMC::Phase_times> cpu_seconds, seconds;
  std::optional<Cold_map_seconds> cold_map;
  double memory = 0; // in megabytes

  double total() const { return median_seconds(cpu_seconds, &SMC::Phase_times::total); }
  double cut() const { return total() - median_seconds(cpu_seconds, &SMC::Phase_times::parameterize); }
};

template <typename Solver>
std::optional<Cold_map_seconds> seconds_of_cold_map(const Mesh& mesh, Cut_map is_cut, const Result& result,
                                                    const Solver& solver)
{
  if(!result || result.components != 1)
    return std::nullopt;
  const auto seam_mesh = SMC::make_seam_mesh(mesh, is_cut);
  SMP::internal::Mesh_chart<std::decay_t<decltype(seam_mesh)> > chart;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(seam_mesh).first;
  if(chart.read(seam_mesh, border) != SMP::OK)
    return std::nullopt;
  const auto linear_solvers = SMP::internal::make_solvers(solver);
  const auto seconds_of = [&](const auto& map)
  {
    const std::clock_t start = std::clock();
    const auto shapes = SMP::internal::rest_shapes(chart.chart().triangles(), chart.points());
    SMP::internal::Chart_parameterizer parameterizer(chart.chart(), chart.points(), shapes, linear_solvers);
    std::vector<Eigen::Vector2d> uv;
    map(parameterizer, shapes, uv);
    return double(std::clock() - start) / CLOCKS_PER_SEC;
  };
  const SMP::internal::Newton_options options;
  return Cold_map_seconds{
    seconds_of([&](auto& parameterizer, const auto&, auto& uv) { parameterizer.isometric_map(uv, options); }),
    seconds_of([&](auto& parameterizer, const auto& shapes, auto& uv)
               {
                 if(SMP::internal::tutte_map(chart.chart(), chart.points(), SMP::internal::surface_area(shapes),
                                             linear_solvers, uv))
                   parameterizer.improve_isometrically(uv, options);
               })};
}

template <typename Solver>
Measurement measure(Mesh& mesh, const Pipeline_options& options, int seed, const Solver& solver)
{
  const Cut_map is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  const auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  const auto np = CGAL::parameters::use_published_method(options.is_faithful)
                    .effort(options.effort)
                    .connection(options.connection_or_default())
                    .conformal_solver(options.conformal_solver_or_default())
                    .coarse_number_of_faces(options.coarse_number_of_faces) // if it was said: else, it depends on the surface
                    .maximum_average_distortion(options.maximum_average_distortion)
                    .do_bijective(options.is_bijective)
                    .random_seed(static_cast<unsigned int>(seed))
                    .sparse_linear_solver(solver);
  Measurement measurement;
  reset_peak_memory();
  for(int i = 0; i < options.repetitions; ++i)
  {
    measurement.result = SMC::unwrap<CGAL::Parallel_if_available_tag>(mesh, is_cut, uv, np);
    measurement.cpu_seconds.push_back(measurement.result.cpu_seconds);
    measurement.seconds.push_back(measurement.result.seconds);
  }
  measurement.memory = peak_memory();
  if(options.measures_cold_map)
    measurement.cold_map = seconds_of_cold_map(mesh, is_cut, measurement.result, solver);
  return measurement;
}

Measurement measure(Mesh& mesh, const Pipeline_options& options, int seed)
{
#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
  if(options.solver == "cholmod")
    return measure(mesh, options, seed, CGAL::Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Matrix> >());
#endif
  if(options.solver == "eigen")
    return measure(mesh, options, seed, CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Matrix> >());
  if(options.solver != "supernodal")
    throw std::runtime_error("there is no solver " + options.solver);
  return measure(mesh, options, seed, CGAL::Default());
}

// Nothing if there is no value.
std::ostream& operator<<(std::ostream& out, const std::optional<double>& value)
{
  return value ? out << *value : out;
}

std::ostream& operator<<(std::ostream& out, const std::optional<Cold_map_seconds>& seconds)
{
  return seconds ? out << seconds->hierarchical << ',' << seconds->from_tutte : out << ',';
}

void print_ratios(std::ostream& out, const char* name, const std::vector<double>& ratios)
{
  if(!ratios.empty())
    out << name << ": median " << median(ratios) << ", largest " << *std::max_element(ratios.begin(), ratios.end())
        << "\n";
}

void print(const std::string& file, int seed, const Mesh& mesh, const Measurement& m, std::optional<double> ratio)
{
  const Result& r = m.result;
  std::cout << file << ',' << seed << ',' << (r ? "done" : r.status.message) << ',' << num_faces(mesh) << ','
            << r.genus << ',' << r.borders << ',' << r.number_of_candidates << ',' << r.number_of_features << ',' << r.number_of_auxiliary_points << ','
            << r.cut_length / r.bounding_box_diagonal << ',' << r.average_distortion << ',' << r.largest_face_distortion;
  for(double SMC::Phase_times::* phase : {&SMC::Phase_times::candidates, &SMC::Phase_times::filter,
                                          &SMC::Phase_times::connect, &SMC::Phase_times::refine,
                                          &SMC::Phase_times::parameterize, &SMC::Phase_times::total})
    std::cout << ',' << median_seconds(m.cpu_seconds, phase);
  std::cout << ',' << m.cut() << ',' << median_seconds(m.seconds, &SMC::Phase_times::total) << ',' << m.memory << ','
            << m.cold_map << ',' << ratio << std::endl;
}

// Means over all runs that succeeded.
class Summary
{
public:
  void add(const Measurement& m)
  {
    const Result& r = m.result;
    if(!r)
    {
      ++m_failures;
      return;
    }
    const std::vector<double> values = {double(r.number_of_candidates), double(r.number_of_features),
                                        r.cut_length / r.bounding_box_diagonal, r.average_distortion, m.cut(), m.total()};
    for(std::size_t i = 0; i < values.size(); ++i)
      m_sums[i] += values[i];
    ++m_runs;
    if(m.cold_map)
    {
      m_cold_ratios.push_back(m.total() / m.cold_map->hierarchical);
      m_tutte_ratios.push_back(m.total() / m.cold_map->from_tutte);
    }
  }

  void print(std::ostream& out) const
  {
    const double n = (std::max)(1, m_runs);
    out << m_runs << " runs done, " << m_failures << " not; means: " << m_sums[0] / n << " candidates, "
        << m_sums[1] / n << " features, L " << m_sums[2] / n << ", E " << m_sums[3] / n << "; in sum "
        << m_sums[4] << " s without the final UVs, " << m_sums[5] << " s with them\n";
    print_ratios(out, "total over one cold map of the final cut", m_cold_ratios);
    print_ratios(out, "total over one from Tutte's embedding at full resolution", m_tutte_ratios);
  }

private:
  int m_runs = 0, m_failures = 0;
  std::array<double, 6> m_sums = {};
  std::vector<double> m_cold_ratios, m_tutte_ratios;
};

void run(const Pipeline_options& options)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
#endif
  Baseline baseline = options.baseline.empty() ? Baseline() : Baseline(options.baseline);
  Summary summary;
  std::cout << "file,seed,status,triangles,genus,borders,candidates,features,auxiliary,L,E,largest_face_distortion,candidates_s,filter_s,"
               "connect_s,refine_s,parameterize_s,total_s,cut_s,wall_s,memory_mb,cold_s,cold_tutte_s,ratio" << std::endl;
  for(const std::filesystem::path& file : options.files)
  {
    const std::string name = file.filename().string();
    Mesh mesh;
    if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file.string(), mesh))
    {
      std::cerr << "cannot read " << name << "\n";
      continue;
    }
    for(int seed = 0; seed < options.seeds; ++seed)
    {
      const Measurement measurement = measure(mesh, options, seed);
      print(name, seed, mesh, measurement, baseline.ratio(name, measurement.cut()));
      summary.add(measurement);
    }
  }
  summary.print(std::cerr);
  baseline.summarize(std::cerr);
}

int main(int argc, char** argv)
{
  try
  {
    Pipeline_options options = read_pipeline_options(std::vector<std::string>(argv + 1, argv + argc));
    if(options.files.empty())
      add_files(std::filesystem::path(CGAL::data_file_path("meshes/cow.off")).parent_path(), options.files);
    run(options);
  }
  catch(const std::exception& error)
  {
    std::cerr << argv[0] << ": " << error.what() << "; its first lines of code say how it is called\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
