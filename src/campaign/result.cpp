#include "campaign/result.h"

#include <fmt/format.h>
#include <charconv>
#include <chrono>
#include <thread>

#include "campaign/database.h"
#include "campaign/piece.h"
#include "log/csv.h"
#include "store/claims.h"
#include "store/result_folder.h"
#include "store/whole_file.h"

namespace tread::campaign {
namespace {

// Bytes of a number in a table, and in the database; of the other cells of a row.
constexpr std::uint64_t kNumber = 18, kStoredNumber = 9, kOtherCells = 80;

// Calls `take` for each piece that is there and sound, in their order; a piece of the first folder that has it counts.
template <class Take>
Tally eachPiece(const Plan& plan, const std::vector<Path>& folders, const Take& take) {
    std::vector<std::vector<bool>> present;
    for (const Path& folder : folders) present.push_back(piecesPresent(folder, plan));
    Tally tally;
    for (std::uint64_t number = 0; number < plan.pieces(); ++number) {
        bool sound = false;
        for (std::size_t i = 0; i < folders.size() && !sound; ++i) {
            if (!present[i][number]) continue;
            const Path file = pieceFile(folders[i], plan, number);
            Piece piece;
            std::string fault;
            sound = readPiece(plan, number, readBytes(file), piece, fault);
            if (sound) take(piece, tally);
            else tally.damaged.push_back(file.string() + ": " + fault);
        }
        (sound ? tally.runs : tally.missing) += plan.countOf(number);
    }
    return tally;
}

void countStatus(Tally& tally, const std::string& word) {
    constexpr auto kNames = enumNames(Status{});
    for (std::size_t i = 0; i < kNames.size(); ++i) tally.of[i] += word == kNames[i];
}

void countSeconds(Tally& tally, const Piece& piece) {
    for (const std::string_view line : linesIn(piece.timings)) {
        double seconds = 0;
        const std::size_t comma = line.find(',');
        if (comma == std::string_view::npos) continue;
        std::from_chars(line.data() + comma + 1, line.data() + line.size(), seconds);
        tally.seconds += seconds;
    }
}

}  // namespace

Tally tally(const Plan& plan, const std::vector<Path>& folders) {
    return eachPiece(plan, folders, [](const Piece& piece, Tally& tally) {
        for (const std::string_view line : linesIn(piece.rows)) countStatus(tally, cellsOf(line).at(4));
        countSeconds(tally, piece);
    });
}

Tally merge(const Plan& plan, const std::vector<Path>& folders, const Path& target, bool partial) {
    // Two calls that end at the same time would write the same files.
    Claims claims(target);
    while (!claims.take(plan.pieces())) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (!partial) {
        Tally before;
        std::vector<std::vector<bool>> present;
        for (const Path& folder : folders) present.push_back(piecesPresent(folder, plan));
        for (std::uint64_t number = 0; number < plan.pieces(); ++number) {
            bool there = false;
            for (const auto& one : present) there = there || one[number];
            if (!there) before.missing += plan.countOf(number);
        }
        if (before.missing > 0) return tally(plan, folders);
    }
    WholeFile table(target / "results.csv"), timings(target / "timings.csv");
    table.write(csvLine(columnNames(plan)));
    timings.write("run,seconds\n");
    DatabaseWriter database(target / "results.sqlite", plan);
    const Tally found = eachPiece(plan, folders, [&](const Piece& piece, Tally& tally) {
        for (const std::string_view line : linesIn(piece.rows)) {
            const std::vector<std::string> cells = cellsOf(line);
            countStatus(tally, cells.at(4));
            database.add(cells);
        }
        countSeconds(tally, piece);
        table.write(piece.rows);
        timings.write(piece.timings);
    });
    if (found.missing > 0 && !partial) return found;
    // Whoever was killed here has left files of two merges.
    const bool had_results = std::filesystem::exists(target / "results.csv");
    if (had_results) {
        markIncomplete(target);
        removeResult(target / "report.html");
    }
    database.finish();
    timings.finish();
    table.finish();
    if (had_results || isIncomplete(target)) removeResult(target / kIncomplete);
    removeAllLeftovers(target);
    return found;
}

std::uint64_t bytesNeeded(const Plan& plan, std::uint64_t bytes_of_log) {
    const std::uint64_t numbers = plan.variables.size() + plan.metrics.size();
    const std::uint64_t row = 2 * (kOtherCells + kNumber * numbers) + kOtherCells + kStoredNumber * numbers;
    return plan.runs * (row + bytes_of_log);
}

}  // namespace tread::campaign
