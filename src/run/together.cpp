#include "run/together.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include "base/parallel.h"
#include "run/convoy.h"

namespace tread {
namespace {

std::size_t threadsOf(int threads) {
    return threads > 0 ? static_cast<std::size_t>(threads) : std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace

std::size_t runsAtOnce(std::size_t count, int threads) {
    const std::size_t each = (count + threadsOf(threads) - 1) / threadsOf(threads);
    const std::size_t most = std::min(each, Convoy::most());
    return most < kLanesPay ? 1 : most;
}

void driveTogether(std::size_t most, const std::function<bool()>& doNext) {
    Convoy::drive(most, doNext);
}

void drivenTogether(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
    const std::size_t at_once = runsAtOnce(count, threads);
    if (at_once == 1) return inParallel(count, threads, work);
    std::atomic<std::size_t> next{0};
    std::mutex guard;
    std::exception_ptr failure;
    std::size_t failed = count;
    const auto doNext = [&] {
        const std::size_t i = next++;
        if (i >= count) return false;
        try {
            work(i);
        } catch (...) {
            const std::scoped_lock lock(guard);
            if (i < failed) failure = std::current_exception(), failed = i;
            next = count;
        }
        return true;
    };
    const std::size_t wanted = std::min(threadsOf(threads), (count + at_once - 1) / at_once);
    inParallel(wanted, static_cast<int>(wanted), [&](std::size_t) { Convoy::drive(at_once, doNext); });
    if (failure) std::rethrow_exception(failure);
}

double ownSeconds() {
    if (const Convoy* convoy = Convoy::ofThread()) return convoy->share();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace tread
