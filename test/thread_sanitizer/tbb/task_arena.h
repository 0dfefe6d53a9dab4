#ifndef THREAD_SANITIZER_TBB_TASK_ARENA_H
#define THREAD_SANITIZER_TBB_TASK_ARENA_H

namespace tbb {

struct task_arena
{
  explicit task_arena(int) {}

  template <typename Function>
  void execute(const Function& function) { function(); }
};

namespace this_task_arena {

inline int max_concurrency() { return 4; }

template <typename Function>
void isolate(const Function& function) { function(); }

} // namespace this_task_arena
} // namespace tbb

#endif // THREAD_SANITIZER_TBB_TASK_ARENA_H
