// unwrap: a mesh file in, the mesh with texture coordinates out.

#include "Output_places.h"
#include "options.h"
#include "outputs.h"
#include "reuse_memory.h"
#include "stop_request.h"
#include "unwrap_file.h"

#include <csignal>
#include <iostream>

namespace {

void report_failure(const Output_places& places, const Outcome& outcome)
{
  try
  {
    write_report(places, outcome);
  }
  catch(const Failure& failure)
  {
    if(failure.what() != outcome.message) // or else that is told already
      std::cerr << "unwrap: " << failure.what() << "\n";
  }
}

Outcome refuse(const Command_line& command_line, Output_places& places)
{
  Outcome outcome;
  outcome.set_failure(Exit_code::USAGE, command_line.message + " (see unwrap --help)");
  try
  {
    decide_place_of_report(command_line.options.json, places);
  }
  catch(const Failure&)
  {
    // The command line is what to tell about.
  }
  return outcome;
}

void print_messages(const Options& options, const Outcome& outcome)
{
  for(const std::string& warning : outcome.warnings)
    std::cerr << "unwrap: warning: " << warning << "\n";
  if(outcome.exit_code == Exit_code::DONE)
  {
    if(!options.is_quiet)
      std::cerr << options.input << ": " << outcome.message << ", " << outcome.seconds.total.value_or(0) << " s\n"
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
  reuse_memory();
  for(const int signal : {SIGPIPE, SIGXFSZ}) // closed pipes and limits of size are errors of writing
    std::signal(signal, SIG_IGN);
  watch_for_signals();

  const Command_line command_line = parse_command_line(argc, argv);
  const Options& options = command_line.options;
  if(command_line.is_done && command_line.exit_code == 0)
    return 0;

  Output_places places;
  const Outcome outcome = command_line.is_done ? refuse(command_line, places) : unwrap_file(options, places);
  if(!outcome.has_result)
    report_failure(places, outcome);
  print_messages(options, outcome);
  return int(outcome.exit_code);
}
