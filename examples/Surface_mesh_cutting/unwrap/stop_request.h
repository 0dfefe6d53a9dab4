// When a run has to end before it is complete: on a signal, or at its time limit, which counts from
// the start of the program.

#ifndef UNWRAP_STOP_REQUEST_H
#define UNWRAP_STOP_REQUEST_H

#include <string>

// The first Ctrl-C, termination or hang-up asks the run to stop, the second one of its kind ends the
// program at once, without its temporary files.
void watch_for_signals();

void set_time_limit(double seconds);

// May be asked by several threads.
bool is_stop_requested();

// What asks for it.
std::string stop_reason();

// Throws a `Failure` with `Exit_code::STOPPED` if a stop is requested.
void end_if_stop_is_requested();

// While one exists, no signal ends the program at once.
class Undisturbed
{
public:
  Undisturbed();
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;
  ~Undisturbed();
};

#endif // UNWRAP_STOP_REQUEST_H
