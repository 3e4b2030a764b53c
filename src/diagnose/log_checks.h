// The parts of the data checks that look at one recording.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnose/data_checks.h"

namespace tread {

// Where the warnings about one recording go.
struct LogChecks {
    const Recording& recording;
    const Log& log;
    const Subject& nominal;
    std::vector<DataWarning>& found;

    const std::vector<double>& time() const { return log.channels.front().values; }
    const std::vector<double>* values(const std::string& channel) const;
    double rate() const;  // samples per second
    void warn(const std::string& channel, std::string what, std::string why, std::string advice) const;
};

// Each channel by itself: gaps, stuck, held, saturated, spikes; and the time base.
void checkChannels(const LogChecks& checks);

// Channels against each other: signs, units, swapped ones, delays; and the car that the file names.
void checkKinematics(const LogChecks& checks);

// Least squares of y over x through the means, over the samples where both are numbers and `use` says so.
struct Relation {
    double correlation = 0;
    double slope = 0;
    double factor = 0;  // of y over x, through the origin
    double spread = 0;  // standard deviation of x
    int samples = 0;
};
Relation relation(
    const std::vector<double>& x, const std::vector<double>& y,
    const std::function<bool(std::size_t)>& use = [](std::size_t) { return true; });

}  // namespace tread
