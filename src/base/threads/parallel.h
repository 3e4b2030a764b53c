// Work that falls into independent pieces, on several threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace tread {

// How many threads are meant; 0: one per core. Within a piece of work of inParallel(), at most its own and those that
// have no piece.
std::size_t threadCount(int threads);

// Hands out the pieces, numbered from 0, to threads that ask for them.
class PiecesOfWork {
public:
    explicit PiecesOfWork(std::size_t count) : count_(count), failed_(count) {}

    // Does one of the pieces that are left; false: there is none. After one has thrown, no more are handed out.
    bool doNext(const std::function<void(std::size_t)>& work);

    // Throws the exception of the lowest piece that failed, once all threads have stopped.
    void throwFailure() const;

private:
    std::size_t count_;
    std::atomic<std::size_t> next_{0};
    std::mutex guard_;
    std::exception_ptr failure_;
    std::size_t failed_;  // the piece that `failure_` is of
};

// Calls work(i) for every i below count. Who writes only to the i-th place of a result gets the same result for any
// number of threads (0: one per core). An exception of the lowest i is thrown on, once all threads have stopped. Calls
// within a piece work on the thread of the piece and on those for which no piece is left.
void inParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace tread
