// What the fuzzer and the tests do with the content of a binary log: pack it and read it. It must end in a log that
// keeps its promises, or in a LoadError that says something.
#pragma once

#include <zstd.h>

#include <cmath>
#include <string>
#include <string_view>

#include "fuzz/demand.h"
#include "log/binary_log.h"
#include "tread/problem.h"

namespace tread::fuzz {

// True when the bytes were taken.
inline bool readHostilePacked(std::string_view bytes) {
    try {
        const Log log = parseBinaryLog(bytes, "fuzz.tlog");
        const std::vector<double>& time = log.channels.front().values;
        demand(!time.empty());
        for (const Channel& channel : log.channels)
            demand(channel.values.size() == time.size() && !channel.name.empty() && !channel.unit.empty());
        for (std::size_t i = 0; i < time.size(); ++i)
            demand(std::isfinite(time[i]) && (i == 0 || time[i] > time[i - 1]));
        return true;
    } catch (const LoadError& error) {
        demand(!error.problems().empty());
        for (const Problem& problem : error.problems()) demand(problem.file == "fuzz.tlog" && !problem.text.empty());
        return false;
    }
}

inline std::string packed(std::string_view content) {
    std::string frame(ZSTD_compressBound(content.size()), '\0');
    frame.resize(ZSTD_compress(frame.data(), frame.size(), content.data(), content.size(), 1));
    return frame;
}

// The bytes as they are, and as the content of a sound frame.
inline bool readHostileBinaryLog(std::string_view bytes) {
    const bool bare = readHostilePacked(bytes), inside = readHostilePacked(packed(bytes));
    return bare || inside;
}

}  // namespace tread::fuzz
