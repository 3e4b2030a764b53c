// The whole car: parameters, state, and one step in time.
//
// Chassis motion belongs to whoever moves the body (Bullet): it enters a step and leaves it advanced. A step is a pure
// function of parameters, state and input; it allocates nothing and throws nothing.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include "tread/aero.h"
#include "tread/api.h"
#include "tread/brakes.h"
#include "tread/driveline.h"
#include "tread/road.h"
#include "tread/state_parts.h"
#include "tread/steering.h"
#include "tread/suspension.h"
#include "tread/tyre.h"
#include "tread/tyre_surroundings.h"
#include "tread/vehicle_output.h"
#include "tread/wheels.h"

namespace tread {

// ---- Parameters ----

template <class T>
struct BasicInertiaParams {
    T roll = kRequired;
    T pitch = kRequired;
    T yaw = kRequired;
    T roll_yaw = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(roll),
              About{"kg m2", "moment of inertia about the longitudinal axis", kPositive, 0.05}.usually(0.0002, 1e5));
        field(TREAD_FIELD(pitch),
              About{"kg m2", "moment of inertia about the lateral axis", kPositive, 0.05}.usually(0.0005, 1e6));
        field(TREAD_FIELD(yaw),
              About{"kg m2", "moment of inertia about the vertical axis", kPositive, 0.03}.usually(0.0005, 1e6));
        field(TREAD_FIELD(roll_yaw), About{"kg m2", "product of inertia, integral of x z dm"}.usually(-2e4, 2e4));
    }
};
using InertiaParams = BasicInertiaParams<double>;
static_assert(describesEveryMember<InertiaParams>());

// A mass fixed to the car in addition to it: luggage, a passenger, more fuel or less. Its place is given, or a moment,
// or both: a fit can move the centre of gravity by a moment before it knows the mass, which it cannot by a place.
struct LoadParams {
    double mass = 0;
    double x = 0, y = 0, z = 0;
    double moment_x = 0, moment_y = 0, moment_z = 0;
    bool levelled = false;

    bool none() const { return mass == 0 && moment_x == 0 && moment_y == 0 && moment_z == 0; }

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(mass), About{"kg", "mass of the load; negative: taken out of the car"}.usually(-2000, 30000));
        field(TREAD_FIELD(x),
              About{"m", "place of the load forward of the centre of gravity of the car without it"}.usually(-10, 10));
        field(TREAD_FIELD(y), About{"m", "place of the load left of this centre of gravity"}.usually(-1.5, 1.5));
        field(TREAD_FIELD(z), About{"m", "place of the load above this centre of gravity"}.usually(-3, 3));
        field(TREAD_FIELD(moment_x),
              About{"kg m", "forward moment of mass, in addition to mass times x"}.usually(-1e5, 1e5));
        field(TREAD_FIELD(moment_y),
              About{"kg m", "moment of mass to the left, in addition to mass times y"}.usually(-3e4, 3e4));
        field(TREAD_FIELD(moment_z),
              About{"kg m", "upward moment of mass, in addition to mass times z"}.usually(-5e4, 5e4));
        field(TREAD_FIELD(levelled),
              About{"", "the suspension levels the car: it keeps its height, while springs alone sink under the load"});
    }
};
static_assert(describesEveryMember<LoadParams>());

// What one wheel has that its axle has not.
struct WheelParams {
    std::optional<TyreParams> tyre{};
    std::optional<TyreSurroundingsParams> tyre_surroundings{};
    double cornering_stiffness = 1;
    double slip_stiffness = 1;
    double grip = 1;
    double brake_drag = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(tyre), About{"", "tyre of this wheel alone, or the file that describes it"});
        field(TREAD_FIELD(tyre_surroundings), About{"", "conditions of the tyre of this wheel alone"});
        field(TREAD_FIELD(cornering_stiffness),
              About{"-", "factor on the cornering stiffness of the tyre of this wheel", kPositive}.usually(0.1, 5));
        field(TREAD_FIELD(slip_stiffness),
              About{"-", "factor on the longitudinal slip stiffness of the tyre of this wheel", kPositive}.usually(0.1,
                                                                                                                   5));
        field(TREAD_FIELD(grip),
              About{"-", "factor on the friction of the tyre of this wheel", kPositive}.usually(0.02, 3));
        field(
            TREAD_FIELD(brake_drag),
            About{"N m", "torque of the brake of this wheel with the pedal released (it drags)", kNonNegative}.usually(
                0, 2000));
    }
};
static_assert(describesEveryMember<WheelParams>());

struct AxleParams {
    double track = kRequired;
    double unsprung_mass = kRequired;
    double wheel_inertia = kRequired;
    SuspensionParams suspension;
    TyreParams tyre;
    TyreSurroundingsParams tyre_surroundings;
    WheelParams left;
    WheelParams right;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(track),
              About{"m", "distance between the contact points of both wheels", kPositive, 0.01}.usually(0.04, 3));
        field(TREAD_FIELD(unsprung_mass),
              About{"kg", "mass that moves with one wheel", kPositive, 0.1}.usually(0.005, 1000));
        field(
            TREAD_FIELD(wheel_inertia),
            About{"kg m2", "moment of inertia of one wheel with tyre and disc about its axis", kPositive, 0.1}.usually(
                1e-6, 60));
        field(TREAD_FIELD(suspension), About{"", "suspension"});
        field(TREAD_FIELD(tyre), About{"", "tyre, or the file that describes it"});
        field(TREAD_FIELD(tyre_surroundings),
              About{"", "conditions of the tyres: pressure, temperature, ply-steer, conicity"});
        field(TREAD_FIELD(left), About{"", "differences of the left wheel"});
        field(TREAD_FIELD(right), About{"", "differences of the right wheel"});
    }
};
static_assert(describesEveryMember<AxleParams>());

struct VehicleParams;

// The car with its load as part of it: mass, centre of gravity and moments of inertia are those of both, and `load` is
// neutral.
TREAD_API VehicleParams loaded(const VehicleParams& params);

struct VehicleParams {
    std::string name;
    double mass = kRequired;
    InertiaParams inertia;
    double wheelbase = kRequired;
    double front_axle_distance = kRequired;
    double lateral_offset = 0;
    double centre_of_gravity_height = kRequired;
    LoadParams load;
    AxleParams front;
    AxleParams rear;
    SteeringParams steering;
    DrivelineParams driveline;
    BrakeParams brakes;
    AeroParams aero;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(name), About{"", "name of the car"});
        field(TREAD_FIELD(mass),
              About{"kg", "mass of the whole car with its load", kPositive, 0.02}.usually(0.5, 50000));
        field(TREAD_FIELD(inertia), About{"", "moments of inertia of the whole car about its centre of gravity"});
        field(TREAD_FIELD(wheelbase), About{"m", "distance between the axles", kPositive, 0.005}.usually(0.1, 10));
        field(
            TREAD_FIELD(front_axle_distance),
            About{"m", "distance from the front axle back to the centre of gravity", kPositive, 0.02}.usually(0.03, 8));
        field(TREAD_FIELD(lateral_offset),
              About{"m",
                    "distance of the centre of gravity left of the middle of the tracks (uneven load); the car stands "
                    "level on it",
                    {-0.3, 0.3}});
        field(TREAD_FIELD(centre_of_gravity_height), About{.unit = "m",
                                                           .meaning = "height of the centre of gravity above the road",
                                                           .limits = kPositive,
                                                           .tolerance = 0.05,
                                                           .old_name = "height"}
                                                         .usually(0.02, 3));
        field(TREAD_FIELD(load),
              About{"",
                    "load in addition to the numbers above; ride height and the point to which the chassis channels "
                    "refer remain those of the car without it"});
        field(TREAD_FIELD(front), About{"", "front axle"});
        field(TREAD_FIELD(rear), About{"", "rear axle"});
        field(TREAD_FIELD(steering), About{"", "steering"});
        field(TREAD_FIELD(driveline), About{"", "driveline"});
        field(TREAD_FIELD(brakes), About{"", "brakes"});
        field(TREAD_FIELD(aero), About{"", "aerodynamics"});
    }

    static void check(const auto& self, auto&& complain) {
        const double loaded_distance = loaded(self).front_axle_distance;
        if (self.front_axle_distance >= self.wheelbase) {
            complain("front_axle_distance",
                     "the centre of gravity must lie between the axles (front_axle_distance < wheelbase)");
        } else if (self.load.mass <= -0.5 * self.mass) {
            complain("load.mass", "found a load that takes away half of the car's mass or more, expected less");
        } else if (loaded_distance <= 0 || loaded_distance >= self.wheelbase) {
            complain("load", "found a load that moves the centre of gravity beyond an axle, expected it between them");
        }
        if (2 * (self.front.unsprung_mass + self.rear.unsprung_mass) >= 0.5 * self.mass) {
            complain("mass", "the unsprung masses of four wheels must be less than half the car's mass");
        }
    }
};
static_assert(describesEveryMember<VehicleParams>());

// Tyres of four wheels in the form in which they are computed together.
struct FourTyres;

// What follows from the parameters and never changes during a run.
struct Vehicle {
    struct Corner {
        Vector3 hub_B;         // m, wheel centre at static load
        double static_force;   // N, in the spring at static load
        double lateral_slope;  // -, lateral movement of the contact point over compression (roll centre)
        double unsprung_mass;  // kg
        double wheel_inertia;  // kg m2
        double brake_drag;     // N m
        TyreParams tyre;       // as mounted on this side, at its pressure
        TyreShift tyre_shift;  // ply-steer and conicity
        TyreTemperatureParams temperature;
        double aligning_stiffness;  // N m/rad, of the tyre about the steering axis, at static load
    };

    VehicleParams params;  // with the load as part of the car
    Vector3 reference_B =
        Vector3::Zero();  // m, point to which the chassis channels refer: centre of gravity without load
    PerWheel<Corner> corners;
    std::shared_ptr<const FourTyres> tyres;  // of the corners; copies of the car share them
    bool recedes = false;                    // some wheel moves along x
    bool tyres_shifted = false;              // some tyre has ply-steer or conicity
    bool tyres_warm = false;                 // some tyre's temperature may differ from the nominal one
    bool warmth_felt = false;                // and that changes its forces
    Eigen::Matrix<double, 6, 6>
        inverse_mass;  // body axes: forces and moments to accelerations, unsprung masses free to move along z
};
TREAD_API Vehicle prepare(const VehicleParams& params, double gravity = kStandardGravity);

// ---- State and motion ----

template <class T>
struct BasicWheelState {
    BasicTyreState<T> tyre;
    BasicTyreMotion<T> motion;  // of the tyre at the end of the last step, paper axes
    T spin = 0;                 // rad/s, positive forward
    T spin_rate = 0;            // rad/s2, over the last step
    T travel = 0;               // m, compression
    T rate = 0;                 // m/s
    T radius = 0;               // m, wheel centre to road
    T steer = 0;                // rad, of the wheel against the body, toe included
    // Forces of the road on the tyre at the end of the last step, ISO 8855 wheel axes.
    T load = 0, fx = 0, fy = 0, mz = 0;
    T fx_rate = 0;           // N/s, over the last step
    T fy_rate = 0;           // N/s
    T vertical_force = 0;    // N, of the load along the body's z axis
    T suspension_force = 0;  // N, of spring, damper, bar and stops, up on the body
    T link_force = 0;        // N, of the links, up on the wheel
    T tangent_force = 0;     // N, of fx and fy along the body's z axis: not zero when the body leans or pitches
    T drive_torque = 0;      // N m, of the driveline
    T brake_torque = 0;      // N m, that the brake can hold
    BasicRecession<T> recession;
    BasicAligningCompliance<T> moment_steer;
    T warming = 0;  // K, temperature of the tyre less that at the start
};
using WheelState = BasicWheelState<double>;

struct VehicleState {
    PerWheel<WheelState> wheels;
    SteeringState steering;
    DrivelineState driveline;
    BrakeState brakes;
    std::array<double, 3> acceleration_W{};          // m/s2, of the centre of gravity at the end of the last step
    std::array<double, 3> angular_acceleration_W{};  // rad/s2
    double engine_torque = 0;                        // N m
    double motor_torque = 0;                         // N m
};
static_assert(std::is_trivially_copyable_v<VehicleState>, "a snapshot is a copy");

// Motion of the body: position of the centre of gravity and attitude of the ISO 8855 vehicle axes in the world.
struct ChassisMotion {
    Vector3 position_W = Vector3::Zero();
    Quaternion orientation = Quaternion::Identity();
    Vector3 velocity_W = Vector3::Zero();
    Vector3 angular_velocity_W = Vector3::Zero();
};

// Motion of a point of the body, with its acceleration and that of the body's rotation, in the world.
struct PointMotion {
    ChassisMotion motion;
    Vector3 acceleration_W;
    Vector3 angular_acceleration_W;
};

// What surrounds the car during a step.
struct Surroundings {
    const Road& road;
    Vector3 gravity_W{0, 0, -kStandardGravity};
    Vector3 wind_W{0, 0, 0};  // m/s, velocity of the air
};

// Advances car and body by dt (at most about 2 ms); the driver's input is given at both ends of the step.
TREAD_API void advance(ChassisMotion& motion, VehicleState& state, const Vehicle& vehicle, const VehicleInput& begin,
                       const VehicleInput& end, const Surroundings& surroundings, double dt);

// Motion of the point to which the chassis channels refer.
TREAD_API PointMotion referenceMotion(const ChassisMotion& motion, const VehicleState& state, const Vehicle& vehicle);

// What an observer on board reads.
TREAD_API VehicleOutput observe(const ChassisMotion& motion, const VehicleState& state, const Vehicle& vehicle,
                                const Vector3& gravity_W);

// The part of it that is read in every step: the chassis, and what turns.
TREAD_API void glance(VehicleOutput& output, const ChassisMotion& motion, const VehicleState& state,
                      const Vehicle& vehicle, const Vector3& gravity_W);

}  // namespace tread
