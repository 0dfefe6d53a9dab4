// unwrap: a mesh file in, the mesh with texture coordinates out.

#include "interruption.h"
#include "mesh_file.h"
#include "options.h"
#include "outputs.h"
#include "run_unwrap.h"
#include "soup_checks.h"

#include <csignal>
#include <exception>
#include <iostream>
#include <new>

namespace {

void unwrap_file(const Options& options, Outcome& outcome)
{
  check_outputs(options);
  const Polygon_soup soup = read_mesh_file(options.input);
  outcome.vertices = soup.number_of_points();
  outcome.faces = soup.number_of_polygons();
  check_soup(soup);
  const Layout layout = run_unwrap(soup, options, outcome);
  if(outcome.has_result)
    write_outputs(options, layout, outcome);
}

// Whatever goes wrong becomes an outcome.
Outcome run(const Options& options)
{
  Outcome outcome;
  outcome.threads = options.threads;
  outcome.seed = options.seed;
  outcome.effort = options.effort;
  outcome.solver = options.solver;
  try
  {
    unwrap_file(options, outcome);
  }
  catch(const Failure& failure)
  {
    outcome.set_failure(failure.code, failure.what(), failure.witness);
  }
  catch(const std::bad_alloc&)
  {
    outcome.set_failure(Exit_code::FAILED, "out of memory");
  }
  catch(const std::exception& exception)
  {
    outcome.set_failure(Exit_code::FAILED, exception.what());
  }
  return outcome;
}

void report_failure(const Options& options, Outcome& outcome)
{
  try
  {
    write_report(options, outcome);
  }
  catch(const Failure& failure)
  {
    std::cerr << "unwrap: " << failure.what() << "\n";
  }
}

void print_messages(const Options& options, const Outcome& outcome)
{
  for(const std::string& warning : outcome.warnings)
    std::cerr << "unwrap: warning: " << warning << "\n";
  if(outcome.exit_code == Exit_code::DONE)
  {
    if(!options.is_quiet)
      std::cerr << options.input << ": " << outcome.message << "\n"
                << "written to " << options.output << "\n";
    return;
  }
  std::cerr << "unwrap: ";
  if(outcome.exit_code != Exit_code::USAGE)
    std::cerr << options.input << ": ";
  std::cerr << outcome.message << "\n";
}

} // namespace

int main(int argc, char** argv)
{
  std::signal(SIGPIPE, SIG_IGN); // a closed pipe is an error of writing
  watch_for_interruption();

  const Command_line command_line = parse_command_line(argc, argv);
  const Options& options = command_line.options;
  if(command_line.is_done && command_line.exit_code == 0)
    return 0;

  Outcome outcome;
  if(command_line.is_done)
    outcome.set_failure(Exit_code::USAGE, command_line.message + " (see unwrap --help)");
  else
    outcome = run(options);
  if(!outcome.has_result)
    report_failure(options, outcome);
  print_messages(options, outcome);
  return int(outcome.exit_code);
}
