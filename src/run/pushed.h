// A push on the body, and what is felt of it on board.
#pragma once

#include <optional>

#include "base/math/turn.h"
#include "run/push.h"
#include "run/sensors.h"

namespace tread {

// The car's own accelerations are those of its tyres, the air and gravity, so what observes it must be told of the
// rest.
class Pushed {
public:
    Pushed(const Pushing& pushing, const Vehicle& vehicle)
        : pushing_(pushing),
          mass_(vehicle.params.mass),
          inertia_(vehicle.params.inertia.roll, vehicle.params.inertia.pitch, vehicle.params.inertia.yaw),
          reference_(vehicle.reference_B) {}

    // Over the coming step, axes of the world; nothing when nothing ever pushes.
    std::optional<Push> over(double time, const VehicleInput& driver, const VehicleOutput& car) {
        if (!pushing_) return std::nullopt;
        now_ = pushing_(time, driver, car);
        level_ = turnAbout(Vector3::UnitZ(), car.chassis.yaw);
        return Push{level_ * now_.force, level_ * now_.moment};
    }

    void felt(ChassisOutput& chassis) const {
        const Vector3 acceleration = accelerationOfReference();
        chassis.ax += acceleration.x();
        chassis.ay += acceleration.y();
        chassis.az += acceleration.z();
    }

    PointMotion felt(PointMotion point) const {
        point.acceleration_W += level_ * accelerationOfReference();
        point.angular_acceleration_W += level_ * angularAcceleration();
        return point;
    }

private:
    // Level axes along the heading.
    Vector3 angularAcceleration() const { return now_.moment.cwiseQuotient(inertia_); }
    Vector3 accelerationOfReference() const { return now_.force / mass_ + angularAcceleration().cross(reference_); }

    const Pushing& pushing_;
    double mass_;        // kg
    Vector3 inertia_;    // kg m2
    Vector3 reference_;  // m, point to which the channels refer, from the centre of gravity
    Push now_;
    Quaternion level_ = Quaternion::Identity();  // axes level along the heading
};

}  // namespace tread
