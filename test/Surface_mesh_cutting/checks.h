#ifndef CHECKS_H
#define CHECKS_H

#include <cstdlib>
#include <iostream>
#include <string>

namespace test {

// Counts what failed and goes on, so that one run shows all of it.
inline int& number_of_failures()
{
  static int number = 0;
  return number;
}

inline void check(bool condition, const std::string& what)
{
  if(condition)
    return;
  std::cerr << "failed: " << what << std::endl;
  ++number_of_failures();
}

inline int exit_status() { return number_of_failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

} // namespace test

#endif // CHECKS_H
