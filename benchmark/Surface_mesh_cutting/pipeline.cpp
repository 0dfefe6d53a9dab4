// Runs the whole method on meshes and prints a line of CSV for each mesh and seed: counts, length of the cut
// over the bounding box diagonal, distortion, seconds, and memory.
//
//   pipeline [FOLDER|FILE...] [--effort fast|default|best] [--faithful] [--connect mst|sph|greedy|exact|best]
//            [--conformal kp-newton|spectral] [--coarse FACES] [--max-distortion B] [--bijective]
//            [--threads N] [--seeds N] [--repetitions R]
//
// The default is CGAL's data set. Times are medians over the repetitions, those of the phases and `cut_s`, all
// without the final UVs, are processor seconds. `--coarse 0` stays at full resolution.
// Means follow on the standard error output.

#include "Profiler.h"
#include "peak_memory.h"
#include "pipeline_options.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>

namespace SMC = CGAL::Surface_mesh_cutting;

typedef CGAL::Simple_cartesian<double>                 Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>            Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef Mesh::Property_map<edge_descriptor, bool>      Cut_map;
typedef SMC::Unwrap_result<Mesh>                       Result;

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// Of one phase, over the repetitions.
double median_seconds(const std::vector<SMC::Phase_times>& times, double SMC::Phase_times::* phase)
{
  std::vector<double> values;
  for(const SMC::Phase_times& t : times)
    values.push_back(t.*phase);
  return median(values);
}

struct Measurement
{
  Result result;
  std::vector<SMC::Phase_times> cpu_seconds, seconds;
  double memory = 0; // in megabytes

  double total() const { return median_seconds(cpu_seconds, &SMC::Phase_times::total); }
  double cut() const { return total() - median_seconds(cpu_seconds, &SMC::Phase_times::parameterize); }
};

Measurement measure(Mesh& mesh, const Pipeline_options& options, int seed)
{
  const Cut_map is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  const auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  Profiler profiler;
  const auto np = CGAL::parameters::use_published_method(options.is_faithful)
                    .effort(options.effort)
                    .connection(options.connection_or_default())
                    .conformal_solver(options.conformal_solver_or_default())
                    .coarse_number_of_faces(options.coarse_number_of_faces) // if it was said: else, it depends on the surface
                    .maximum_average_distortion(options.maximum_average_distortion)
                    .do_bijective(options.is_bijective)
                    .random_seed(static_cast<unsigned int>(seed))
                    .visitor(std::ref(profiler));
  Measurement measurement;
  reset_peak_memory();
  for(int i = 0; i < options.repetitions; ++i)
  {
    measurement.result = SMC::unwrap<CGAL::Parallel_if_available_tag>(mesh, is_cut, uv, np);
    measurement.cpu_seconds.push_back(profiler.profile.cpu_seconds);
    measurement.seconds.push_back(profiler.profile.seconds);
  }
  measurement.memory = peak_memory();
  return measurement;
}

void print(const std::string& file, int seed, const Mesh& mesh, const Measurement& m)
{
  const Result& r = m.result;
  std::cout << file << ',' << seed << ',' << (r ? "done" : r.status.message) << ',' << num_faces(mesh) << ','
            << r.genus << ',' << r.borders << ',' << r.number_of_candidates << ',' << r.feature_points.size() << ',' << r.number_of_auxiliary_points << ','
            << r.cut_length / r.bounding_box_diagonal << ',' << r.average_distortion << ',' << r.largest_face_distortion;
  for(double SMC::Phase_times::* phase : {&SMC::Phase_times::candidates, &SMC::Phase_times::filter,
                                          &SMC::Phase_times::connect, &SMC::Phase_times::refine,
                                          &SMC::Phase_times::parameterize, &SMC::Phase_times::total})
    std::cout << ',' << median_seconds(m.cpu_seconds, phase);
  std::cout << ',' << m.cut() << ',' << median_seconds(m.seconds, &SMC::Phase_times::total) << ',' << m.memory << std::endl;
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
    const std::vector<double> values = {double(r.number_of_candidates), double(r.feature_points.size()),
                                        r.cut_length / r.bounding_box_diagonal, r.average_distortion, m.cut(), m.total()};
    for(std::size_t i = 0; i < values.size(); ++i)
      m_sums[i] += values[i];
    ++m_runs;
  }

  void print(std::ostream& out) const
  {
    const double n = (std::max)(1, m_runs);
    out << m_runs << " runs done, " << m_failures << " not; means: " << m_sums[0] / n << " candidates, "
        << m_sums[1] / n << " features, L " << m_sums[2] / n << ", E " << m_sums[3] / n << "; in sum "
        << m_sums[4] << " s without the final UVs, " << m_sums[5] << " s with them\n";
  }

private:
  int m_runs = 0, m_failures = 0;
  std::array<double, 6> m_sums = {};
};

void run(const Pipeline_options& options)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, std::size_t(options.threads));
#endif
  Summary summary;
  std::cout << "file,seed,status,triangles,genus,borders,candidates,features,auxiliary,L,E,largest_face_distortion,candidates_s,filter_s,"
               "connect_s,refine_s,parameterize_s,total_s,cut_s,wall_s,memory_mb" << std::endl;
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
      print(name, seed, mesh, measurement);
      summary.add(measurement);
    }
  }
  summary.print(std::cerr);
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
