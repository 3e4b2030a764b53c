#include "run/together.h"

#include <algorithm>
#include <chrono>

#include "base/threads/parallel.h"
#include "run/convoy.h"

namespace tread {

std::size_t runsAtOnce(std::size_t count, int threads) {
    const std::size_t each = (count + threadCount(threads) - 1) / threadCount(threads);
    const std::size_t most = std::min(each, Convoy::most());
    return most < kLanesPay ? 1 : most;
}

void driveTogether(std::size_t most, const std::function<bool()>& doNext) {
    Convoy::drive(most, doNext);
}

void drivenTogether(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
    const std::size_t at_once = runsAtOnce(count, threads);
    if (at_once == 1) return inParallel(count, threads, work);
    PiecesOfWork pieces(count);
    const std::size_t wanted = std::min(threadCount(threads), (count + at_once - 1) / at_once);
    inParallel(wanted, static_cast<int>(wanted),
               [&](std::size_t) { Convoy::drive(at_once, [&] { return pieces.doNext(work); }); });
    pieces.throwFailure();
}

double ownSeconds() {
    if (const Convoy* convoy = Convoy::ofThread()) return convoy->share();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace tread
