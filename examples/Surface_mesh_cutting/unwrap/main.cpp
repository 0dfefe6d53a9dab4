// unwrap: a mesh file in, the mesh with texture coordinates out.

#include "interruption.h"
#include "options.h"
#include "outputs.h"
#include "unwrap_file.h"

#include <csignal>
#include <iostream>

namespace {

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
    outcome = unwrap_file(options);
  if(!outcome.has_result)
    report_failure(options, outcome);
  print_messages(options, outcome);
  return int(outcome.exit_code);
}
