// unwrap: a mesh file in, the mesh with texture coordinates out.

#include "Output_places.h"
#include "near_misses.h"
#include "options.h"
#include "outputs.h"
#include "reuse_memory.h"
#include "stop_request.h"
#include "terminal_text.h"
#include "unwrap_file.h"

#include <csignal>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

void tell(const std::string& text) { std::cerr << for_terminal(text) << "\n"; }

void report_failure(const Output_places& places, const Outcome& outcome)
{
  try
  {
    write_report(places, outcome);
  }
  catch(const Failure& failure)
  {
    if(failure.what() != outcome.message) // or else that is told already
      tell(std::string("unwrap: ") + failure.what());
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

void print_messages(const Options& options, const std::vector<std::string>& names, const Outcome& outcome)
{
  for(const std::string& warning : outcome.warnings)
    tell("unwrap: warning: " + warning);
  const std::string input = name_of_input(options.input) + ": ";
  if(outcome.exit_code != Exit_code::DONE)
    tell("unwrap: " + (outcome.exit_code != Exit_code::USAGE ? input : "") + outcome.message);
  if(options.is_quiet || !outcome.has_result)
    return;
  const double seconds = outcome.seconds.total.value_or(0);
  std::ostringstream rounded;
  rounded << std::fixed << std::setprecision(seconds < 10 ? 2 : 1) << seconds;
  if(outcome.exit_code == Exit_code::DONE)
    tell(input + outcome.message + ", " + rounded.str() + " s");
  tell("written: " + joined(names));
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
  print_messages(options, places.names, outcome);
  return int(outcome.exit_code);
}
