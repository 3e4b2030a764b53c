#include "host/body.h"

#include "host/mean_velocity.h"
#include "vehicle/vectors.h"

namespace tread::host {
namespace {

// The angular momentum, or its change.
Vector3 momentum(const Eigen::Matrix3d& inertia_B, const Quaternion& orientation, const Vector3& angular_velocity_W) {
    const Eigen::Matrix3d axes = orientation.toRotationMatrix();
    return times(axes, times(inertia_B, transposedTimes(axes, angular_velocity_W)));
}

}  // namespace

BodyProperties bodyProperties(const Vehicle& vehicle) {
    const InertiaParams& i = vehicle.params.inertia;
    BodyProperties body{vehicle.params.mass, Eigen::Matrix3d::Zero(), vehicle.reference_B};
    body.inertia_B.diagonal() << i.roll, i.pitch, i.yaw;
    body.inertia_B(0, 2) = body.inertia_B(2, 0) = -i.roll_yaw;
    return body;
}

ChassisMotion taken(const ChassisMotion& body, const ChassisMotion& last, const BodyLink& link) {
    ChassisMotion motion = body;
    motion.velocity_W = last.velocity_W + (body.velocity_W - link.velocity_W);
    motion.angular_velocity_W = last.angular_velocity_W + (body.angular_velocity_W - link.angular_velocity_W);
    return motion;
}

BodyForce forceBetween(const ChassisMotion& from, const ChassisMotion& to, const ChassisMotion& shown,
                       const BodyProperties& body, Integration integration, const Vector3& gravity_W, double dt,
                       BodyLink& link) {
    BodyForce out;
    if (integration == Integration::exact) {
        link = {to.velocity_W, to.angular_velocity_W};
        out.moment_W = (momentum(body.inertia_B, to.orientation, to.angular_velocity_W) -
                        momentum(body.inertia_B, from.orientation, from.angular_velocity_W)) /
                       dt;
    } else {
        link.velocity_W = (to.position_W - from.position_W) / dt;
        link.angular_velocity_W = meanAngularVelocity(from.orientation, to.orientation, dt);
        const Vector3 change = link.angular_velocity_W - shown.angular_velocity_W;
        out.moment_W = momentum(body.inertia_B, from.orientation, change) / dt;
    }
    out.acceleration_W = (link.velocity_W - shown.velocity_W) / dt;
    out.angular_acceleration_W = (link.angular_velocity_W - shown.angular_velocity_W) / dt;
    out.force_W = body.mass * (out.acceleration_W - gravity_W);
    return out;
}

}  // namespace tread::host
