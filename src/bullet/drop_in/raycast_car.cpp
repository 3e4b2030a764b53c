// The car behind a RaycastVehicle, made from what the game set, and made anew where the game changed it.
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bullet/convert.h"
#include "bullet/drop_in/raycast_parts.h"

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
    const BodyWheel& own = car->wheels[wheel];
    const btWheelInfo* partner = own.partner < car->wheel_count ? &info(own.partner) : nullptr;
    WheelDemand demand = demandOf(info(wheel), own, state.wheels[wheel].spin, file.has_value());
    demand.limit = driveLimit(info(wheel), partner, own);
    demand.friction *= grip;
    return demand;
}

// Before the first step.
const MadeCar& RaycastVehicle::Implementation::noCar() {
    static const MadeCar none = std::make_shared<const WheeledBody>();
    return none;
}

// What the chassis says now.
CarRecipe::Body RaycastVehicle::Implementation::bodyNow() const {
    const btScalar inverse = chassis.getInvMass();
    const double mass = inverse > 0 ? 1 / static_cast<double>(inverse) : 0;
    const Vector3 inertia = fromBullet(chassis.getInvInertiaDiagLocal());
    const Vector3 linear = fromBullet(chassis.getLinearFactor()), angular = fromBullet(chassis.getAngularFactor());
    const double strength = restingLoad(mass, wheelCount(), gravity().norm()).gravity;
    return {mass,       inertia.x(), inertia.y(), inertia.z(), linear.x(), linear.y(),
            linear.z(), angular.x(), angular.y(), angular.z(), strength,   wheel_reaction ? 1.0 : 0.0};
}

// Whether chassis and wheel infos are as they were when the car was made.
bool RaycastVehicle::Implementation::isAsMade() {
    if (!made || wheelCount() != recipe.wheel_count) return false;
    const CarRecipe::Body body = bodyNow();
    if (std::memcmp(body.data(), recipe.body.data(), sizeof body) != 0) return false;
    for (std::size_t i = 0; i < recipe.wheel_count; ++i)
        if (!(tuningOf(info(i)) == recipe.wheels[i])) return false;
    return true;
}

WheeledBody RaycastVehicle::Implementation::carOf(const CarRecipe& from) {
    WheeledBody body;
    const auto& [mass, ix, iy, iz, lx, ly, lz, ax, ay, az, strength, reaction] = from.body;
    body.mass = mass;
    body.inverse_inertia = {ix, iy, iz};
    body.linear_factor_W = {lx, ly, lz};
    body.angular_factor_W = {ax, ay, az};
    body.gravity = strength;
    body.wheel_reaction = reaction != 0;
    body.wheel_count = from.wheel_count;
    const RestingLoad load = restingLoad(mass, from.wheel_count, strength);
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        if (file) {
            const BodyWheel place = wheelFromTuning(info(i), mass, load, {});
            body.wheels[i] = wheelFromFile(info(i), *file, place.top_B.dot(place.left_B) > 0, load, own_tyres[i]);
        } else {
            body.wheels[i] = wheelFromTuning(info(i), mass, load, own_tyres[i]);
        }
        body.wheels[i].own_speed = std::sqrt(strength * body.wheels[i].tyre.parameters.Ro);
    }
    for (std::size_t i = 0; i < body.wheel_count; ++i)
        body.wheels[i].partner = partnerOf(body, i, [&](std::size_t j) { return info(j).m_bIsFrontWheel; });
    prepareTyres(body);
    return body;
}

void RaycastVehicle::Implementation::makeCar() {
    if (isAsMade()) return;
    made = false;
    recipe.body = bodyNow();
    recipe.wheel_count = wheelCount();
    for (std::size_t i = 0; i < recipe.wheel_count; ++i) recipe.wheels[i] = tuningOf(info(i));
    const bool alone =
        file || std::any_of(own_tyres.begin(), own_tyres.end(), [](auto& own) { return own.has_value(); });
    const auto make = [&] { return carOf(recipe); };
    car = alone ? std::make_shared<const WheeledBody>(make()) : sharedCar(recipe, make);
    made = true;
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
