// The demo's car: one chassis, on Bullet's stock vehicle or on tread's, as the driver chooses.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "track.h"

namespace tread::demo {

enum class Kind { stock, tread };
constexpr auto enumNames(Kind) {
    return std::array<std::string_view, 2>{"stock", "tread"};
}

// What a driver does, on keys, on a gamepad or by a script.
struct Pedals {
    double throttle = 0;   // 0 to 1; below 0 backwards
    double brake = 0;      // 0 to 1
    double handbrake = 0;  // 0 to 1, rear wheels
    double steer = 0;      // rad at the front wheels, positive to the left
};

struct WheelPose {
    double steer = 0;
    double length = 0;  // m, of the suspension
    double rotation = 0;
};
struct CarPose {
    btTransform chassis = btTransform::getIdentity();
    std::array<WheelPose, 4> wheels;
};
CarPose between(const CarPose& a, const CarPose& b, double at);

// What happens at a wheel, for arrows and skid marks. Bullet's vehicle does not tell the forces of its tyres.
struct WheelSight {
    bool touches = false;
    btVector3 contact, normal, axle;
    btVector3 slide;  // m/s, of the tyre over the ground
    btVector3 force;  // N, of the ground on the tyre, along the ground
    double load = 0;  // N
    bool has_force = false;
};

class Car {
public:
    static constexpr double kRadius = 0.32, kTrack = 1.62, kWheelbase = 2.66, kMass = 1400;  // m, kg
    static constexpr double kSteerMost = 0.55;                                               // rad

    explicit Car(Track& track);
    ~Car();
    Car(const Car&) = delete;
    Car& operator=(const Car&) = delete;

    // From now on the same chassis rolls on the other vehicle.
    void choose(Kind kind);
    Kind kind() const { return kind_; }
    void put(const btTransform& place);
    void setSpeed(double forward);  // m/s

    // Before each step.
    void drive(const Pedals& pedals);
    // After each step.
    CarPose pose() const;

    double speed() const;  // m/s, forward
    WheelSight look(int wheel) const;
    std::string_view ground(int wheel) const;
    btTransform wheelInChassis(int wheel, const WheelPose& pose) const;
    const btRigidBody& chassis() const { return chassis_; }

private:
    Track& track_;
    btBoxShape box_{scene::vector(0.85, 0.35, 2.1)};
    btCompoundShape shape_;
    btRigidBody chassis_;
    int flags_;  // of the chassis, as Bullet makes them
    btDefaultVehicleRaycaster raycaster_;
    std::unique_ptr<btRaycastVehicle> vehicle_;
    Kind kind_ = Kind::tread;
};

}  // namespace tread::demo
