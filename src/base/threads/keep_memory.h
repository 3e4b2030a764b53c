// For programs that simulate thousands of drives.
#pragma once

#include <malloc.h>

namespace tread {

// Logs and matrices come and go by the thousand: the memory that one leaves is kept for the next, instead of being
// handed back to the system and fetched again page by page. For the whole process.
inline void keepMemory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 25);  // bytes: the most that the C library takes
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

}  // namespace tread
