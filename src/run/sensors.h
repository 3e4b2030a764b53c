// The sensors of a run: what each makes of the channel that it observes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/math/random.h"
#include "scenario/sensor.h"
#include "tread/vehicle.h"

namespace tread {

// What is wrong with a list of sensors, given the names of all channels; `path` is relative to one of them.
struct SensorFault {
    std::size_t sensor;
    std::string path;
    std::string text;
};
std::vector<SensorFault> sensorFaults(const std::vector<SensorParams>& sensors,
                                      std::span<const std::string_view> channels);

class Sensor {
public:
    // `step`: s, between two calls of observe().
    Sensor(const SensorParams& params, double step);

    // In every step: the channel's true value, and the motion of the point to which the channels refer.
    void observe(double value, const PointMotion& body);

    // What it shows now; each reading has its own noise.
    double reading();

private:
    double mounted(double value, const PointMotion& body) const;
    double filtered(double value);
    double delayed(double value);

    SensorParams params_;
    bool elsewhere_;          // not at the centre of gravity, or with other axes
    Eigen::Matrix3d turned_;  // its axes in those of its mounting
    Random random_;
    double value_ = 0;  // after the delay

    // Low pass: y = b (x + 2 x1 + x2) - a1 y1 - a2 y2.
    bool filters_;
    bool begun_ = false;
    double b_ = 1, a1_ = 0, a2_ = 0;
    double x1_ = 0, x2_ = 0, y1_ = 0, y2_ = 0;

    // The latest values, in a ring: as many as the delay needs.
    std::vector<double> past_;
    std::size_t newest_ = 0;
    double delay_steps_;
};

}  // namespace tread
