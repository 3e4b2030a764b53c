// A push on the body, and what is felt of it on board.
#pragma once

#include <btBulletDynamicsCommon.h>

#include "bullet/convert.h"
#include "run/push.h"
#include "run/sensors.h"

namespace tread {

// Bullet moves the body by a push as by any force; the car's own accelerations are those of its tyres, the air and
// gravity, so what observes it must be told of the rest.
class Pushed {
public:
    Pushed(const Pushing& pushing, const VehicleParams& params)
        : pushing_(pushing),
          mass_(params.mass),
          inertia_(params.inertia.roll, params.inertia.pitch, params.inertia.yaw) {}

    void push(btRigidBody& body, double time, const VehicleInput& driver, const VehicleOutput& car) {
        if (!pushing_) return;
        now_ = pushing_(time, driver, car);
        level_ = Eigen::AngleAxisd(car.chassis.yaw, Vector3::UnitZ());
        body.applyCentralForce(toBullet(level_ * now_.force));
        body.applyTorque(toBullet(level_ * now_.moment));
    }

    void felt(ChassisOutput& chassis) const {
        chassis.ax += now_.force.x() / mass_;
        chassis.ay += now_.force.y() / mass_;
        chassis.az += now_.force.z() / mass_;
    }

    BodyMotion felt(BodyMotion body) const {
        body.acceleration_W += level_ * now_.force / mass_;
        body.angular_acceleration_W += level_ * now_.moment.cwiseQuotient(inertia_);
        return body;
    }

private:
    const Pushing& pushing_;
    double mass_;      // kg
    Vector3 inertia_;  // kg m2
    Push now_;
    Eigen::Matrix3d level_ = Eigen::Matrix3d::Identity();
};

}  // namespace tread
