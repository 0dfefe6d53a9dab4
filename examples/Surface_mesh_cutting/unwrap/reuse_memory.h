// How the program asks the system for memory.

#ifndef UNWRAP_REUSE_MEMORY_H
#define UNWRAP_REUSE_MEMORY_H

// Lets memory that is given back serve again instead of returning to the system, where that can be told. Large arrays
// come and go all the time, and each page that is new costs more than what is done with it.
void reuse_memory();

#endif // UNWRAP_REUSE_MEMORY_H
