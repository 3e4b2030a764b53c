#include "base/threads/parallel.h"

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

namespace tread {
namespace {

thread_local std::size_t share_of_piece = 0;  // threads for the piece of work that this thread does; 0: it does none

}  // namespace

std::size_t threadCount(int threads) {
    const std::size_t all = threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
    return std::max<std::size_t>(1, share_of_piece > 0 ? std::min(all, share_of_piece) : all);
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
    const std::size_t all = threadCount(threads), wanted = std::min(count, all);
    const auto labour = [&] {
        const std::size_t outer = std::exchange(share_of_piece, all / wanted);
        while (pieces.doNext(work)) {
        }
        share_of_piece = outer;
    };
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < wanted; ++i) helpers.emplace_back(labour);
    labour();
    helpers.clear();
    pieces.throwFailure();
}

}  // namespace tread
