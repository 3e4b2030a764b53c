// The parts of the data checks that look at one recording.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "recording/checks/data_checks.h"

namespace tread::recording::checks {

// Where the warnings about one recording go.
struct LogChecks {
    const Recording& recording;
    const Log& log;
    const Subject& nominal;
    std::vector<DataWarning>& found;

    static constexpr double kMoving = 3;   // m/s: below, a car can do anything
    static constexpr double kSliding = 4;  // m/s2: beyond, wheels and yaw rate do as they like

    const std::vector<double>& time() const { return log.channels.front().values; }
    const std::vector<double>* values(const std::string& channel) const;
    double rate() const;  // samples per second
    void warn(const std::string& channel, std::string what, std::string why, std::string advice) const;
};

// Each channel by itself: gaps, stuck, held, saturated, spikes; and the time base.
void checkChannels(const LogChecks& checks);

// Channels against each other: signs, units, swapped ones, delays.
void checkKinematics(const LogChecks& checks);

// The car that the file names. Gentle cornering follows its geometry: yaw rate = vx steer / (ratio (l + K vx^2)).
void checkCar(const LogChecks& checks);

// Least squares of y over x through the means, over the samples where both are numbers and `use` says so.
struct Relation {
    double correlation = 0;
    double slope = 0;
    double factor = 0;  // of y over x, through the origin
    double spread = 0;  // standard deviation of x
    int samples = 0;

    static constexpr int kFewest = 50;          // samples from which it says something
    static constexpr double kCorrelated = 0.8;  // from here both show the same thing
};
Relation relation(
    const std::vector<double>& x, const std::vector<double>& y,
    const std::function<bool(std::size_t)>& use = [](std::size_t) { return true; });

}  // namespace tread::recording::checks
