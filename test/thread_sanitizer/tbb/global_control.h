#ifndef THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H
#define THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H

#include <cstddef>

namespace tbb {

// There are always as many threads as parallel_for.h says.
struct global_control
{
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
  static std::size_t active_value(parameter) { return 4; }
};

} // namespace tbb

#endif // THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H
