#include "campaign/work.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "campaign/log_file.h"
#include "campaign/piece.h"
#include "log/csv.h"
#include "run/simulate.h"
#include "run/together.h"
#include "store/whole_file.h"

namespace tread::campaign {
namespace {

// Whether the file of a piece is there, whole and undamaged; `fault` when it is there and is not.
bool isPieceDone(const Plan& plan, const Path& folder, std::uint64_t number, std::string& fault) {
    const Path file = pieceFile(folder, plan, number);
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return false;
    Piece content;
    std::string damage;
    try {
        if (readPiece(plan, number, readBytes(file), content, damage)) return true;
    } catch (const FileError& unreadable) {
        damage = unreadable.what();
    }
    fault = fmt::format("{} is damaged ({}); its runs are computed again", file.string(), damage);
    return false;
}

// The runs of the pieces that are in work.
class Runs {
public:
    Runs(const Plan& plan, const Path& folder, const Measure& measure)
        : plan_(plan), folder_(folder), measure_(measure) {}

    bool compute(std::uint64_t piece, std::uint64_t index) {
        const double begin = ownSeconds();
        const PlannedRun run = plannedRun(plan_, plan_.firstOf(piece) + index);
        Log log;
        const bool keep = plan_.inputs.campaign.logs;
        Done done;
        try {
            done.row = rowText(plan_, run, outcomeOf(plan_, run, measure_, keep ? &log : nullptr));
        } catch (const Interrupted&) {
            return false;
        }
        if (keep && log.samples() > 0) writeFile(logFile(folder_, run.number), binaryLog(log));
        done.seconds = ownSeconds() - begin;
        const std::scoped_lock lock(guard_);
        seconds_ += done.seconds;
        std::vector<Done>& runs = open_[piece];
        runs.resize(plan_.countOf(piece));
        runs[index] = std::move(done);
        return true;
    }

    void finish(std::uint64_t number) {
        std::vector<Done> runs;
        {
            const std::scoped_lock lock(guard_);
            runs = std::move(open_.extract(number).mapped());
        }
        Piece piece;
        for (std::size_t i = 0; i < runs.size(); ++i) {
            piece.rows += runs[i].row;
            piece.timings += fmt::format("{},{:.6f}\n", plan_.firstOf(number) + i, runs[i].seconds);
        }
        writeFile(pieceFile(folder_, plan_, number), pieceText(plan_, number, piece));
    }

    double seconds() const { return seconds_; }

private:
    struct Done {
        std::string row;
        double seconds = 0;
    };

    const Plan& plan_;
    const Path& folder_;
    const Measure& measure_;
    std::mutex guard_;
    std::map<std::uint64_t, std::vector<Done>> open_;  // by piece
    double seconds_ = 0;
};

}  // namespace

Worked work(const Plan& plan, const Path& folder, const Measure& measure, const WorkOptions& options) {
    Runs runs(plan, folder, measure);
    const Pieces pieces{
        .count = plan.pieces(),
        .units = [&](std::uint64_t piece) { return plan.countOf(piece); },
        .isDone = [&](std::uint64_t piece, std::string& fault) { return isPieceDone(plan, folder, piece, fault); },
        .compute = [&](std::uint64_t piece, std::uint64_t unit) { return runs.compute(piece, unit); },
        .labour = [](std::uint64_t share,
                     const std::function<bool()>& computeNext) { driveTogether(share, computeNext); },
        .finish = [&](std::uint64_t piece) { runs.finish(piece); }};
    const WorkDone done = workTogether(pieces, folder, options);
    const std::vector<bool> present = piecesPresent(folder, plan);
    return {.runs = done.units,
            .seconds = runs.seconds(),
            .stopped = done.stopped,
            .complete = std::all_of(present.begin(), present.end(), [](bool there) { return there; })};
}

}  // namespace tread::campaign
