#ifndef THREAD_SANITIZER_TBB_INFO_H
#define THREAD_SANITIZER_TBB_INFO_H

namespace tbb {
namespace info {

inline int default_concurrency() { return 4; }

} // namespace info
} // namespace tbb

#endif // THREAD_SANITIZER_TBB_INFO_H
