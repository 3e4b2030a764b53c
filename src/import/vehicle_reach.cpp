#include "import/vehicle_reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "log/direction.h"
#include "log/log_columns.h"

namespace tread {
namespace {

constexpr double kPeak = 0.99;         // quantile of the magnitude that counts as the peak: spikes lie above
constexpr double kAmongSpikes = 0.75;  // the same where up to a quarter of the samples are spikes
constexpr double kInfinite = std::numeric_limits<double>::infinity();

// A unit that a channel may be logged in, and the peaks that a road vehicle reaches in it. Units stand in the order in
// which they are tried; where two fit, the first is taken.
struct Reach {
    std::string_view unit;
    double least, most;
};

struct Quantity {
    std::string_view channel;  // "wheel.*.spin": of every wheel
    std::vector<Reach> reaches;
    double fastest;  // SI unit per second
};

const std::vector<Quantity>& quantities() {
    // A driver turns the wheel by up to two turns at 20 rad/s, a robot at 45. A car yaws at up to half a turn in a
    // second, its body rolls by 15 degrees; what is above is in degrees. Lateral accelerations peak between 0.15 and
    // 1.6 g; below 0.15 nothing can be told. Rates of change: 3 g along the car, 30 rad/s2 about its axes, a wheel that
    // locks within 20 ms, an accelerometer on a kerb.
    static const std::vector<Quantity> list = {
        {"driver.steering_wheel_angle", {{"rad", 0, 14}, {"deg", 0, 900}}, 50},
        {"steering.angle", {{"rad", 0, 14}, {"deg", 0, 900}}, 50},
        {"steering.road_wheel_angle", {{"rad", 0, 0.9}, {"deg", 0, 50}}, 5},
        {"driver.throttle", {{"-", 0, 1.05}, {"%", 0, 105}}, kInfinite},
        {"driver.brake", {{"-", 0, 1.05}, {"%", 0, 105}}, kInfinite},
        {"driver.clutch", {{"-", 0, 1.05}, {"%", 0, 105}}, kInfinite},
        {"brakes.pressure", {{"bar", 0, 300}, {"kPa", 0, 30000}, {"Pa", 0, 3e7}}, kInfinite},
        {"chassis.vx", {{"m/s", 0, 70}, {"km/h", 0, 400}}, 30},
        {"chassis.vy", {{"m/s", 0, 25}, {"km/h", 0, 90}}, 30},
        {"chassis.yaw_rate", {{"rad/s", 0, 3.2}, {"deg/s", 0, 180}}, 30},
        {"chassis.roll_rate", {{"rad/s", 0, 3.2}, {"deg/s", 0, 180}}, 60},
        {"chassis.pitch_rate", {{"rad/s", 0, 3.2}, {"deg/s", 0, 180}}, 60},
        {"chassis.ax", {{"g", 0.15, 1.6}, {"m/s2", 0, 40}}, 2000},
        {"chassis.ay", {{"g", 0.15, 1.6}, {"m/s2", 0, 40}}, 2000},
        {"chassis.az", {{"g", 0.15, 3}, {"m/s2", 0, 60}}, 4000},
        {"chassis.roll", {{"rad", 0, 0.3}, {"deg", 0, 30}}, 3},
        {"chassis.pitch", {{"rad", 0, 0.3}, {"deg", 0, 30}}, 3},
        {"chassis.yaw", {{"rad", 0, 6.4}, {"deg", 0, kInfinite}}, kInfinite},
        {"chassis.sideslip", {{"rad", 0, 1.6}, {"deg", 0, 180}}, kInfinite},
        {"position.heading", {{"rad", 0, 6.4}, {"deg", 0, kInfinite}}, kInfinite},
        {"driveline.engine_speed", {{"rad/s", 0, 650}, {"rpm", 0, 20000}}, 5000},
        {"wheel.*.speed", {{"m/s", 0, 75}, {"km/h", 0, 420}}, 1000},
        {"wheel.*.spin", {{"rad/s", 0, 300}, {"rpm", 0, 3000}}, 3000}};
    return list;
}

bool isOf(std::string_view channel, std::string_view pattern) {
    const std::size_t star = pattern.find('*');
    if (star == std::string_view::npos) return channel == pattern;
    return channel.starts_with(pattern.substr(0, star)) && channel.ends_with(pattern.substr(star + 1));
}

const Quantity* quantity(std::string_view channel) {
    for (const Quantity& one : quantities()) {
        if (isOf(quantityOf(channel), one.channel)) return &one;
    }
    return nullptr;
}

double peakOf(const std::vector<double>& values, double share = kPeak) {
    std::vector<double> sizes;
    for (const double value : values) {
        if (std::isfinite(value)) sizes.push_back(std::abs(value));
    }
    if (sizes.empty()) return std::nan("");
    const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    return *at;
}

bool fits(const Reach& reach, double peak) {
    return peak >= reach.least && peak <= reach.most;
}

}  // namespace

PlausibleUnit plausibleUnit(std::string_view channel, std::string_view si, const std::vector<double>& values) {
    const double peak = peakOf(values);
    const Quantity* const known = quantity(channel);
    if (!known || !std::isfinite(peak)) return {std::string(si), si == "-" ? "" : "the unit of the channel"};
    for (const double share : {kPeak, kAmongSpikes}) {  // many spikes may hide the car
        const double most = peakOf(values, share);
        for (const Reach& reach : known->reaches) {
            if (!fits(reach, most)) continue;
            return {std::string(reach.unit), fmt::format("values{} peak at {:.3g}, plausible in {}",
                                                         share < kPeak ? " without spikes" : "", most, reach.unit)};
        }
    }
    return {std::string(si), fmt::format("values peak at {:.3g}, plausible in no unit that such a channel has", peak)};
}

std::string implausible(std::string_view channel, std::string_view unit, const std::vector<double>& values) {
    const double peak = peakOf(values);
    const Quantity* const known = quantity(channel);
    if (!known || !std::isfinite(peak)) return {};
    for (const Reach& reach : known->reaches) {
        if (reach.unit == unit && peak > reach.most) {
            return fmt::format("values peak at {:.3g} {}, above the {:.3g} that a road vehicle reaches", peak, unit,
                               reach.most);
        }
    }
    return {};
}

bool fitsOnlyOneUnit(std::string_view channel, const std::vector<double>& values) {
    const double peak = peakOf(values);
    const Quantity* const known = quantity(channel);
    if (!known || !std::isfinite(peak)) return false;
    return std::count_if(known->reaches.begin(), known->reaches.end(),
                         [&](const Reach& reach) { return peak <= reach.most; }) == 1;
}

double fastestChange(std::string_view channel) {
    const Quantity* const known = quantity(channel);
    return known ? known->fastest : kInfinite;
}

double largestValue(std::string_view channel) {
    const Quantity* const known = quantity(channel);
    const auto si = logUnit(std::string(channel));
    if (!known || !si || isDirection(channel)) return kInfinite;
    for (const Reach& reach : known->reaches) {
        if (reach.unit == *si) return reach.most;
    }
    return kInfinite;
}

}  // namespace tread
