// What the package uses of TBB, by plain threads. ThreadSanitizer does not see how the tasks of TBB, which
// is not compiled with it, wait for each other, and reports races where there are none.

#ifndef THREAD_SANITIZER_TBB_PARALLEL_FOR_H
#define THREAD_SANITIZER_TBB_PARALLEL_FOR_H

#include <atomic>
#include <thread>
#include <vector>

namespace tbb {

template <typename Index, typename Function>
void parallel_for(Index first, Index last, const Function& function)
{
  constexpr int number_of_threads = 4;
  std::atomic<Index> next(first);
  const auto work = [&]
  {
    for(Index i = next++; i < last; i = next++)
      function(i);
  };
  std::vector<std::thread> threads;
  for(int i = 1; i < number_of_threads; ++i)
    threads.emplace_back(work);
  work();
  for(std::thread& thread : threads)
    thread.join();
}

} // namespace tbb

#endif // THREAD_SANITIZER_TBB_PARALLEL_FOR_H
