#include "recording/driver_inputs.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "base/math/lag.h"
#include "inference/whitening.h"
#include "log/log_columns.h"
#include "recording/observation.h"

namespace tread::recording {
namespace {

// Samples on either side of the middle of a span; the widest span whose parabola fits is used.
constexpr std::array<std::size_t, 5> kReaches{50, 25, 12, 6, 3};
constexpr double kLikeNoise = 1.3;  // residual of a parabola over the noise; raising this rounds off fast inputs

constexpr double kFollowSpan = 0.4;  // s; longer rounds off the beginning of braking

constexpr double kLongestGap = 0.25;  // s; a straight line is taken to represent the driver over shorter gaps

// Value of a least-squares parabola through evenly spaced values at one of them; nothing when the residuals exceed the
// noise.
std::optional<double> parabolaAt(std::size_t place, std::span<const double> values, double noise) {
    const auto reach = static_cast<double>(values.size() / 2);
    double n = 0, xx = 0, xxxx = 0, y = 0, xy = 0, xxy = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = static_cast<double>(i) - reach;
        n += 1, xx += x * x, xxxx += x * x * x * x;
        y += values[i], xy += x * values[i], xxy += x * x * values[i];
    }
    const double bend = (n * xxy - xx * y) / (n * xxxx - xx * xx), slope = xy / xx, middle = (y - bend * xx) / n;
    double squares = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = static_cast<double>(i) - reach, off = values[i] - middle - (slope + bend * x) * x;
        squares += off * off;
    }
    if (!(squares <= (n - 3) * kLikeNoise * kLikeNoise * noise * noise)) return std::nullopt;
    const double x = static_cast<double>(place) - reach;
    return middle + (slope + bend * x) * x;
}

// Value at zero of the least-squares parabola through points about it; the mean of fewer than three.
double parabolaAtZero(std::span<const Curve::Point> points, double zero) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sums = Eigen::Vector3d::Zero();
    for (const Curve::Point& point : points) {
        const double x = point.x - zero;
        const Eigen::Vector3d row(1, x, x * x);
        normal += row * row.transpose();
        sums += row * point.y;
    }
    if (points.size() < 3) return sums(0) / normal(0, 0);
    return normal.ldlt().solve(sums)(0);
}

}  // namespace

std::vector<double> quietened(const std::vector<double>& values) {
    const double noise = inference::noiseBehind(values, inference::kThirdDifference);
    std::vector<double> result = values;
    if (noise == 0) return result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (const std::size_t reach : kReaches) {
            const std::size_t count = 2 * reach + 1;
            if (values.size() < count) continue;
            const std::size_t first = std::min(i - std::min(i, reach), values.size() - count);
            const auto value = parabolaAt(i - first, std::span(values).subspan(first, count), noise);
            if (!value) continue;
            result[i] = *value;
            break;
        }
    }
    return result;
}

bool isInput(std::string_view channel) {
    return channel.starts_with("driver.") || channel.starts_with("command.");
}

Log quietInputs(const Log& log) {
    Log inputs;
    for (const Channel& channel : log.channels) {
        if (isInput(channel.name) || quantityOf(channel.name) == "chassis.vx")
            inputs.channels.push_back({channel.name, channel.unit, quietened(channel.values)});
    }
    return inputs;
}

std::optional<InputGap> firstGap(const RecordedDrive& drive) {
    std::vector<std::string> needed{"driver.steering_wheel_angle", "driver.clutch"};
    const Channel* speed = measuredAs(drive.log, "chassis.vx");
    switch (drive.recording->speed) {
        case SpeedReplay::pedals:
            needed.insert(needed.end(), {"driver.throttle", "driver.brake"});
            break;
        case SpeedReplay::followed:
            if (speed) needed.push_back(speed->name);
            break;
        case SpeedReplay::command:
            needed.push_back(commandOf(drive.log));
    }
    std::optional<InputGap> first;
    for (const std::string& name : needed) {
        const Channel* channel = drive.log.find(name);
        if (!channel) continue;
        double known = drive.time.front();
        for (std::size_t i = 0; i < drive.time.size(); ++i) {
            const bool missing = !std::isfinite(channel->values[i]);
            if (missing && i + 1 < drive.time.size()) continue;
            if (drive.time[i] - known > kLongestGap && (!first || known < first->from))
                first = InputGap{name, known, drive.time[i]};
            known = drive.time[i];
        }
    }
    return first;
}

Curve driverInput(const RecordedDrive& drive, const std::string& channel, const Instrument& instrument,
                  const Limits& limits) {
    Curve curve;
    const Channel* shown = drive.inputs.find(channel);
    if (!shown) return curve;
    for (std::size_t i = 0; i < drive.time.size(); ++i) {
        if (!std::isfinite(shown->values[i])) continue;
        const double value = (shown->values[i] - instrument.bias) / instrument.gain;
        curve.points.push_back({drive.time[i] - instrument.delay, std::clamp(value, limits.lowest, limits.highest)});
    }
    return curve;
}

std::string commandOf(const Log& log) {
    for (const char* name : {"command.force", "command.acceleration"})
        if (log.find(name)) return name;
    return {};
}

Curve commandedForce(const RecordedDrive& drive, const ForceActuator& actuator, double mass) {
    const std::string command = commandOf(drive.log);
    Curve force = driverInput(drive, command, {}, {});
    const double scale = actuator.gain * (command == "command.acceleration" ? mass : 1);
    double before = 0, wanted_before = 0, time = 0;
    bool first = true;
    for (Curve::Point& point : force.points) {
        const double wanted = scale * point.y + actuator.bias;
        point.y = first ? wanted : lagged(before, wanted_before, wanted, actuator.lag, point.x - time);
        before = point.y, wanted_before = wanted, time = point.x, first = false;
        point.x += actuator.delay;
    }
    return force;
}

Curve followedSpeed(const RecordedDrive& drive, const Instruments& instruments) {
    const Channel* measured = measuredAs(drive.log, "chassis.vx");
    if (!measured) return {};
    const Curve recorded = driverInput(drive, measured->name, instrumentOf(instruments, measured->name), {});
    const std::vector<Curve::Point>& points = recorded.points;
    Curve smooth;
    for (std::size_t i = 0, first = 0, end = 0; i < points.size(); ++i) {
        // At an end of the drive, the span that begins or ends there: with a shorter one, more noise would become
        // force.
        const double latest = std::max(points.front().x, points.back().x - kFollowSpan);
        const double from = std::clamp(points[i].x - 0.5 * kFollowSpan, points.front().x, latest);
        while (points[first].x < from) ++first;
        while (end < points.size() && points[end].x <= from + kFollowSpan) ++end;
        const double speed = parabolaAtZero(std::span(points).subspan(first, end - first), points[i].x);
        smooth.points.push_back({points[i].x, std::max(speed, 0.0)});
    }
    return smooth;
}

}  // namespace tread::recording
