#include "stop_request.h"

#include "outcome.h"
#include "temporary_files.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <limits>

namespace {

using Clock = std::chrono::steady_clock;

const Clock::time_point start = Clock::now();
double time_limit = std::numeric_limits<double>::infinity(); // in seconds

std::atomic<bool> was_signaled{false};
std::atomic<int> undisturbed_scopes{0};

void handle(int signal, void (*handler)(int))
{
  struct sigaction action = {};
  action.sa_handler = handler;
  sigaction(signal, &action, nullptr);
}

void end_at_once(int signal)
{
  if(undisturbed_scopes != 0) // for a moment: sending the signal again will do
    return;
  remove_temporary_files();
  handle(signal, SIG_DFL);
  raise(signal);
}

void note_signal(int signal)
{
  was_signaled = true;
  handle(signal, end_at_once);
}

bool is_ignored(int signal)
{
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

void watch_for_signals()
{
  handle(SIGINT, note_signal);
  handle(SIGTERM, note_signal);
  if(!is_ignored(SIGHUP)) // nohup means it
    handle(SIGHUP, note_signal);
  handle(SIGQUIT, end_at_once);
}

void set_time_limit(double seconds) { time_limit = seconds; }

bool is_stop_requested()
{
  const std::chrono::duration<double> elapsed = Clock::now() - start;
  return was_signaled || elapsed.count() > time_limit;
}

void end_if_stop_is_requested()
{
  if(is_stop_requested())
    throw Failure(Exit_code::STOPPED, was_signaled ? "stopped by a signal" : "stopped by the time limit");
}

Undisturbed::Undisturbed() { ++undisturbed_scopes; }

Undisturbed::~Undisturbed() { --undisturbed_scopes; }
