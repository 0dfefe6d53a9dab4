#ifndef THREAD_SANITIZER_TBB_TASK_GROUP_H
#define THREAD_SANITIZER_TBB_TASK_GROUP_H

#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tbb {

// Tasks may run others in the group.
class task_group
{
public:
  template <typename Function>
  void run(const Function& function)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_threads.emplace_back(function);
  }

  void wait()
  {
    for(std::vector<std::thread> running = taken(); !running.empty(); running = taken())
      for(std::thread& thread : running)
        thread.join();
  }

private:
  std::vector<std::thread> taken()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return std::exchange(m_threads, {});
  }

  std::mutex m_mutex;
  std::vector<std::thread> m_threads;
};

} // namespace tbb

#endif // THREAD_SANITIZER_TBB_TASK_GROUP_H
