#ifndef CGAL_TEST_CHECK_H
#define CGAL_TEST_CHECK_H

#include <cstdlib>
#include <iostream>

// CHECK(condition) or CHECK(condition, what): tells what failed and goes on, so that one run shows all of it; `main()`
// returns `test::exit_status()`.
#define CHECK(...) CGAL_TEST_CHOOSE_CHECK(__VA_ARGS__, CGAL_TEST_CHECK_WHAT, CGAL_TEST_CHECK_ALONE, )(__VA_ARGS__)
#define CGAL_TEST_CHOOSE_CHECK(condition, what, chosen, ...) chosen
#define CGAL_TEST_CHECK_ALONE(condition) CGAL_TEST_CHECK_WHAT(condition, "")
#define CGAL_TEST_CHECK_WHAT(condition, what)                                                  \
  do {                                                                                         \
    if(!(condition)) {                                                                         \
      std::cerr << __FILE__ << ":" << __LINE__ << ": " #condition " failed " << (what) << std::endl; \
      ++test::number_of_failures();                                                            \
    }                                                                                          \
  } while(false)

namespace test {

inline int& number_of_failures()
{
  static int number = 0;
  return number;
}

inline int exit_status() { return number_of_failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

} // namespace test

#endif // CGAL_TEST_CHECK_H
