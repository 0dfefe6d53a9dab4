// The command line of pipeline.cpp.

#ifndef PIPELINE_OPTIONS_H
#define PIPELINE_OPTIONS_H

#include "mesh_files.h"

#include <CGAL/Surface_mesh_cutting/Conformal_solver.h>
#include <CGAL/Surface_mesh_cutting/Connection.h>
#include <CGAL/Surface_mesh_cutting/Effort.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

struct Pipeline_options
{
  using Effort = CGAL::Surface_mesh_cutting::Effort;
  using Connection = CGAL::Surface_mesh_cutting::Connection;
  using Conformal_solver = CGAL::Surface_mesh_cutting::Conformal_solver;

  std::vector<std::filesystem::path> files;
  bool is_faithful = false, is_bijective = false;
  Effort effort = Effort::DEFAULT;
  std::optional<Connection> connection;
  std::optional<Conformal_solver> conformal_solver;
  std::optional<int> coarse_number_of_faces;
  double maximum_average_distortion = std::numeric_limits<double>::infinity();
  int threads = 1, seeds = 1, repetitions = 3;

  // The library's defaults for what was not said.
  Connection connection_or_default() const
  {
    return connection.value_or(is_faithful ? Connection::GREEDY : Connection::BEST);
  }
  Conformal_solver conformal_solver_or_default() const
  {
    return conformal_solver.value_or(is_faithful ? Conformal_solver::KP_NEWTON : Conformal_solver::SPECTRAL);
  }
};

// Throws `std::runtime_error`, or what the standard library does, if they cannot be understood.
inline Pipeline_options read_pipeline_options(const std::vector<std::string>& words)
{
  using Options = Pipeline_options;
  const std::map<std::string, Options::Effort> efforts
    = {{"fast", Options::Effort::FAST}, {"default", Options::Effort::DEFAULT}, {"best", Options::Effort::BEST}};
  const std::map<std::string, Options::Connection> connections
    = {{"mst", Options::Connection::METRIC_CLOSURE}, {"sph", Options::Connection::SHORTEST_PATH_HEURISTIC},
       {"greedy", Options::Connection::GREEDY}, {"exact", Options::Connection::EXACT},
       {"best", Options::Connection::BEST}};
  const std::map<std::string, Options::Conformal_solver> conformal_solvers
    = {{"kp-newton", Options::Conformal_solver::KP_NEWTON}, {"spectral", Options::Conformal_solver::SPECTRAL}};

  Options options;
  for(std::size_t i = 0; i < words.size(); ++i)
  {
    const std::string& word = words[i];
    const auto value = [&] { return words.at(++i); };
    if(word.rfind("--", 0) != 0)
      add_files(word, options.files);
    else if(word == "--faithful")
      options.is_faithful = true;
    else if(word == "--bijective")
      options.is_bijective = true;
    else if(word == "--effort")
      options.effort = efforts.at(value());
    else if(word == "--connect")
      options.connection = connections.at(value());
    else if(word == "--conformal")
      options.conformal_solver = conformal_solvers.at(value());
    else if(word == "--coarse")
      options.coarse_number_of_faces = std::stoi(value());
    else if(word == "--max-distortion")
      options.maximum_average_distortion = std::stod(value());
    else if(word == "--threads")
      options.threads = (std::max)(1, std::stoi(value()));
    else if(word == "--seeds")
      options.seeds = (std::max)(1, std::stoi(value()));
    else if(word == "--repetitions")
      options.repetitions = (std::max)(1, std::stoi(value()));
    else
      throw std::runtime_error("unknown option " + word);
  }
  return options;
}

#endif // PIPELINE_OPTIONS_H
