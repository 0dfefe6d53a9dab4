// Ctrl-C: the first one asks the run to stop, the second one ends the program at once.

#ifndef UNWRAP_INTERRUPTION_H
#define UNWRAP_INTERRUPTION_H

void watch_for_interruption();
bool is_interrupted();

#endif // UNWRAP_INTERRUPTION_H
