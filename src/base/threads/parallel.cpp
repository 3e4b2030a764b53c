#include "base/threads/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>
#include <vector>

namespace tread {
namespace {

// Threads of an outermost call that have no work: calls within its pieces take them and give them back. Below 0 for a
// moment after one that has lent itself out goes on.
using Idle = std::atomic<int>;
thread_local Idle* idle = nullptr;  // of the call that this thread works for; null: for none

int coresOr(int threads) {
    return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Takes up to so many; how many it were.
int takeFrom(Idle& threads, int most) {
    int there = threads.load();
    while (true) {
        const int taken = std::clamp(there, 0, most);
        if (taken == 0 || threads.compare_exchange_weak(there, there - taken)) return taken;
    }
}

}  // namespace

std::size_t threadCount(int threads) {
    const int all = coresOr(threads);
    return static_cast<std::size_t>(idle ? std::min(all, 1 + std::max(0, idle->load())) : all);
}

bool PiecesOfWork::doNext(const std::function<void(std::size_t)>& work) {
    const std::size_t i = next_++;
    if (i >= count_) return false;
    try {
        work(i);
    } catch (...) {
        const std::scoped_lock lock(guard_);
        if (i < failed_) failure_ = std::current_exception(), failed_ = i;
        next_ = count_;
    }
    return true;
}

void PiecesOfWork::throwFailure() const {
    if (failure_) std::rethrow_exception(failure_);
}

void inParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
    if (count == 0) return;
    PiecesOfWork pieces(count);
    const int all = coresOr(threads);
    Idle own{all - 1};
    Idle& others = idle ? *idle : own;
    const auto labour = [&] {
        Idle* const outer = std::exchange(idle, &others);
        while (pieces.doNext(work)) {
        }
        idle = outer;
    };
    std::vector<std::jthread> helpers;
    const int more = takeFrom(others, static_cast<int>(std::min(count, static_cast<std::size_t>(all))) - 1);
    for (int i = 0; i < more; ++i) helpers.emplace_back([&] { labour(), ++others; });
    labour();
    if (more > 0) {
        ++others;  // while this thread waits
        helpers.clear();
        --others;
    }
    pieces.throwFailure();
}

}  // namespace tread
