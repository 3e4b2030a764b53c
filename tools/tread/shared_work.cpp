#include "shared_work.h"

#include <charconv>

#include "base/text/number_text.h"
#include "drive.h"
#include "refuse.h"

namespace tread::program {

Shard shardOf(const std::string& text) {
    if (text.empty()) return {};
    std::uint64_t part = 0, of = 0;
    const char* const end = text.data() + text.size();
    const auto slash = std::from_chars(text.data(), end, part);
    if (slash.ec == std::errc{} && slash.ptr != end && *slash.ptr == '/') {
        const auto last = std::from_chars(slash.ptr + 1, end, of);
        if (last.ec == std::errc{} && last.ptr == end && part >= 1 && part <= of) return {part - 1, of};
    }
    refuse("--shard", "found " + quote(text) + ", expected i/N with i from 1 to N, for example 2/8");
}

WorkOptions workOptions(int threads, const std::string& shard, Progress& progress) {
    return {.threads = threads,
            .shard = shardOf(shard),
            .stop = stopAsked,
            .progress = [&](std::uint64_t done,
                            std::uint64_t of) { progress.at(static_cast<double>(done), static_cast<double>(of)); },
            .warn = [](const std::string& text) { warn(text); }};
}

}  // namespace tread::program
