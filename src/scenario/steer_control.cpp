#include "scenario/steer_control.h"

#include <algorithm>

#include "base/math/elementary.h"

namespace tread {
namespace {

constexpr double kSlowest = 1;    // m/s: below, the hands stay still
constexpr double kLargest = 15;   // rad of the steering wheel: more than any car's lock
constexpr double kReach = 20;     // m of path searched for the nearest point: a car moves less in a step
constexpr double kAtOnce = 1e-9;  // s

}  // namespace

void SteerControl::begin(double angle, std::optional<double> way) {
    angle_ = angle;
    way_ = way;
    intended_.clear();
}

void SteerControl::look(const SteeringSignal& signal, const ChassisOutput& car, double time, double dt) {
    const double v = hypotenuse(car.vx, car.vy);
    if (v < kSlowest) return;
    if (const auto* hold = std::get_if<HoldLateralAcceleration>(&signal)) {
        correct((hold->target - car.ay) / (v * v), hold->bandwidth, dt);
    } else if (const auto* circle = std::get_if<HoldRadius>(&signal)) {
        correct(1 / circle->radius - car.yaw_rate / v, circle->bandwidth, dt);
    } else if (const auto* driver = std::get_if<FollowPath>(&signal)) {
        follow(*driver, car, time, dt);
    }
}

void SteerControl::correct(double missing_curvature, double bandwidth, double dt) {
    angle_ += dt * bandwidth * car_.ratioAt(angle_) * car_.wheelbase * missing_curvature;
    angle_ = std::clamp(angle_, -kLargest, kLargest);
}

// The angle for the arc from here, along the direction of travel, to the point ahead on the path.
double SteerControl::pathAngle(const FollowPath& driver, const ChassisOutput& car) {
    const double v = hypotenuse(car.vx, car.vy);
    const Point here{car.x, car.y};
    way_ = way_ ? path_.nearest(here, *way_, kReach) : path_.nearest(here);
    const Point target = path_.at(*way_ + std::max(driver.preview_time * v, driver.preview_distance));
    const double dx = target.x - here.x, dy = target.y - here.y;
    const double course = car.yaw + arctan2(car.vy, car.vx);
    const double aside = dy * cosine(course) - dx * sine(course);
    const double curvature = 2 * aside / (dx * dx + dy * dy);
    const double asked = curvature + driver.lead * (curvature - car.yaw_rate / v);
    return driver.gain * car_.ratioAt(angle_) * (car_.wheelbase + driver.understeer * v * v) * asked;
}

void SteerControl::follow(const FollowPath& driver, const ChassisOutput& car, double time, double dt) {
    if (path_.empty()) return;
    intended_.emplace_back(time, pathAngle(driver, car));
    // The hands do now what the eyes asked for a dead time ago.
    if (intended_.front().first > time - driver.delay + kAtOnce) return;
    while (intended_.size() > 1 && intended_[1].first <= time - driver.delay + kAtOnce) intended_.pop_front();
    const double missing = intended_.front().second - angle_;
    const double move = driver.lag > 0 ? missing * -exponentialLess1(-dt / driver.lag) : missing;
    angle_ += std::clamp(move, -driver.largest_rate * dt, driver.largest_rate * dt);
}

}  // namespace tread
