// Unwraps mutations of meshes, within one process, as the program does:
//   mutate_meshes FIRST LAST MESH...
// Mutation N is of mesh N modulo the number of meshes, with options that depend on N. Half of them are no meshes of
// triangles any more. Prints a line for each, and
// ends at the first that is not answered properly: by an exception, after too long a time, or by a
// success that is none. With FIRST = LAST - 1 it also writes the mutation as an OFF file.

#include "Mesh_mutator.h"
#include "Soup_mutator.h"
#include "check_formats.h"
#include "check_layout.h"
#include "mesh_file.h"
#include "run_unwrap.h"
#include "soup_checks.h"
#include "unwrap_file.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <vector>

#include <sys/time.h>
#include <unistd.h>

namespace {

// Seconds of processor time. Sanitizers take their time.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define IS_SANITIZED
#endif
#endif
#ifdef IS_SANITIZED
constexpr int time_limit = 200;
#else
constexpr int time_limit = 40; // hundreds of triangles as charts of their own are packed, also without optimization
#endif

void set_alarm(int seconds)
{
  itimerval timer = {};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_PROF, &timer, nullptr);
}

void too_long(int)
{
  static const char message[] = "too long\n";
  const auto written = write(STDOUT_FILENO, message, sizeof message - 1);
  std::_Exit(written > 0 ? 2 : 3);
}

Options pick_options(Mesh_mutator& mutator)
{
  Options options;
  options.is_quiet = true;
  options.solver = available_solvers()[std::size_t(mutator.pick(int(available_solvers().size())))];
  const int kind = mutator.pick(10);
  options.effort = kind < 6 ? "fast" : "default";
  options.is_faithful = kind == 9;
  options.is_bijective = mutator.pick(5) == 0;
  if(mutator.pick(10) == 0)
    options.maximum_average_distortion = 4.05;
  options.is_strict = mutator.pick(10) == 0;
  options.weld = std::vector<const char*>{"auto", "on", "off"}[std::size_t(mutator.pick(3))];
  return options;
}

void write_off(const Polygon_soup& soup, const std::string& path)
{
  std::ofstream file(path);
  file.precision(std::numeric_limits<double>::max_digits10);
  file << "OFF\n" << soup.number_of_points() << " " << soup.number_of_polygons() << " 0\n";
  for(const Polygon_soup::Point& p : soup.points)
    file << p[0] << " " << p[1] << " " << p[2] << "\n";
  for(int f = 0; f < soup.number_of_polygons(); ++f)
  {
    file << soup.number_of_corners(f);
    for(int k = 0; k < soup.number_of_corners(f); ++k)
      file << " " << soup.corner(f, k);
    file << "\n";
  }
}

// How the program answers, or which fault its answer has.
std::string answer(const Polygon_soup& soup, const Options& options, bool& is_proper)
{
  try
  {
    check_indices(soup);
    Outcome outcome;
    const Layout layout = unwrap_soup(soup, options, outcome);
    std::string fault = outcome.has_result ? find_fault(layout, soup, options.is_bijective) : "";
    if(outcome.has_result && fault.empty())
      fault = find_format_fault(layout);
    is_proper = fault.empty() && (outcome.has_result || outcome.exit_code != Exit_code::DONE);
    return std::to_string(int(outcome.exit_code)) + " " + (fault.empty() ? outcome.message : fault);
  }
  catch(const Failure& failure)
  {
    is_proper = true;
    return std::to_string(int(failure.code)) + " " + failure.what();
  }
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 4)
  {
    std::cerr << "usage: mutate_meshes FIRST LAST MESH...\n";
    return 2;
  }
  const long first = std::atol(argv[1]), last = std::atol(argv[2]);
  std::vector<Polygon_soup> meshes;
  for(int i = 3; i < argc; ++i)
    meshes.push_back(read_mesh_file(argv[i]));

  std::signal(SIGPROF, too_long);
  for(long number = first; number < last; ++number)
  {
    Mesh_mutator mutator(meshes[std::size_t(number) % meshes.size()], std::uint64_t(number));
    mutator.mutate();
    const Options options = pick_options(mutator);
    Soup_mutator soup_mutator(mutator.soup(), std::uint64_t(number));
    if(std::size_t(number) / meshes.size() % 2 == 1)
      soup_mutator.mutate();
    const Polygon_soup soup = soup_mutator.soup();
    std::cout << number << ": " << mutator.description() << soup_mutator.description() << "; " << options.effort
              << (options.is_strict ? " strict" : "") << " weld " << options.weld
              << (options.is_faithful ? " faithful" : "") << (options.is_bijective ? " bijective" : "") << ": "
              << std::flush;
    if(last - first == 1)
      write_off(soup, "mutation_" + std::to_string(number) + ".off");
    bool is_proper = false;
    set_alarm(time_limit);
    const std::string text = answer(soup, options, is_proper);
    set_alarm(0);
    std::cout << text << std::endl;
    if(!is_proper)
      return 1;
  }
  return 0;
}
