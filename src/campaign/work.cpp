#include "campaign/work.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/number_text.h"
#include "campaign/log_file.h"
#include "campaign/piece.h"
#include "log/csv.h"
#include "run/simulate.h"

namespace tread::campaign {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kPatience = std::chrono::milliseconds(100);  // between looks at what other processes have done

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// A piece in work: its runs are handed out one by one, to any thread.
struct Open {
    std::uint64_t number;
    std::uint64_t count;
    std::uint64_t taken = 0;
    std::uint64_t done = 0;
    std::vector<std::string> rows = {};
    std::vector<double> seconds = {};
};

class Worker {
public:
    Worker(const Plan& plan, const Path& folder, const Measure& measure, const Work& options)
        : plan_(plan), folder_(folder), measure_(measure), options_(options), claims_(folder) {}

    Worked run() {
        look();
        const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
        const unsigned threads = options_.threads > 0 ? static_cast<unsigned>(options_.threads) : cores;
        {
            std::vector<std::jthread> threads_beside;
            for (unsigned i = 1; i < threads; ++i) threads_beside.emplace_back([this] { driveRuns(); });
            driveRuns();
        }
        if (failure_) std::rethrow_exception(failure_);
        const std::vector<bool> present = piecesPresent(folder_, plan_);
        worked_.stopped = stopped_;
        worked_.complete = std::all_of(present.begin(), present.end(), [](bool there) { return there; });
        return worked_;
    }

private:
    const Plan& plan_;
    const Path& folder_;
    const Measure& measure_;
    const Work& options_;
    Claims claims_;

    std::mutex guard_;
    std::deque<std::uint64_t> missing_;  // not begun by this process
    std::vector<std::uint64_t> others_;  // that another process computes
    std::shared_ptr<Open> open_;         // whose runs are handed out now
    std::atomic<bool> stopped_{false};
    std::exception_ptr failure_;
    Worked worked_;
    std::uint64_t done_ = 0, all_ = 0;

    // What is there, and whether it is undamaged.
    void look() {
        const std::vector<bool> present = piecesPresent(folder_, plan_);
        for (std::uint64_t piece = 0; piece < plan_.pieces(); ++piece) {
            if (!options_.shard.has(piece)) continue;
            all_ += plan_.countOf(piece);
            if (present[piece] && isSound(piece)) done_ += plan_.countOf(piece);
            else missing_.push_back(piece);
        }
    }

    bool isSound(std::uint64_t number) {
        const Path file = pieceFile(folder_, plan_, number);
        Piece piece;
        std::string fault;
        if (readPiece(plan_, number, readBytes(file), piece, fault)) return true;
        options_.warn(fmt::format("{} is damaged ({}); its runs are computed again", file.string(), fault));
        return false;
    }

    // The next run to compute; nothing when there is none left for this thread.
    struct Task {
        std::shared_ptr<Open> open;
        std::uint64_t index;
    };
    std::optional<Task> next() {
        for (;;) {
            {
                const std::scoped_lock lock(guard_);
                if (stopped_ || failure_) return {};
                if (options_.stop()) {
                    stopped_ = true;
                    return {};
                }
                if (!open_ || open_->taken == open_->count) openNext();
                if (open_ && open_->taken < open_->count) return Task{open_, open_->taken++};
                if (others_.empty()) return {};
            }
            std::this_thread::sleep_for(kPatience);
            const std::scoped_lock lock(guard_);
            lookAtOthers();
        }
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
            if (isThere(piece)) {
                claims_.release(piece);
                count(piece);
                continue;
            }
            open_ = std::make_shared<Open>(Open{piece, plan_.countOf(piece)});
            open_->rows.resize(open_->count);
            open_->seconds.resize(open_->count);
            return;
        }
    }

    // A damaged piece has a file too, but must be computed.
    bool isThere(std::uint64_t piece) const {
        const Path file = pieceFile(folder_, plan_, piece);
        std::error_code error;
        if (!std::filesystem::exists(file, error)) return false;
        Piece content;
        std::string fault;
        try {
            return readPiece(plan_, piece, readBytes(file), content, fault);
        } catch (const FileError&) {
            return false;
        }
    }

    void lookAtOthers() {
        std::vector<std::uint64_t> still;
        for (const std::uint64_t piece : others_) {
            if (isThere(piece)) {
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
        done_ += plan_.countOf(piece);
        options_.progress(done_, all_);
    }

    void driveRuns() {
        try {
            while (const auto task = next()) compute(*task);
        } catch (const Interrupted&) {
            stopped_ = true;
        } catch (...) {
            const std::scoped_lock lock(guard_);
            if (!failure_) failure_ = std::current_exception();
        }
    }

    void compute(const Task& task) {
        const auto begin = Clock::now();
        const PlannedRun run = plannedRun(plan_, plan_.firstOf(task.open->number) + task.index);
        Log log;
        const bool keep = plan_.inputs.campaign.logs;
        const Outcome outcome = outcomeOf(plan_, run, measure_, keep ? &log : nullptr);
        if (keep && log.samples() > 0) writeDurably(logFile(folder_, run.number), binaryLog(log));
        task.open->rows[task.index] = rowText(plan_, run, outcome);
        const double seconds = secondsSince(begin);
        task.open->seconds[task.index] = seconds;
        bool last = false;
        {
            const std::scoped_lock lock(guard_);
            worked_.seconds += seconds;
            ++worked_.runs;
            last = ++task.open->done == task.open->count;
            options_.progress(++done_, all_);
        }
        if (last) finish(*task.open);
    }

    void finish(const Open& open) {
        Piece piece;
        for (std::uint64_t i = 0; i < open.count; ++i) {
            piece.rows += open.rows[i];
            piece.timings += fmt::format("{},{:.6f}\n", plan_.firstOf(open.number) + i, open.seconds[i]);
        }
        writeDurably(pieceFile(folder_, plan_, open.number), pieceText(plan_, open.number, piece));
        claims_.release(open.number);
    }
};

}  // namespace

Worked work(const Plan& plan, const Path& folder, const Measure& measure, const Work& options) {
    return Worker(plan, folder, measure, options).run();
}

}  // namespace tread::campaign
