// Logs sampled from closed forms, for the tests of the metrics.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "metrics/metrics.h"

namespace tread::sample {

struct Signal {
    std::string name;
    std::string unit;
    std::function<double(double)> value;  // of the time in s
};

inline std::function<double(double)> constant(double value) {
    return [value](double) { return value; };
}

inline Log log(double rate, double duration, const std::vector<Signal>& signals) {
    Log out{{{"time", "s", {}}}};
    const auto count = static_cast<int>(std::lround(duration * rate)) + 1;
    for (int i = 0; i < count; ++i) out.channels[0].values.push_back(i / rate);
    for (const Signal& signal : signals) {
        out.channels.push_back({signal.name, signal.unit, {}});
        for (double t : out.channels[0].values) out.channels.back().values.push_back(signal.value(t));
    }
    return out;
}

inline Channel& channel(Log& log, std::string_view name) {
    for (Channel& candidate : log.channels) {
        if (candidate.name == name) return candidate;
    }
    throw std::invalid_argument("no channel " + std::string(name));
}

inline void addNoise(Log& log, std::string_view name, double deviation, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, deviation);
    for (double& value : channel(log, name).values) value += normal(random);
}

inline void remove(Log& log, std::string_view name) {
    std::erase_if(log.channels, [&](const Channel& candidate) { return candidate.name == name; });
}

inline double valueOf(const std::vector<Metric>& metrics, std::string_view name) {
    for (const Metric& metric : metrics) {
        if (metric.name == name) return metric.value;
    }
    ADD_FAILURE() << "no metric " << name;
    return 0;
}

inline std::string errorOf(const Log& log, std::string_view manoeuvre) {
    try {
        metrics(log, manoeuvre);
    } catch (const MetricError& error) {
        return error.what();
    }
    return "no error";
}

// Sampling rates at which every metric is checked.
inline constexpr double kRates[] = {50, 100, 1000};

inline constexpr double kDegree = 3.14159265358979323846 / 180;
inline constexpr double kGravity = 9.80665;

}  // namespace tread::sample
