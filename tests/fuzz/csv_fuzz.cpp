// Any bytes: the log reader either gives a log that keeps its promises or a LoadError with at least one fault.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "log/csv.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const tread::Log log = tread::parseLog({reinterpret_cast<const char*>(data), size}, "fuzz.csv");
        const std::vector<double>& time = log.channels.front().values;
        if (time.empty()) std::abort();
        for (const tread::Channel& channel : log.channels) {
            if (channel.values.size() != time.size() || channel.name.empty() || channel.unit.empty()) std::abort();
        }
        for (std::size_t i = 0; i < time.size(); ++i) {
            if (!std::isfinite(time[i]) || (i > 0 && time[i] <= time[i - 1])) std::abort();
        }
    } catch (const tread::LoadError& error) {
        if (error.problems().empty()) std::abort();
    }
    return 0;
}
