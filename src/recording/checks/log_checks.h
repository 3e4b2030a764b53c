// Data checks of a single recording.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "recording/checks/data_checks.h"

namespace tread::recording::checks {

// A recording, what it is checked against, and the list that receives the warnings.
struct LogChecks {
    const Recording& recording;
    const Log& log;
    const Subject& nominal;
    std::vector<DataWarning>& found;

    static constexpr double kMoving = 3;   // m/s; below this the relations between channels do not hold
    static constexpr double kSliding = 4;  // m/s2; beyond this the geometry of the car does not determine its motion

    const std::vector<double>& time() const { return log.channels.front().values; }
    const std::vector<double>* values(const std::string& channel) const;
    double rate() const;  // samples per second
    void warn(const std::string& channel, std::string what, std::string why, std::string advice) const;
};

// Each channel by itself: gaps, stuck, held or saturated values, spikes; and the time base.
void checkChannels(const LogChecks& checks);

// True, with a warning, when the car never moves: the other checks then say nothing about it.
bool standsStill(const LogChecks& checks);

// The drive as a whole: a car of another scale, commands in place of measured inputs.
void checkDrive(const LogChecks& checks);

// Whether a reference seems to be of another car than the recording `after` the change.
void checkSameCar(const LogChecks& reference, const LogChecks& after);

// Channels against each other: signs, units, swapped channels, and whether they move as one rigid body.
void checkKinematics(const LogChecks& checks);

// Checks that the named car fits the recording. In gentle cornering yaw rate = vx steer / (ratio (l + K vx^2)).
void checkCar(const LogChecks& checks);

// Linear relation of y to x over the samples at which both are finite and `use` is true; the slope is that of the
// least-squares line.
struct Relation {
    double correlation = 0;
    double slope = 0;
    double factor = 0;  // y over x, of the least-squares line through the origin
    double spread = 0;  // standard deviation of x
    int samples = 0;

    static constexpr int kFewest = 50;          // least number of samples for a conclusion
    static constexpr double kCorrelated = 0.8;  // correlation from which two channels show the same quantity
};
Relation relation(
    const std::vector<double>& x, const std::vector<double>& y,
    const std::function<bool(std::size_t)>& use = [](std::size_t) { return true; });

}  // namespace tread::recording::checks
