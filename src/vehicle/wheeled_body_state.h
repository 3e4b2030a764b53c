// What a rigid body on wheels remembers from step to step, and what it is asked to do: the car of a RaycastVehicle.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "tread/describe.h"
#include "tread/tyre.h"

namespace tread {

inline constexpr std::size_t kMostWheels = 12;

// How the drive torque falls as the rim runs ahead of the ground, in the sense of the torque. Nothing, as it is made.
struct DriveLimit {
    double loss = 0;           // N s/m, force at the rim that is lost per slip speed
    double fades = kInfinity;  // m/s, slip speed from which on the torque fades
    double ends = kInfinity;   // m/s, slip speed at which it is gone

    bool operator==(const DriveLimit&) const = default;
};

struct WheelDemand {
    double steer = 0;         // rad about the strut, positive to the left
    double drive_torque = 0;  // N m, positive forward
    double brake_torque = 0;  // N m, that the brake can hold
    double friction = 1;      // scales the tyre's friction, besides the road's
    DriveLimit limit;

    bool operator==(const WheelDemand&) const = default;
};

struct BodyWheelState {
    TyreState tyre;
    TyreMotion motion;                  // of the tyre at the end of the last step, paper axes
    double spin = 0;                    // rad/s, positive forward
    double spin_rate = 0;               // rad/s2
    double rotation = 0;                // rad, turned so far
    double compression = 0;             // m, of the strut
    double deflection = 0;              // m, of the tyre
    double steer = 0;                   // rad
    double load = 0;                    // N, normal to the road
    double fx = 0, fy = 0;              // N, ISO 8855 wheel axes
    double mz = 0;                      // N m
    double strut_force = 0;             // N
    double strut_rate = 0;              // m/s, of the compression
    double camber = 0;                  // rad, against the road
    double slip_power = 0;              // W, lost between contact patch and road
    double steer_torque = 0;            // N m, of the road about the strut, positive turns to the left
    double grip = 0;                    // N, the most that the tyre can hold
    std::array<double, 3> contact_B{};  // m, contact centre
    std::array<double, 3> force_W{};    // N, of the road on the tyre
    bool touches = false;

    bool operator==(const BodyWheelState&) const = default;
};

struct WheeledBodyState {
    std::array<BodyWheelState, kMostWheels> wheels;
    std::array<double, 3> acceleration_W{};
    std::array<double, 3> angular_acceleration_W{};

    bool operator==(const WheeledBodyState&) const = default;
};
static_assert(std::is_trivially_copyable_v<WheeledBodyState>, "a snapshot is a copy");

}  // namespace tread
