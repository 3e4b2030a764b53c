// A rigid body on any number of wheels, each on a strut of its own: the car of a game, as btRaycastVehicle describes
// it.
//
// The struts have no mass: spring, damper and stop stand in series with the tyre's radial spring, and the body feels
// what the road does to the tyre. The tyre is the whole Delft Tyre 97 with its contact patch, the wheel spins, locks
// and carries gyroscopic moments. Not here, but in vehicle.h: axle kinematics and compliance, driveline, steering,
// brakes.
//
// Axes are the body's own, whichever they are: only the directions of struts and axles count.
#pragma once

#include <array>
#include <span>

#include "tread/vehicle.h"
#include "tyre/four_tyres.h"
#include "vehicle/wheeled_body_state.h"

namespace tread {

// ---- Parameters ----

struct StrutParams {
    double length = 0.3;
    double stiffness = 25000;
    double bump = 2000;
    double rebound = 2000;
    double most_force = kInfinity;
    double travel = 0.2;
    double anti_roll_bar = 0;
    double tyre_bump = 0;
    double tyre_rebound = 0;
    double stop = kInfinity;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(length), About{"m", "from the connection point to the wheel centre, unloaded", kNonNegative});
        field(TREAD_FIELD(stiffness), About{"N/m", "of the spring", kNonNegative});
        field(TREAD_FIELD(bump), About{"N s/m", "damping in compression", kNonNegative});
        field(TREAD_FIELD(rebound), About{"N s/m", "damping in extension", kNonNegative});
        field(TREAD_FIELD(most_force), About{"N", "most that spring and damper carry together", kNonNegative});
        field(TREAD_FIELD(travel), About{"m", "compression at which the stop begins", kNonNegative});
        field(TREAD_FIELD(anti_roll_bar),
              About{"N/m", "force per difference of compression with the partner", kNonNegative});
        field(TREAD_FIELD(tyre_bump),
              About{"N s/m", "damping of the tyre in compression, besides its own", kNonNegative});
        field(TREAD_FIELD(tyre_rebound),
              About{"N s/m", "damping of the tyre in extension, besides its own", kNonNegative});
        field(TREAD_FIELD(stop), About{"N/m", "most stiffness of the stop at the end of the travel", kNonNegative});
    }
};
static_assert(describesEveryMember<StrutParams>());

struct BodyWheel {
    static constexpr std::size_t kAlone = kMostWheels;

    Vector3 top_B = Vector3::Zero();     // m, from the centre of gravity to the connection point
    Vector3 down_B = -Vector3::UnitZ();  // unit vector along the strut
    Vector3 left_B = Vector3::UnitY();   // unit vector of the spin axis at zero steer: spin forward turns about it
    StrutParams strut;
    TyreParams tyre;
    double inertia = 1;     // kg m2, of the wheel about its axis
    double roll_share = 1;  // where the side force acts: 1 at the contact (as it is), 0 at the height of the body's
                            // centre of gravity (a game's help against tipping)
    double own_speed = 0;   // m/s, the root of gravity times radius, if a game's drive limits need it
    std::size_t partner = kAlone;  // the wheel at the other end of the anti-roll bar
};

// By how much a force of 1 N at every wheel accelerates the body where the wheels are, 1/kg.
struct Yielding {
    double heaving = 0;  // up and down
    double turning = 0;  // in roll or in pitch, whichever is more
};

// What follows from the parameters.
struct WheeledBody {
    double mass = 1;                            // kg, wheels included
    Vector3 inverse_inertia = Vector3::Ones();  // 1/(kg m2), about the body's axes
    Vector3 linear_factor_W = Vector3::Ones();  // share of each component of the accelerations that happens
    Vector3 angular_factor_W = Vector3::Ones();
    double gravity = kStandardGravity;  // m/s2, that the wheels were made for
    // Whether a wheel that is spun up or down turns the body, and a spinning one resists being turned. Without it the
    // body feels the road's forces at the contact alone, as in a game whose wheels are drawn only, and a car in the air
    // keeps its attitude on the throttle. Neither creates energy: the road gives the body fx times the speed of the
    // contact and takes fx times that of the rim from the wheel, and the slip between them is a loss.
    bool wheel_reaction = false;
    std::size_t wheel_count = 0;
    std::array<BodyWheel, kMostWheels> wheels;
    std::array<FourTyres, kMostWheels / kWheels> packs;  // of the wheels' tyres; idle places repeat the first
    std::array<double, kMostWheels> peak_ratio{};        // slip ratio of the greatest force at the nominal load
    std::array<double, kMostWheels> peak_angle{};        // slip angle likewise, rad
    Yielding yielding;
    double bouncing = 0;  // rad/s, fastest at which the body moves on its suspension
    double rocking = 0;   // rad/s, at which it rocks on the carcasses of tyres that stand
};
// Completes `packs` and what follows from the tyres.
void prepareTyres(WheeledBody& body);

// Longest step that follows the body's own motions, s: on its suspension, and while it stands on its carcasses.
double longestStep(const WheeledBody& body, const WheeledBodyState& state);
inline constexpr double kFollowed = 0.7;  // rad within a step; from 1.1 on a car that rocks does not come to rest

// ---- Motion ----

// Where a wheel's strut begins and the wheel's centre, m in the world.
Vector3 strutTop(const ChassisMotion& motion, const BodyWheel& wheel);
Vector3 wheelCentre(const ChassisMotion& motion, const BodyWheel& wheel, double compression);

// Sets a wheel down without slip or spin of its own: rolling freely, with no force stored in tyre or patch.
void setDown(WheeledBodyState& state, const ChassisMotion& motion, const WheeledBody& body, std::size_t wheel,
             const RoadContact& ground);

// Advances the body by dt (at most about 4 ms) over the planes under its wheels; the demands are given at both ends.
void advance(ChassisMotion& motion, WheeledBodyState& state, const WheeledBody& body,
             std::span<const WheelDemand> begin, std::span<const WheelDemand> end, std::span<const RoadContact> ground,
             const Vector3& gravity_W, double dt);

}  // namespace tread
