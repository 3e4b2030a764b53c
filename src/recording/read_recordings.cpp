#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/text/did_you_mean.h"
#include "base/text/number_text.h"
#include "base/yaml/read.h"
#include "import/import.h"
#include "log/csv.h"
#include "log/log_columns.h"
#include "recording/position.h"
#include "recording/reference.h"

namespace tread::recording {
namespace {

constexpr double kShortest = 1;  // s; a shorter recording cannot tell causes apart

bool isTreadLog(const std::string& file) {
    std::string text = readBytes(file);
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    return text.starts_with("time [s]");
}

// Reads a channel from the column that the file names, and gives it the channel's name and unit.
void takeColumn(Log& log, const MeasuredChannel& wanted, const std::string& file) {
    if (wanted.column.empty() || wanted.column == wanted.channel) return;
    const Channel* column = log.find(wanted.column);
    if (!column) {
        std::vector<std::string_view> names;
        for (const Channel& channel : log.channels) names.push_back(channel.name);
        throw LoadError({{file, 0, 0, wanted.column,
                          "found no such column in the log, expected the column from which " + wanted.channel +
                              " is read" + didYouMean(wanted.column, names)}});
    }
    Channel taken = *column;
    taken.name = wanted.channel;
    if (taken.unit.empty() || taken.unit == "-") taken.unit = wanted.unit.empty() ? taken.unit : wanted.unit;
    std::erase_if(log.channels, [&](const Channel& channel) { return channel.name == wanted.channel; });
    log.channels.push_back(std::move(taken));
}

// Changes that the mapping asked for are not reported, only repairs that the data needed. Doubtful data is left to the
// data checks.
bool concernsTheData(const Change& change) {
    static constexpr std::string_view kKinds[] = {"duplicates", "backwards", "gaps",     "jump",
                                                  "uneven",     "spikes",    "wild_time"};
    return std::find(std::begin(kKinds), std::end(kKinds), change.kind) != std::end(kKinds);
}

ImportMap mapOf(const DiagnosisFile& file, const ForeignTable& table, std::vector<std::string>& guesses) {
    ImportMap map = file.import.empty() ? guessMap(table, guesses) : readYaml<ImportMap>(file.import);
    for (const MeasuredChannel& wanted : file.channels) {
        if (wanted.column.empty()) continue;
        std::erase_if(map.map, [&](const ImportChannel& channel) { return channel.channel == wanted.channel; });
        ImportChannel channel;
        channel.channel = wanted.channel;
        channel.from = wanted.column;
        channel.unit = wanted.unit;
        map.map.push_back(std::move(channel));
    }
    return map;
}

Log readLogOf(const Recording& recording, const DiagnosisFile& file, std::vector<std::string>& notes) {
    const auto note = [&](const std::string& text) { notes.push_back(recording.name + ": " + text); };
    if (file.import.empty() && isTreadLog(recording.log)) {
        Log log = readLog(recording.log);
        for (const MeasuredChannel& channel : file.channels) takeColumn(log, channel, recording.log);
        throwIfAny(unitFaults(log, recording.log));
        return log;
    }
    const ForeignTable table = readForeignTable(recording.log);
    std::vector<std::string> guesses;
    const ImportMap map = mapOf(file, table, guesses);
    const Imported imported = importLog(table, map);
    for (const std::string& guess : guesses) note(guess + "; name a mapping file (import) to set it explicitly");
    for (const Change& change : imported.changes) {
        if (!concernsTheData(change)) continue;
        note(change.channel.empty() ? change.text : change.channel + ": " + change.text);
    }
    return imported.logs.front();
}

// The recording within its window, time from 0. Samples missing at the ends of a channel (an imported delay) are not
// part of it.
Log windowed(const Log& log, const Recording& recording) {
    const std::vector<double>& time = log.channels.front().values;
    const auto first = std::lower_bound(time.begin(), time.end(), recording.from) - time.begin();
    const auto last = std::upper_bound(time.begin(), time.end(), recording.to) - time.begin();
    if (last - first < 2 || time[last - 1] - time[first] < kShortest) {
        throw LoadError(
            {{recording.log, 0, 0, "",
              fmt::format("has {:.3g} s within the window from {} s to {}, expected at least {} s: a shorter drive "
                          "cannot separate causes; widen the window (from, to) or remove the recording",
                          last > first ? time[last - 1] - time[first] : 0.0, numberText(recording.from),
                          recording.to == kInfinity ? "the end" : numberText(recording.to) + " s", kShortest)}});
    }
    Log cut;
    for (const Channel& channel : log.channels) {
        cut.channels.push_back({channel.name, channel.unit,
                                std::vector<double>(channel.values.begin() + first, channel.values.begin() + last)});
    }
    const double begin = cut.channels.front().values.front();
    for (double& t : cut.channels.front().values) t -= begin;
    return cut;
}

}  // namespace

Recorded readRecordings(const DiagnosisFile& file) {
    Recorded recorded;
    std::vector<Problem> problems;
    const auto read = [&](const Recording& recording) {
        try {
            Log log = readLogOf(recording, file, recorded.notes);
            addVelocities(log);
            return windowed(log, recording);
        } catch (const LoadError& error) {
            problems.insert(problems.end(), error.problems().begin(), error.problems().end());
            return Log{};
        }
    };
    for (const Recording& recording : file.recordings) {
        recorded.logs.push_back(read(recording));
        recorded.references.push_back(recording.reference.empty() ? Log{} : read(referenceOf(recording)));
    }
    for (const Recording& recording : file.before) recorded.before.push_back(read(recording));
    throwIfAny(std::move(problems));
    return recorded;
}

}  // namespace tread::recording
