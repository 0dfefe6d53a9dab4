// Keeps loops from using more threads than the user allows.

#ifndef UNWRAP_THREAD_LIMIT_H
#define UNWRAP_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>

class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(int threads)
    : m_control(tbb::global_control::max_allowed_parallelism, std::size_t(threads))
  {}

private:
  tbb::global_control m_control;
#else
  explicit Thread_limit(int) {}
#endif
};

#endif // UNWRAP_THREAD_LIMIT_H
