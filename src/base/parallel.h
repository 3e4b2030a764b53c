// Work that falls into independent pieces, on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace tread {

// Calls work(i) for every i below count. Who writes only to the i-th place of a result gets the same result for any
// number of threads (0: one per core). An exception of the lowest i is thrown on, once all threads have stopped.
void inParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace tread
