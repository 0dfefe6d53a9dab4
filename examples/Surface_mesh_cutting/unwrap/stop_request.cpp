#include "stop_request.h"

#include "outcome.h"
#include "temporary_files.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <limits>
#include <mutex>
#include <thread>

namespace {

using Clock = std::chrono::steady_clock;

const Clock::time_point start = Clock::now();
double time_limit = std::numeric_limits<double>::infinity(); // in seconds

std::atomic<bool> was_signaled{false};
std::recursive_mutex undisturbed;

// Ends the program as the signal would have without us, but for the temporary files.
void end_at_once(int signal)
{
  const std::lock_guard<std::recursive_mutex> lock(undisturbed);
  remove_temporary_files();
  std::signal(signal, SIG_DFL);
  raise(signal);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
}

void wait_for_signals(sigset_t signals)
{
  sigset_t noted;
  sigemptyset(&noted);
  for(;;)
  {
    int signal = 0;
    if(sigwait(&signals, &signal) != 0)
      continue;
    if(signal == SIGQUIT || sigismember(&noted, signal))
      end_at_once(signal);
    sigaddset(&noted, signal);
    was_signaled = true;
  }
}

bool is_ignored(int signal)
{
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

// A thread waits for the signals, and all others block them: libraries have handlers of their own. That of METIS, for
// SIGTERM, would end its computation alone, and the signal would be lost.
void watch_for_signals()
{
  sigset_t signals;
  sigemptyset(&signals);
  for(const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    if(signal != SIGHUP || !is_ignored(signal)) // nohup means it
      sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  for(const int signal : {SIGINT, SIGTERM, SIGQUIT})
    std::signal(signal, SIG_DFL); // what is ignored could not be waited for
  std::thread(wait_for_signals, signals).detach();
}

void set_time_limit(double seconds) { time_limit = seconds; }

bool is_stop_requested()
{
  const std::chrono::duration<double> elapsed = Clock::now() - start;
  return was_signaled || elapsed.count() > time_limit;
}

std::string stop_reason() { return was_signaled ? "stopped by a signal" : "stopped by the time limit"; }

void end_if_stop_is_requested()
{
  if(is_stop_requested())
    throw Failure(Exit_code::STOPPED, stop_reason());
}

Undisturbed::Undisturbed() { undisturbed.lock(); }

Undisturbed::~Undisturbed() { undisturbed.unlock(); }
