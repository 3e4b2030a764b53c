#include "diagnose/model/parameter.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/pattern.h"
#include "recording/further_instruments.h"

namespace tread::diagnose::model {
namespace {

constexpr double kOpenLimit = 1e-3;    // distance to an open limit, as a share of the nominal value or unit
constexpr double kKneeDistance = 0.3;  // units; a number whose limits leave it less room than this is not a parameter

// Tolerances of numbers whose description cannot state one as a fraction, because the nominal value is 0 or because a
// fraction would be meaningless. Chassis angles: accuracy of alignment benches. Instruments: data sheets of common
// ones.
const std::vector<KnownWithin>& usualTolerances() {
    static const std::vector<KnownWithin> known{
        {"*.suspension.toe", 0, 0.0009},
        {"*.suspension.camber", 0, 0.006},
        {"inertia.roll_yaw", 0, 20},
        {"lateral_offset", 0, 0.01},
        {"road.grade", 0, 0.001},
        {"road.bank", 0, 0.001},
        {"instruments.ax.bias", 0, 0.03},
        {"instruments.ay.bias", 0, 0.03},
        {"instruments.*_rate.bias", 0, 1e-3},
        {"instruments.roll.bias", 0, 2e-3},
        {"instruments.sideslip.bias", 0, 2e-3},
        {"instruments.*.gain", 0.003, 0},
        {"instruments.latency", 0, 0.005},
        {"instruments.speed.delay", 0, 0.005},
        {"instruments.inertial_unit.x", 0, 0.02},
        {"instruments.inertial_unit.y", 0, 0.02},
        {"instruments.inertial_unit.z", 0, 0.02},
        {"instruments.inertial_unit.roll", 0, 0.003},
        {"instruments.inertial_unit.pitch", 0, 0.003},
        {"instruments.inertial_unit.yaw", 0, 0.003},
        {"instruments.steering_wheel_angle.bias", 0, 0.005},
    };
    return known;
}

double toleranceOf(const Number& number, const std::vector<KnownWithin>& told) {
    const double value = std::abs(*number.value);
    double tolerance = number.about.tolerance * value;
    const auto take = [&](const std::vector<KnownWithin>& list, const std::string& path) {
        for (const KnownWithin& known : list) {
            if (matches(known.path, path)) tolerance = known.relative * value + known.absolute;
        }
    };
    // A further instrument is usually known as well as the first one of its quantity.
    const std::string in_first = recording::pathInFirst(number.path);
    take(usualTolerances(), in_first.empty() ? number.path : in_first);
    take(told, number.path);
    return tolerance;
}

// Narrows the range of the parameter, in units, so that the number stays within its limits.
void limit(Parameter& parameter, const Limits& limits, double nominal, double by) {
    const auto until = [&](double end, bool open) {
        const double margin = open ? kOpenLimit * std::max(std::abs(nominal), std::abs(by)) : 0;
        return (end + (end < nominal ? margin : -margin) - nominal) / by;
    };
    double low = std::isfinite(limits.lowest) ? until(limits.lowest, limits.lowest_open) : -kInfinity;
    double high = std::isfinite(limits.highest) ? until(limits.highest, limits.highest_open) : kInfinity;
    if (by < 0) {
        low = std::isfinite(limits.highest) ? until(limits.highest, limits.highest_open) : -kInfinity;
        high = std::isfinite(limits.lowest) ? until(limits.lowest, limits.lowest_open) : kInfinity;
    }
    parameter.lowest = std::max(parameter.lowest, std::min(low, 0.0));
    parameter.highest = std::min(parameter.highest, std::max(high, 0.0));
}

// Instruments that record the driver's inputs are excluded, because the replay is driven with these inputs.
bool readingOnly(const std::string& path) {
    const auto of = [&](const char* input) { return path.starts_with(std::string("instruments.") + input); };
    return path.starts_with("instruments.") && !of("steering_wheel_angle") && !of("throttle") && !of("brake");
}

// Road, wind and the zeros of instruments change from day to day.
bool staysTheSame(const std::string& path) {
    return !path.starts_with("road.") && !path.starts_with("wind.") && !path.ends_with(".bias");
}

}  // namespace

void move(Subject& subject, const Parameter& parameter, double units) {
    if (units == 0) return;
    std::size_t found = 0;
    for (const Number& number : numbers(subject)) {
        for (const Parameter::Move& one : parameter.moves) {
            if (number.path != one.path) continue;
            *number.value += units * one.by;
            if (++found == parameter.moves.size()) return;
        }
    }
}

std::vector<Parameter> nuisances(const Subject& nominal, const std::vector<KnownWithin>& tolerances, double same) {
    Subject subject = nominal;
    std::vector<Parameter> found;
    for (const Number& number : numbers(subject)) {
        const double tolerance = toleranceOf(number, tolerances) * (staysTheSame(number.path) ? same : 1);
        if (!(tolerance > 0) || !std::isfinite(tolerance)) continue;
        const double by = tolerance / std::sqrt(3.0);
        Parameter parameter{{{number.path, *number.value, by}}};
        limit(parameter, number.about.limits, *number.value, by);
        parameter.instruments_only = readingOnly(number.path);
        if (parameter.highest - parameter.lowest > kKneeDistance) found.push_back(std::move(parameter));
    }
    return found;
}

std::vector<Eigen::Index> joined(const std::vector<Eigen::Index>& some, const std::vector<Eigen::Index>& more) {
    std::vector<Eigen::Index> all;
    all.reserve(some.size() + more.size());
    for (const auto* list : {&some, &more})
        for (const Eigen::Index one : *list) all.push_back(one);
    return all;
}

std::vector<Share> mixture(const Parameter& parameter, const std::vector<Parameter>& all,
                           const std::vector<Eigen::Index>& others) {
    std::vector<Share> shares;
    for (const Parameter::Move& move : parameter.moves) {
        const auto same = std::find_if(others.begin(), others.end(), [&](Eigen::Index other) {
            return all[other].moves.size() == 1 && all[other].name() == move.path;
        });
        if (same == others.end()) return {};
        shares.push_back({*same, move.by / all[*same].moves.front().by});
    }
    return shares;
}

std::vector<Parameter> knobsOf(const Effect& effect, const Subject& nominal) {
    Subject subject = nominal;
    const std::vector<Number> all = numbers(subject);
    std::vector<Parameter> knobs;
    for (const catalogue::Knob& knob : effect.knobs) {
        Parameter parameter;
        parameter.instruments_only = std::all_of(knob.paths.begin(), knob.paths.end(), readingOnly);
        parameter.highest = parameter.instruments_only ? kLargestReading : kLargestEffect;
        parameter.lowest = -parameter.highest;
        for (std::size_t i = 0; i < knob.paths.size(); ++i) {
            const std::string& path = knob.paths[i];
            const auto number = std::find_if(all.begin(), all.end(), [&](const Number& n) { return n.path == path; });
            if (number == all.end()) continue;
            const double share = knob.shares.empty() ? 1 : knob.shares[i];
            const double by = share * (knob.relative ? knob.typical * *number->value : knob.typical);
            if (by == 0) continue;
            parameter.moves.push_back({path, *number->value, by});
            limit(parameter, number->about.limits, *number->value, by);
        }
        if (knob.direction == catalogue::Direction::up) parameter.lowest = 0;
        if (knob.direction == catalogue::Direction::down) parameter.highest = 0;
        if (!parameter.moves.empty()) knobs.push_back(std::move(parameter));
    }
    return knobs;
}

}  // namespace tread::diagnose::model
