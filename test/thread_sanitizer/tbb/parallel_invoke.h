#ifndef THREAD_SANITIZER_TBB_PARALLEL_INVOKE_H
#define THREAD_SANITIZER_TBB_PARALLEL_INVOKE_H

#include <thread>

namespace tbb {

template <typename First, typename Second>
void parallel_invoke(const First& first, const Second& second)
{
  std::thread thread(first);
  second();
  thread.join();
}

} // namespace tbb

#endif // THREAD_SANITIZER_TBB_PARALLEL_INVOKE_H
