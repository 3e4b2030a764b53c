#include "import/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/text/number_text.h"
#include "import/channel_names.h"
#include "import/channel_reader.h"
#include "import/columns.h"
#include "import/doubts.h"
#include "import/formats/unit_spelling.h"
#include "import/repair.h"
#include "import/time_base.h"
#include "log/log_columns.h"

namespace tread {
namespace {

// Without the ends that a channel with its own time does not reach, when it lacks but a little.
Stretch reached(const Stretch& recording, const std::vector<WholeChannel>& channels, double longest,
                std::vector<Change>& changes) {
    double begin = 0, end = recording.duration();
    for (const WholeChannel& channel : channels) {
        const double first = channel.first - recording.begin, last = channel.last - recording.begin;
        if (first <= longest) begin = std::max(begin, first);
        if (last >= recording.duration() - longest) end = std::min(end, last);
    }
    if (begin == 0 && end == recording.duration()) return recording;
    Stretch kept{{}, {}, recording.begin};
    for (std::size_t i = 0; i < recording.rows.size(); ++i) {
        if (recording.time[i] < begin || recording.time[i] > end) continue;
        kept.rows.push_back(recording.rows[i]);
        kept.time.push_back(recording.time[i]);
    }
    const std::size_t lost = recording.rows.size() - kept.rows.size();
    if (lost > 0)
        changes.push_back(
            {"cut", "", lost,
             fmt::format("{} at the ends, which not every channel reaches, cut off", counted(lost, "sample"))});
    return kept;
}

// The samples of a recording that the mapping asks for and that every delayed channel reaches.
Stretch cut(const Stretch& recording, const ImportMap& map, std::vector<Change>& changes) {
    double begin = map.time.begin, end = map.time.end.value_or(kInfinity);
    for (const ImportChannel& channel : map.map) {
        begin = std::max(begin, -channel.delay);
        if (channel.delay > 0) end = std::min(end, recording.duration() - channel.delay);
    }
    Stretch kept{{}, {}, recording.begin};
    for (std::size_t i = 0; i < recording.rows.size(); ++i) {
        if (recording.time[i] < begin || recording.time[i] > end) continue;
        kept.rows.push_back(i);  // index within the recording
        kept.time.push_back(recording.time[i]);
    }
    const std::size_t lost = recording.rows.size() - kept.rows.size();
    if (lost > 0) changes.push_back({"cut", "", lost, fmt::format("{} samples at the ends cut off", lost)});
    return kept;
}

Log logOf(const Stretch& whole, const std::vector<WholeChannel>& channels, const ForeignTable& table,
          const ImportMap& map, std::vector<Change>& changes) {
    const Stretch recording = reached(whole, channels, map.repairs.max_jump, changes);
    const Stretch kept = cut(recording, map, changes);
    if (kept.rows.size() < 2) {
        throw LoadError({{table.file, 0, 0, "", "has fewer than two samples left, expected a recording"}});
    }
    Log log{{{"time", "s", shifted(kept.time, -kept.time.front())}}};
    for (const WholeChannel& channel : channels) {
        std::vector<double> values, chosen;
        for (const std::size_t row : recording.rows) values.push_back(channel.values[row]);
        repair(channel, map.repairs, recording.time, values, changes);
        for (const std::size_t i : kept.rows) chosen.push_back(values[i]);
        zeroAndOffset(channel, kept.time, chosen, changes);
        log.channels.push_back({channel.how->channel, channel.unit, std::move(chosen)});
    }
    for (std::size_t i = 0; i < map.constants.size(); ++i) {
        const ImportConstant& constant = map.constants[i];
        const auto known = logUnit(constant.channel);
        const std::string given = constant.unit.empty() ? std::string(known.value_or("-")) : constant.unit;
        const std::string unit = known ? std::string(*known) : siUnitOf(given);
        const ForeignColumn itself{constant.channel, given, {}, 0, 0, {}};
        const std::string path = "constants." + std::to_string(i) + ".unit";
        const double value = scalingTo(*foreignUnit(itself, given, path), unit, path, itself)(constant.value);
        log.channels.push_back({constant.channel, unit, std::vector<double>(kept.rows.size(), value)});
        changes.push_back({"constant", constant.channel, kept.rows.size(),
                           fmt::format("{} {} at every time", numberText(value), unit)});
    }
    if (map.repairs.rate) resampleLog(log, *map.repairs.rate, changes);
    return log;
}

void checkNames(const ImportMap& map) {
    std::vector<Problem> problems;
    std::set<std::string> seen{"time"};
    const auto look = [&](const std::string& name, const std::string& path) {
        if (!isChannelName(name)) {
            problems.push_back({"", 0, 0, path,
                                "found " + quote(name) +
                                    ", expected the name of a channel in small letters, digits, _ and dots, with a "
                                    "further source after @: chassis.ay, chassis.ay@can"});
        } else if (!seen.insert(name).second) {
            problems.push_back(
                {"", 0, 0, path, "found " + quote(name) + " for the second time; a channel has one source"});
        } else if (std::string fault = misspelling(name); !fault.empty()) {
            problems.push_back({"", 0, 0, path, std::move(fault)});
        }
    };
    for (std::size_t i = 0; i < map.map.size(); ++i) look(map.map[i].channel, fmt::format("map.{}.channel", i));
    for (std::size_t i = 0; i < map.constants.size(); ++i) {
        look(map.constants[i].channel, fmt::format("constants.{}.channel", i));
    }
    if (map.map.empty()) problems.push_back({"", 0, 0, "map", "found no channel; the log would hold nothing but time"});
    if (!problems.empty()) throw LoadError(std::move(problems));
}

std::vector<std::string> notTaken(const ForeignTable& table, const ImportMap& map) {
    std::set<std::string> taken{map.time.from};
    for (const ForeignColumn& column : table.columns) {
        if (!column.time.empty()) taken.insert(column.time);
    }
    for (const ImportChannel& channel : map.map) {
        taken.insert(channel.from);
        taken.insert(channel.time);
        taken.insert(channel.mean_with.begin(), channel.mean_with.end());
    }
    std::vector<std::string> left;
    for (const ForeignColumn& column : table.columns) {
        if (!taken.contains(column.name)) left.push_back(column.name);
    }
    return left;
}

}  // namespace

Imported importLog(const ForeignTable& table, const ImportMap& map) {
    checkNames(map);
    Imported result;
    for (const std::string& note : table.notes) result.changes.push_back({"reading", "", 1, note});
    const std::vector<double> time = timeOfRows(table, map.time, result.changes);
    result.rows = time.size();

    std::vector<WholeChannel> channels;
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < map.map.size(); ++i) {
        try {
            channels.push_back(readChannel(table, map, i, time, result.changes));
        } catch (const LoadError& error) {
            problems.insert(problems.end(), error.problems().begin(), error.problems().end());
        }
    }
    if (!problems.empty()) throw LoadError(std::move(problems));

    for (const Stretch& recording : recordingsOf(time, table, map.repairs, result.changes)) {
        if (recording.rows.size() < 2 && map.repairs.at_jump == AtJump::split) continue;
        result.logs.push_back(logOf(recording, channels, table, map, result.changes));
    }
    if (result.logs.empty()) {
        throw LoadError({{table.file, 0, 0, "", "has no recording of more than one sample"}});
    }
    const std::vector<Change> doubtful = doubts(result.logs.front());
    result.changes.insert(result.changes.end(), doubtful.begin(), doubtful.end());
    result.not_taken = notTaken(table, map);
    return result;
}

}  // namespace tread
