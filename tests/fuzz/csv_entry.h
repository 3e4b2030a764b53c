// What the fuzzer and the replay of its corpus do with a text: read it as a log. It must end in a log that keeps its
// promises, or in a LoadError that says something.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "fuzz/demand.h"
#include "log/csv.h"

namespace tread::fuzz {

// True when the text was taken.
inline bool readHostileCsv(std::string_view text) {
    try {
        const Log log = parseLog(text, "fuzz.csv");
        demand(log.samples() > 0);
        const std::vector<double>& time = log.channels.front().values;
        for (const Channel& channel : log.channels) {
            demand(channel.values.size() == time.size() && !channel.name.empty() && !channel.unit.empty());
        }
        for (std::size_t i = 0; i < time.size(); ++i) {
            demand(std::isfinite(time[i]) && (i == 0 || time[i] > time[i - 1]));
        }
    } catch (const LoadError& error) {
        demand(!error.problems().empty());
        for (const Problem& problem : error.problems()) demand(problem.file == "fuzz.csv" && !problem.text.empty());
        return false;
    }
    return true;
}

}  // namespace tread::fuzz
