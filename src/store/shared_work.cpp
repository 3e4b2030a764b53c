#include "store/shared_work.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "store/claims.h"

namespace tread {
namespace {

constexpr auto kPatience = std::chrono::milliseconds(100);  // between looks at what other processes have done

// A piece in work.
struct Open {
    std::uint64_t number;
    std::uint64_t units;
    std::uint64_t taken = 0;
    std::uint64_t done = 0;
};

class Worker {
public:
    Worker(const Pieces& pieces, const std::filesystem::path& folder, const WorkOptions& options)
        : pieces_(pieces), options_(options), claims_(folder) {}

    WorkDone run() {
        look();
        const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
        const unsigned threads = options_.threads > 0 ? static_cast<unsigned>(options_.threads) : cores;
        {
            std::vector<std::jthread> beside;
            const std::uint64_t share = (all_ - done_ + threads - 1) / threads;
            for (unsigned i = 1; i < threads; ++i) beside.emplace_back([this, share] { computeUnits(share); });
            computeUnits(share);
        }
        if (failure_) std::rethrow_exception(failure_);
        return {units_, stopped_};
    }

private:
    struct Task {
        std::shared_ptr<Open> piece;
        std::uint64_t unit;
    };

    const Pieces& pieces_;
    const WorkOptions& options_;
    Claims claims_;

    std::mutex guard_;
    std::deque<std::uint64_t> missing_;  // not begun by this process
    std::vector<std::uint64_t> others_;  // that another process computes
    std::shared_ptr<Open> open_;         // whose units are handed out now
    std::atomic<bool> stopped_{false};
    std::exception_ptr failure_;
    std::uint64_t units_ = 0, done_ = 0, all_ = 0;

    // What is there, and whether it is undamaged.
    void look() {
        for (std::uint64_t piece = 0; piece < pieces_.count; ++piece) {
            if (!options_.shard.has(piece)) continue;
            const std::uint64_t units = pieces_.units(piece);
            all_ += units;
            std::string fault;
            if (pieces_.isDone(piece, fault)) done_ += units;
            else missing_.push_back(piece);
            if (!fault.empty()) options_.warn(fault);
        }
        options_.progress(done_, all_);
    }

    bool isDone(std::uint64_t piece) const {
        std::string fault;
        return pieces_.isDone(piece, fault);
    }

    // The next unit to compute; nothing when there is none left for now.
    std::optional<Task> next() {
        const std::scoped_lock lock(guard_);
        if (stopped_ || failure_) return {};
        if (options_.stop()) {
            stopped_ = true;
            return {};
        }
        if (!open_ || open_->taken == open_->units) openNext();
        if (!open_ || open_->taken == open_->units) return {};
        return Task{open_, open_->taken++};
    }

    // Whether there may be units again: another process has them, and may die.
    bool waitForOthers() {
        {
            const std::scoped_lock lock(guard_);
            if (stopped_ || failure_ || (others_.empty() && missing_.empty())) return false;
        }
        std::this_thread::sleep_for(kPatience);
        const std::scoped_lock lock(guard_);
        lookAtOthers();
        return true;
    }

    void openNext() {
        open_.reset();
        while (!missing_.empty()) {
            const std::uint64_t piece = missing_.front();
            missing_.pop_front();
            if (!claims_.take(piece)) {
                others_.push_back(piece);
                continue;
            }
            // Finished by another process since we looked?
            if (isDone(piece)) {
                claims_.release(piece);
                count(piece);
                continue;
            }
            open_ = std::make_shared<Open>(Open{piece, pieces_.units(piece)});
            return;
        }
    }

    void lookAtOthers() {
        std::vector<std::uint64_t> still;
        for (const std::uint64_t piece : others_) {
            if (isDone(piece)) {
                count(piece);
            } else if (claims_.take(piece)) {
                claims_.release(piece);
                missing_.push_back(piece);  // whoever computed it has died
            } else {
                still.push_back(piece);
            }
        }
        others_ = std::move(still);
    }

    void count(std::uint64_t piece) {
        done_ += pieces_.units(piece);
        options_.progress(done_, all_);
    }

    void computeUnits(std::uint64_t share) {
        do pieces_.labour(share, [this] { return computeNext(); });
        while (waitForOthers());
    }

    bool computeNext() {
        try {
            const auto task = next();
            if (task) compute(*task);
            return task.has_value();
        } catch (...) {
            const std::scoped_lock lock(guard_);
            if (!failure_) failure_ = std::current_exception();
            return false;
        }
    }

    void compute(const Task& task) {
        if (!pieces_.compute(task.piece->number, task.unit)) {
            stopped_ = true;
            return;
        }
        bool last = false;
        {
            const std::scoped_lock lock(guard_);
            ++units_;
            last = ++task.piece->done == task.piece->units;
            options_.progress(++done_, all_);
        }
        if (!last) return;
        pieces_.finish(task.piece->number);
        claims_.release(task.piece->number);
    }
};

}  // namespace

WorkDone workTogether(const Pieces& pieces, const std::filesystem::path& folder, const WorkOptions& options) {
    return Worker(pieces, folder, options).run();
}

}  // namespace tread
