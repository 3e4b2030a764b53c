#include "base/parallel.h"

#include <algorithm>
#include <thread>
#include <vector>

namespace tread {

std::size_t threadCount(int threads) {
    return threads > 0 ? static_cast<std::size_t>(threads) : std::max(1u, std::thread::hardware_concurrency());
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
    PiecesOfWork pieces(count);
    const auto labour = [&] {
        while (pieces.doNext(work)) {
        }
    };
    std::vector<std::jthread> helpers;
    const std::size_t wanted = std::min(count, threadCount(threads));
    for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back(labour);
    labour();
    helpers.clear();
    pieces.throwFailure();
}

}  // namespace tread
