// Heights: rolling over, bouncing, landing; and which way is forward.
#include <algorithm>
#include <cmath>

#include "problems.h"
#include "scene.h"
#include "tread/raycast_vehicle_file.h"

namespace problems {
namespace {

using namespace scene;

// Largest lean of a car in a hard turn with the side force at the ground, default friction slip.
template <class Vehicle>
double lean() {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.friction = 10.5, .roll_influence = 1, .speed = 25});
    run(world, 1, 60);
    car.steer(0.25);
    double most = 0;
    for (int i = 0; i < 180; ++i) {
        run(world, 1.0 / 60, 60);
        const double up = car.chassis->getWorldTransform().getBasis()[1][1];
        most = std::max(most, std::acos(std::clamp(up, -1.0, 1.0)));
    }
    return most * 180 / std::acos(-1.0);
}

// Energy of an undamped car that bounces upright off the ground for 20 s at 60 Hz, at the extreme of what it has in the
// air, over that at the start.
template <class Vehicle>
double bounce() {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.damping = 0, .height = 0.9});
    car.chassis->setAngularFactor(0);
    if constexpr (std::is_same_v<Vehicle, tread::RaycastVehicle>) {
        tread::TyreParams tyre = tread::similarTyre(0.25 * 1500 * kGravity, 0.3);
        tyre.parameters.pz2 = 0;
        for (int i = 0; i < 4; ++i) tread::setTyre(*car.vehicle, i, tyre);
    }
    constexpr double kMiddle = 0.6;  // m, of the centre of gravity with the struts just free
    const double start = kGravity * (0.9 - kMiddle);
    double worst = 1;
    for (int i = 0; i < 1200; ++i) {
        run(world, 1.0 / 60, 60);
        // The body's velocity belongs to the middle of the step that led here, half a step of gravity ago.
        const double y = car.place().y();
        if (y < kMiddle + 0.05) continue;
        const double v = static_cast<double>(car.velocity().y()) - 0.5 * kGravity / 60;
        const double energy = (kGravity * (y - kMiddle) + 0.5 * v * v) / start;
        if (std::abs(energy - 1) > std::abs(worst - 1)) worst = energy;
    }
    return 100 * worst;
}

// m above its height of rest that a car with stiff springs comes up to after a fall of 0.5 m, at 60 Hz.
template <class Vehicle>
double rebound() {
    World world;
    world.addPlane();
    constexpr double kStiffness = 120, kSag = kGravity / 4 / kStiffness, kTouches = 0.6;
    Car<Vehicle> car(world, {.stiffness = kStiffness, .damping = 0.35 * 2 * std::sqrt(kStiffness), .height = 1.1});
    double highest = 0, lowest = 1e9;
    for (int i = 0; i < 240; ++i) {
        run(world, 1.0 / 60, 60);
        const double y = car.place().y();
        if (y < kTouches && y <= lowest) lowest = y;
        else if (lowest < kTouches) highest = std::max(highest, y - (kTouches - kSag));
    }
    return highest;
}

// Lowest wheel centre after a fall from 20 m, at 60 Hz.
template <class Vehicle>
double fall() {
    World world;
    world.addPlane();
    Car<Vehicle> car(world, {.height = 20});
    double lowest = 1e9;
    for (int i = 0; i < 240; ++i) {
        run(world, 1.0 / 60, 60);
        for (int k = 0; k < 4; ++k) {
            car.vehicle->updateWheelTransform(k, true);
            const btVector3 centre = car.vehicle->getWheelTransformWS(k).getOrigin();
            lowest = std::min(lowest, static_cast<double>(centre.y()));
        }
    }
    return lowest;
}

// Metres driven forward in 3 s by a car whose forward axis is x, as setCoordinateSystem(2, 1, 0) tells it.
template <class Vehicle>
double forwardAlongX() {
    World world;
    world.addPlane();
    btBoxShape shape(vector(2, 0.25, 0.8));
    btVector3 inertia;
    shape.calculateLocalInertia(1500, inertia);
    btRigidBody chassis(1500, nullptr, &shape, inertia);
    chassis.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(0, 0.54, 0)));
    chassis.setActivationState(DISABLE_DEACTIVATION);
    world.dynamics.addRigidBody(&chassis);
    btRaycastVehicle::btVehicleTuning tuning;
    tuning.m_suspensionStiffness = 40;
    tuning.m_suspensionCompression = tuning.m_suspensionDamping = scalar(4.4);
    btDefaultVehicleRaycaster raycaster(&world.dynamics);
    Vehicle vehicle(tuning, &chassis, &raycaster);
    world.dynamics.addVehicle(&vehicle);
    vehicle.setCoordinateSystem(2, 1, 0);
    for (int i = 0; i < 4; ++i) {
        const btVector3 at = vector(i < 2 ? 1.35 : -1.35, 0, i % 2 == 0 ? -0.75 : 0.75);
        vehicle.addWheel(at, vector(0, -1, 0), vector(0, 0, 1), scalar(0.3), scalar(0.3), tuning, i < 2);
        vehicle.applyEngineForce(1000, i);
    }
    run(world, 3, 60);
    world.dynamics.removeVehicle(&vehicle);
    world.dynamics.removeRigidBody(&chassis);
    return chassis.getCenterOfMassPosition().x();
}

// Turn to the left and to the right on a box of 2 km: largest sum of both yaw rates over the peak.
template <class Vehicle>
double asymmetry() {
    double worst = 0, peak = 0;
    World left_world, right_world;
    left_world.addBox(1000, 0.5, 1000, 0, vector(0, -0.5, 0));
    right_world.addBox(1000, 0.5, 1000, 0, vector(0, -0.5, 0));
    Car<Vehicle> left(left_world, {.speed = 20}), right(right_world, {.speed = 20});
    left.steer(0.05);
    right.steer(-0.05);
    for (int i = 0; i < 120; ++i) {
        run(left_world, 1.0 / 60, 60);
        run(right_world, 1.0 / 60, 60);
        worst = std::max(worst, std::abs(left.yawRate() + right.yawRate()));
        peak = std::max(peak, std::abs(left.yawRate()));
    }
    return worst / peak;
}

}  // namespace

void tipping(Rows& rows) {
    using Stock = btRaycastVehicle;
    using Tread = tread::RaycastVehicle;
    const bool single = sizeof(btScalar) == sizeof(float);
    rows.push_back(
        {"turn at 25 m/s, roll influence 1, friction slip 10.5: lean", lean<Stock>(), lean<Tread>(), "deg", 1, 10});
    // One step a frame meets the ground up to a frame late: some energy is lost, none may be won.
    rows.push_back({"bouncing undamped at 60 Hz: energy in the air, worst in 20 s", bounce<Stock>(), bounce<Tread>(),
                    "%", 97, 100.5});
    rows.push_back({"dropped 0.5 m onto springs of 120 N/m per kg: rebound above rest", 1000 * rebound<Stock>(),
                    1000 * rebound<Tread>(), "mm", 0, 15});
    rows.push_back(
        {"falling from 20 m at 60 Hz: lowest wheel centre above ground", fall<Stock>(), fall<Tread>(), "m", 0, 0.3});
    rows.push_back(
        {"car with x forward: drives in 3 s", forwardAlongX<Stock>(), forwardAlongX<Tread>(), "m", 11, 12.5});
    rows.push_back({"left turn against right turn on a box of 2 km", asymmetry<Stock>(), asymmetry<Tread>(), "-", 0,
                    single ? 1e-5 : 1e-12});
}

}  // namespace problems
