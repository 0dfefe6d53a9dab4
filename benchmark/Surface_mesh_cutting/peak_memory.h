// The largest memory of the process, as Linux tells it.

#ifndef PEAK_MEMORY_H
#define PEAK_MEMORY_H

#include <fstream>
#include <string>

// From now on; without effect elsewhere.
inline void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << 5; }

// Since then, in megabytes; 0 if unknown.
inline double peak_memory()
{
  std::ifstream in("/proc/self/status");
  for(std::string word; in >> word;)
    if(word == "VmHWM:")
    {
      double kilobytes = 0;
      in >> kilobytes;
      return kilobytes / 1024;
    }
  return 0;
}

#endif // PEAK_MEMORY_H
