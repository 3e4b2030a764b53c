// A log: named channels over one time base, in memory.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tread {

struct Channel {
    std::string name;            // "chassis.yaw_rate"
    std::string unit;            // SI, "rad/s"
    std::vector<double> values;  // one per sample
};

struct Log {
    std::vector<Channel> channels;  // the first is "time [s]", strictly increasing

    std::size_t samples() const { return channels.empty() ? 0 : channels.front().values.size(); }

    // The channel of that name; nullptr when the log has none.
    const Channel* find(std::string_view name) const {
        for (const Channel& channel : channels) {
            if (channel.name == name) return &channel;
        }
        return nullptr;
    }
};

}  // namespace tread
