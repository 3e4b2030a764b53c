// The car behind a RaycastVehicle, made from what the game set, and made anew where the game changed it.
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>

#include "bullet/convert.h"
#include "bullet/raycast_parts.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

// The wheel at the other end of an axle: the one of the same end of the car that stands farthest to the other side.
std::size_t partnerOf(const WheeledBody& car, std::size_t wheel, const auto& isFront) {
    std::size_t partner = BodyWheel::kAlone;
    double farthest = 0;
    for (std::size_t j = 0; j < car.wheel_count; ++j) {
        if (j == wheel || isFront(j) != isFront(wheel)) continue;
        const Vector3 across = car.wheels[j].top_B - car.wheels[wheel].top_B;
        const double apart = std::abs(across.dot(car.wheels[wheel].left_B));
        if (apart > farthest) {
            farthest = apart;
            partner = j;
        }
    }
    return partner;
}

}  // namespace

std::size_t RaycastVehicle::Implementation::wheelCount() const {
    return std::min(static_cast<std::size_t>(face.m_wheelInfo.size()), kMostWheels);
}

Vector3 RaycastVehicle::Implementation::gravity() const {
    return fromBullet(chassis.getGravity());
}

WheelDemand RaycastVehicle::Implementation::demand(std::size_t wheel) {
    BodyWheel& own = car.wheels[wheel];
    own.limit = driveLimit(info(wheel), own.partner < car.wheel_count ? &info(own.partner) : nullptr, own, car.gravity);
    return demandOf(info(wheel), own, state.wheels[wheel].spin, car.gravity, file.has_value());
}

void RaycastVehicle::Implementation::takeBody() {
    const btScalar inverse = chassis.getInvMass();
    car.mass = inverse > 0 ? 1 / static_cast<double>(inverse) : 0;
    car.inverse_inertia = fromBullet(chassis.getInvInertiaDiagLocal());
    car.linear_factor_W = fromBullet(chassis.getLinearFactor());
    car.angular_factor_W = fromBullet(chassis.getAngularFactor());
}

void RaycastVehicle::Implementation::makeCar() {
    takeBody();
    const std::size_t count = wheelCount();
    const RestingLoad load = restingLoad(car.mass, count, gravity().norm());
    bool changed = !made || count != car.wheel_count || car.mass != made_for_mass || load.gravity != car.gravity;
    for (std::size_t i = 0; i < count; ++i) {
        const WheelTuning tuning = tuningOf(info(i));
        changed |= !(tuning == tunings[i]);
        tunings[i] = tuning;
    }
    if (!changed) return;
    made = true;
    made_for_mass = car.mass;
    car.gravity = load.gravity;
    car.wheel_count = count;
    for (std::size_t i = 0; i < count; ++i) {
        if (file) {
            const BodyWheel place = wheelFromTuning(info(i), car.mass, load, {});
            car.wheels[i] = wheelFromFile(info(i), *file, place.top_B.dot(place.left_B) > 0, load, own_tyres[i]);
        } else {
            car.wheels[i] = wheelFromTuning(info(i), car.mass, load, own_tyres[i]);
        }
    }
    for (std::size_t i = 0; i < count; ++i)
        car.wheels[i].partner = partnerOf(car, i, [&](std::size_t j) { return info(j).m_bIsFrontWheel; });
    prepareTyres(car);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
