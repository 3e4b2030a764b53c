#include "recording/position.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "log/direction.h"
#include "log/log_columns.h"

namespace tread::recording {
namespace {

using Values = std::vector<double>;

constexpr double kLongestSilence = 0.25;  // s between two values; what the car does within a longer one is unknown

constexpr double kStoodStill = 0.01;  // m or rad; over a longer gap, a car that moved by less stood still

// Interpolated between new values, NaN where none came for too long. A value that is repeated exactly was held.
Values betweenUpdates(const Values& time, const Values& values) {
    Values known = values;
    std::size_t before = time.size();  // the last new value
    for (std::size_t i = 0; i < time.size(); ++i) {
        const bool is_new = std::isfinite(values[i]) && (before == time.size() || values[i] != values[before]);
        if (!is_new && i + 1 < time.size()) continue;
        for (std::size_t k = before + 1; before < i && k < i; ++k) {
            const double share = (time[k] - time[before]) / (time[i] - time[before]);
            const double moved = values[i] - values[before];
            const bool lost = time[i] - time[before] > kLongestSilence && std::abs(moved) > kStoodStill;
            known[k] = lost ? kRequired : values[before] + share * moved;
        }
        before = i;
    }
    return known;
}

// Rate of change at each sample.
Values rateOf(const Values& time, const Values& known) {
    Values rates(time.size(), 0);
    for (std::size_t i = 0; i < time.size(); ++i) {
        const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, time.size() - 1);
        rates[i] = (known[b] - known[a]) / (time[b] - time[a]);
    }
    return rates;
}

// The channel position.`name` of a source; nullptr when the log has none.
const Values* measured(const Log& log, const char* name, std::string_view source) {
    std::string channel = std::string("position.") + name;
    if (source != kPositionSource) channel += "@" + std::string(source);
    const Channel* found = log.find(channel);
    return found ? &found->values : nullptr;
}

// Along the axes of the heading.
void turn(Values& vx, Values& vy, const Values& heading) {
    for (std::size_t i = 0; i < vx.size(); ++i) {
        const double c = std::cos(heading[i]), s = std::sin(heading[i]);
        const double forward = c * vx[i] + s * vy[i];
        vy[i] = c * vy[i] - s * vx[i];
        vx[i] = forward;
    }
}

void addOf(Log& log, std::string_view source) {
    const Values& time = log.channels.front().values;
    const Values *x = measured(log, "x", source), *y = measured(log, "y", source);
    const Values* shown = measured(log, "heading", source);
    std::vector<Channel> found;
    const auto add = [&](const char* quantity, const char* unit, Values values) {
        std::string name = std::string(quantity) + "@" + std::string(source);
        if (!log.find(name)) found.push_back({std::move(name), unit, std::move(values)});
    };
    const Values heading = shown ? betweenUpdates(time, continuous(*shown)) : Values{};
    if (x && y) {
        Values vx = rateOf(time, betweenUpdates(time, *x)), vy = rateOf(time, betweenUpdates(time, *y));
        if (shown) turn(vx, vy, heading);
        else
            std::transform(vx.begin(), vx.end(), vy.begin(), vx.begin(),
                           [](double a, double b) { return std::hypot(a, b); });
        add("chassis.vx", "m/s", std::move(vx));
        if (shown) add("chassis.vy", "m/s", std::move(vy));
    }
    if (shown) add("chassis.yaw_rate", "rad/s", rateOf(time, heading));
    for (Channel& channel : found) log.channels.push_back(std::move(channel));
}

}  // namespace

void addVelocities(Log& log) {
    std::set<std::string> sources;
    for (const Channel& channel : log.channels) {
        if (!channel.name.starts_with("position.")) continue;
        const std::string_view source = sourceOf(channel.name);
        sources.insert(std::string(source.empty() ? kPositionSource : source));
    }
    for (const std::string& source : sources) addOf(log, source);
}

}  // namespace tread::recording
