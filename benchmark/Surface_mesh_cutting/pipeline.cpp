// Runs the whole method on each mesh of a folder and prints one line of CSV per mesh: counts, cut
// length over the bounding box diagonal, distortion, and processor seconds per phase.
//
//   pipeline [FOLDER] [--faithful] [--effort fast|default|best] [--connect mst|greedy|best] [--seed N] [--repeat N]
//
// FOLDER holds OFF, OBJ, PLY or STL files; the default is CGAL's data set. With --repeat, times are
// medians.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

namespace SMC = CGAL::Surface_mesh_cutting;

struct Options
{
  std::string folder = std::filesystem::path(CGAL::data_file_path("meshes/cow.off")).parent_path().string();
  bool is_faithful = false;
  SMC::Effort effort = SMC::Effort::DEFAULT;
  SMC::Connection connection = SMC::Connection::BEST;
  unsigned int seed = 0;
  int repeat = 1;
};

Options read_options(int argc, char** argv)
{
  Options options;
  for(int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i], next = i + 1 < argc ? argv[i + 1] : "";
    if(word == "--faithful")
    {
      options.is_faithful = true;
      options.connection = SMC::Connection::GREEDY;
      continue;
    }
    if(word.rfind("--", 0) != 0)
    {
      options.folder = word;
      continue;
    }
    ++i;
    if(word == "--effort")
      options.effort = next == "fast" ? SMC::Effort::FAST : next == "best" ? SMC::Effort::BEST : SMC::Effort::DEFAULT;
    else if(word == "--connect")
      options.connection = next == "mst" ? SMC::Connection::METRIC_CLOSURE
                         : next == "greedy" ? SMC::Connection::GREEDY : SMC::Connection::BEST;
    else if(word == "--seed")
      options.seed = unsigned(std::atoi(next.c_str()));
    else if(word == "--repeat")
      options.repeat = (std::max)(1, std::atoi(next.c_str()));
  }
  return options;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void run(const std::filesystem::path& file, const Options& options)
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file.string(), mesh))
  {
    std::cout << file.filename().string() << ",unreadable" << std::endl;
    return;
  }
  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  SMC::Unwrap_result<Mesh> result;
  std::vector<double> candidates, filter, connect, parameterize, total;
  for(int i = 0; i < options.repeat; ++i)
  {
    result = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::faithful(options.is_faithful)
                                             .effort(options.effort)
                                             .connection(options.connection)
                                             .random_seed(options.seed));
    candidates.push_back(result.cpu_seconds.candidates);
    filter.push_back(result.cpu_seconds.filter);
    connect.push_back(result.cpu_seconds.connect);
    parameterize.push_back(result.cpu_seconds.parameterize);
    total.push_back(result.cpu_seconds.total);
  }
  std::cout << file.filename().string() << ',' << (result ? "done" : result.status.message) << ','
            << num_faces(mesh) << ',' << result.genus << ',' << result.borders << ',' << result.candidates << ','
            << result.features << ',' << result.auxiliary << ',' << result.cut_length / result.bounding_box_diagonal
            << ',' << result.E_iso << ',' << result.E_max << ',' << median(candidates) << ',' << median(filter) << ','
            << median(connect) << ',' << median(parameterize) << ',' << median(total) << std::endl;
}

int main(int argc, char** argv)
{
  const Options options = read_options(argc, argv);
  std::set<std::filesystem::path> files; // sorted
  for(const auto& entry : std::filesystem::directory_iterator(options.folder))
    if(std::set<std::string>{".off", ".obj", ".ply", ".stl"}.count(entry.path().extension().string()) > 0)
      files.insert(entry.path());
  std::cout << "file,status,triangles,genus,borders,candidates,features,auxiliary,L,E,E_max,"
               "candidates_s,filter_s,connect_s,parameterize_s,total_s" << std::endl;
  for(const std::filesystem::path& file : files)
    run(file, options);
  return EXIT_SUCCESS;
}
