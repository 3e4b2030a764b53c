// Runs on several threads, of which each drives several at once, step by step, in the lanes of its processor.
//
// Each run has the same result, bit for bit, as alone. Cars must move by themselves for that (MovedBy::itself); what
// else a piece of work does is done as if it were alone on its thread, except that no mutex may be held while a car
// moves. Processors without lanes, and sanitizers: one run after the other on each thread.
#pragma once

#include <cstddef>
#include <functional>

namespace tread {

// inParallel (base/threads/parallel.h) for work that simulates.
void drivenTogether(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

// On this thread: calls doNext() until it returns false, up to `most` calls at once. It must not throw.
void driveTogether(std::size_t most, const std::function<bool()>& doNext);

// How many runs a thread has at once when there is so much work for so many threads (0: one per core).
std::size_t runsAtOnce(std::size_t count, int threads);

// A clock for the caller's part of the time of a thread that has several runs at once, s.
double ownSeconds();

}  // namespace tread
