// What the standards ask of a manoeuvre, as numbers with definitions, from a log alone: simulated or measured.
#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "log/log.h"
#include "metrics/metric.h"
#include "scenario/course.h"
#include "tread/curve.h"

namespace tread {

// The log lacks a channel, or does not contain the manoeuvre: says what was looked for and what was there.
class MetricError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The same as a manoeuvre throws it: why, without the manoeuvre's name.
class NotInLog : public MetricError {
public:
    using MetricError::MetricError;
};

// What is known of car and course besides the log; NaN: unknown, and metrics that need it are NaN.
struct KnownCar {
    double wheelbase = std::numeric_limits<double>::quiet_NaN();       // m
    double steering_ratio = std::numeric_limits<double>::quiet_NaN();  // steering wheel over road wheel
    CourseParams course = {};                                          // that was driven; no sections: unknown
    Curve ratio_curve = {};  // that ratio over the steering-wheel angle to either side, in place of the one number

    // Mean road-wheel angle at a steering-wheel angle, rad.
    double roadWheelAngle(double steering_wheel) const {
        return steering_wheel / (ratio_curve.empty() ? steering_ratio : ratio_curve(std::abs(steering_wheel)));
    }
    bool knowsRatio() const { return !ratio_curve.empty() || !std::isnan(steering_ratio); }
};

struct Manoeuvre {
    std::string_view name;
    std::string_view description;
    std::vector<MetricDefinition> (*definitions)();
    // Throws NotInLog.
    std::vector<Metric> (*metrics)(const Log&, const KnownCar&);
};

// The known manoeuvres, in the order in which they are looked for.
const std::vector<Manoeuvre>& manoeuvres();

std::vector<Metric> metrics(const Log& log, std::string_view manoeuvre, const KnownCar& car = {});

// Name of the first known manoeuvre that the log contains; MetricError with what was looked for when it contains none.
std::string detectManoeuvre(const Log& log);

std::string text(std::string_view manoeuvre, const std::vector<Metric>& metrics);
nlohmann::json json(const std::vector<Metric>& metrics);

}  // namespace tread
