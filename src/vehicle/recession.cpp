#include "vehicle/recession.h"

#include "vehicle/travel.h"

namespace tread {
namespace {

// Acceleration along x of the place where the wheel hangs on the body, less gravity.
double frameAcceleration(const BodyFrame& body, const Vehicle::Corner& corner) {
    const Vector3& w = body.angular_velocity_B;
    const Vector3 acceleration =
        body.acceleration_B + body.angular_acceleration_B.cross(corner.hub_B) + w.cross(w.cross(corner.hub_B));
    return acceleration.x() - body.gravity_B.x();
}

}  // namespace

void advanceRecession(PerWheel<WheelState>& wheels, const Vehicle& vehicle, const BodyFrame& begin, double dt) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const SuspensionParams& suspension = suspensionOf(vehicle, i);
        if (suspension.longitudinal_compliance == 0) continue;
        const Vehicle::Corner& corner = vehicle.corners[i];
        advance(wheels[i].recession, suspension, corner.unsprung_mass, frameAcceleration(begin, corner), dt);
    }
}

void recede(TyreMotion& motion, const Recession& recession, const WheelContact& contact) {
    motion.Vx += recession.rate * contact.forward_B.x();
    motion.Vsy -= recession.rate * contact.left_B.x();
}

Wrench recessionWrench(PerWheel<WheelState>& wheels, const Vehicle& vehicle, const PerWheel<WheelContact>& contacts,
                       const BodyFrame& end, double dt) {
    Wrench wrench;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const SuspensionParams& suspension = suspensionOf(vehicle, i);
        if (suspension.longitudinal_compliance == 0) continue;
        const Vehicle::Corner& corner = vehicle.corners[i];
        WheelState& wheel = wheels[i];
        const Vector3 road =
            wheel.fx * contacts[i].forward_B + wheel.fy * contacts[i].left_B + wheel.load * contacts[i].normal_B;
        takeForce(wheel.recession, suspension, corner.unsprung_mass, frameAcceleration(end, corner), road.x(), dt);
        wrench.add({-corner.unsprung_mass * wheel.recession.acceleration, 0, 0}, contacts[i].hub_B);
    }
    return wrench;
}

}  // namespace tread
