#include "interruption.h"

#include <csignal>

namespace {

volatile std::sig_atomic_t was_signaled = 0;

void note_signal(int) { was_signaled = 1; }

} // namespace

void watch_for_interruption()
{
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = int(SA_RESETHAND); // the next signal has its usual effect
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool is_interrupted() { return was_signaled != 0; }
