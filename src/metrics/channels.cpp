#include "metrics/channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

TimeSeries seriesOf(const Log& log, const Channel& channel) {
    const std::vector<double>& time = log.channels.front().values;
    for (std::size_t i = 0; i < channel.values.size(); ++i) {
        if (!std::isfinite(channel.values[i])) {
            notFound(fmt::format("it needs {}, which is not finite at t = {:.6g} s", channel.name, time[i]));
        }
    }
    return {time, channel.values};
}

}  // namespace

std::vector<TimeSeries> channels(const Log& log, const std::vector<std::string_view>& names) {
    std::string missing;
    for (std::string_view name : names) {
        if (!log.find(name)) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", name);
    }
    if (!missing.empty()) notFound(fmt::format("it needs {}, which the log does not have", missing));
    if (log.samples() < 2) notFound("it needs a log with at least two samples");
    std::vector<TimeSeries> out;
    for (std::string_view name : names) out.push_back(seriesOf(log, *log.find(name)));
    return out;
}

std::optional<TimeSeries> channelIfThere(const Log& log, std::string_view name) {
    const Channel* channel = log.find(name);
    if (!channel) return {};
    return seriesOf(log, *channel);
}

TimeSeries speed(const Log& log) {
    TimeSeries out = channels(log, {"chassis.vx"}).front();
    if (const auto lateral = channelIfThere(log, "chassis.vy")) {
        for (std::size_t i = 0; i < out.size(); ++i) out.value[i] = std::hypot(out.value[i], lateral->value[i]);
    }
    return out;
}

std::optional<TimeSeries> sideslip(const Log& log) {
    if (auto logged = channelIfThere(log, "chassis.sideslip")) return logged;
    auto lateral = channelIfThere(log, "chassis.vy");
    if (!lateral) return {};
    const TimeSeries forward = channels(log, {"chassis.vx"}).front();
    for (std::size_t i = 0; i < lateral->size(); ++i) {
        lateral->value[i] = std::atan2(lateral->value[i], forward.value[i]);
    }
    return lateral;
}

std::optional<TimeSeries> frontLessRear(const Log& log, std::string_view quantity) {
    const auto wheel = [&](std::string_view name) {
        return channelIfThere(log, fmt::format("wheel.{}.{}", name, quantity));
    };
    auto out = wheel("front_left");
    const auto fr = wheel("front_right"), rl = wheel("rear_left"), rr = wheel("rear_right");
    if (!out || !fr || !rl || !rr) return {};
    for (std::size_t i = 0; i < out->size(); ++i) {
        out->value[i] = 0.5 * (out->value[i] + fr->value[i] - rl->value[i] - rr->value[i]);
    }
    return out;
}

void notFound(const std::string& why) {
    throw NotInLog(why);
}

}  // namespace tread
