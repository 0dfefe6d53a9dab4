#include "reuse_memory.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

void reuse_memory()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);        // large arrays come from the pool, too
  mallopt(M_TRIM_THRESHOLD, -1); // whose end is not given back
  mallopt(M_ARENA_MAX, 1);       // one for all threads, or each would keep what others need
#endif
}
