// Hands of a driver who watches the car: holds a curvature, or follows a path.
#pragma once

#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "scenario/path.h"
#include "scenario/signals.h"
#include "tread/curve.h"
#include "tread/vehicle_output.h"

namespace tread {

// What the driver knows of the car: how it turns when nothing slips.
struct KnownSteering {
    double wheelbase = 2.6;  // m
    double ratio = 16;       // steering wheel over road wheel
    Curve ratio_curve = {};  // that over the steering-wheel angle to either side, in place of the one number

    double ratioAt(double steering_wheel) const {
        return ratio_curve.empty() ? ratio : ratio_curve(std::abs(steering_wheel));
    }
};

class SteerControl {
public:
    SteerControl(const KnownSteering& car, Path path) : car_(car), path_(std::move(path)) {}

    // A phase begins, with the steering wheel at this angle.
    // `way`: m along the path, where that is known.
    void begin(double angle, std::optional<double> way = {});

    // The car at the end of a step of dt.
    void look(const SteeringSignal& signal, const ChassisOutput& car, double time, double dt);

    double angle() const { return angle_; }  // rad

private:
    void correct(double missing_curvature, double bandwidth, double dt);
    void follow(const FollowPath& driver, const ChassisOutput& car, double time, double dt);
    double pathAngle(const FollowPath& driver, const ChassisOutput& car);

    KnownSteering car_;
    Path path_;
    double angle_ = 0;                                // rad, of the steering wheel
    std::optional<double> way_;                       // m along the path; nothing: not yet looked for
    std::deque<std::pair<double, double>> intended_;  // s, rad: what the hands have yet to do
};

}  // namespace tread
