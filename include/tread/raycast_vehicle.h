// The drop-in for Bullet's btRaycastVehicle: a game keeps its btRaycastVehicle* and changes the class that it makes.
//
//     btRaycastVehicle* vehicle = new tread::RaycastVehicle(tuning, chassis, raycaster);
//     btRaycastVehicle* vehicle = new tread::RaycastVehicle(tuning, chassis, raycaster, "compact.yaml");
//
// What the stock numbers mean here (mass is that of the chassis):
//   stiffness, damping     times mass: N/m and N s/m at the wheel, as in stock; the tyre's own spring is taken off, so
//                          that the car stands as high as in stock
//   max suspension force   N, most of spring and damper; the stop at the end of the travel carries what is beyond
//   friction slip          up to 1 the tyre's peak friction; beyond, it tends to 1.2 (10.5 gives 1.18)
//   roll influence         height of the side force as in stock: 1 at the ground, 0 at the centre of gravity
//   engine force           N at the ground: torque over wheel radius; wheels spin when the tyre cannot hold it
//   brake                  stock takes it as an impulse per step; here it is the force that it gives at 60 steps a
//                          second, brake * 60 N, at every rate, also while the engine pushes
// From a vehicle file come tyres, wheel inertias, springs, dampers and anti-roll bars; mass, geometry, steering angles,
// engine and brake forces stay the game's.
#pragma once

#include <BulletDynamics/Vehicle/btRaycastVehicle.h>

#include <filesystem>
#include <functional>
#include <memory>

#include "tread/api.h"
#include "tread/bullet_precision.h"
#include "tread/vehicle.h"
#include "tread/wheeled_body_state.h"

class btCollisionObject;

namespace tread {

// The precision of btScalar is part of every symbol below: a program built for the other one does not link.
inline namespace TREAD_BULLET_PRECISION {

// What a wheel's ray found, for the game to say what lies there.
struct SurfaceQuery {
    const btCollisionObject* object;
    int part;      // of the shape, -1 where it has none
    int triangle;  // of a mesh or height field, or child of a compound; -1 where there is none
    btVector3 point;
    int wheel;
};
struct Surface {
    double friction = 1;   // scales the tyre's
    double roughness = 0;  // m, amplitude of bumps about 1 m long
    const char* name = "";
};
using SurfaceAt = std::function<Surface(const SurfaceQuery&)>;

// What happens at a wheel, for sound, smoke, skid marks and force feedback.
struct WheelTelemetry {
    double load = 0;
    double fx = 0;
    double fy = 0;
    double slip_ratio = 0;
    double slip_angle = 0;
    double slip_power = 0;
    double spin = 0;
    double compression = 0;
    double deflection = 0;
    double steer_torque = 0;
    double grip = 0;
    double contact_x = 0;
    double contact_y = 0;
    double contact_z = 0;

    static constexpr void describe(auto& self, auto&& field) {
        field(TREAD_FIELD(load), About{"N", "load of the tyre, normal to the ground"});
        field(TREAD_FIELD(fx), About{"N", "force of the ground on the tyre, forward"});
        field(TREAD_FIELD(fy), About{"N", "force of the ground on the tyre, to the left"});
        field(TREAD_FIELD(slip_ratio), About{"-", "longitudinal slip, positive when driving"});
        field(TREAD_FIELD(slip_angle), About{"rad", "slip angle, positive when the wheel slides to the left"});
        field(TREAD_FIELD(slip_power), About{"W", "power lost between tyre and ground, for smoke, squeal and wear"});
        field(TREAD_FIELD(spin), About{"rad/s", "wheel speed, positive forward"});
        field(TREAD_FIELD(compression), About{"m", "suspension compression"});
        field(TREAD_FIELD(deflection), About{"m", "tyre deflection"});
        field(TREAD_FIELD(steer_torque), About{"N m",
                                               "moment of the ground about the strut, positive to the left; summed "
                                               "over the wheels for the steering wheel"});
        field(TREAD_FIELD(grip), About{"N", "largest force that the tyre can hold along the ground"});
        field(TREAD_FIELD(contact_x), About{"m", "contact point in the world"});
        field(TREAD_FIELD(contact_y), About{"m", "contact point in the world"});
        field(TREAD_FIELD(contact_z), About{"m", "contact point in the world"});
    }
};
static_assert(describesEveryMember<WheelTelemetry>());

// Everything that a step depends on, the chassis' motion included: a copy of it is a snapshot.
struct RaycastVehicleState {
    WheeledBodyState car;
    std::array<WheelDemand, kMostWheels> demands;  // at the end of the last step
    std::array<double, 6> velocity{};              // linear and angular, at the instant of the last step
    std::array<double, 6> expected{};              // what the chassis shows if nobody else pushes it
    double planned = 0;                            // s, length of the step for which that was planned
    std::array<double, 12> pose{};                 // of the chassis: basis by rows, origin
    std::array<double, 6> body_velocity{};
    double deactivation_time = 0;
    int activation_state = 0;
    int wheel_count = 0;
    bool asleep = false;
};
static_assert(std::is_trivially_copyable_v<RaycastVehicleState>);

// Bullet's btRaycastVehicle on tread's tyres.
class TREAD_API RaycastVehicle : public btRaycastVehicle {
public:
    // `chassis` must not be null (std::invalid_argument) and must outlive the vehicle's steps; `raycaster` may be null.
    // Bullet's own btDefaultVehicleRaycaster is replaced by a ray that sees neither the chassis nor triggers; any other
    // one is used as it is. Bullet's gyroscopic forces on the chassis are switched off: the vehicle has them.
    RaycastVehicle(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster);
    // The same with tyres and suspension of a vehicle file (LoadError) or of its parameters.
    RaycastVehicle(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster,
                   const std::filesystem::path& vehicle_file);
    RaycastVehicle(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster,
                   const VehicleParams& params);
    RaycastVehicle(const RaycastVehicle&) = delete;
    RaycastVehicle& operator=(const RaycastVehicle&) = delete;
    ~RaycastVehicle() override;

    // Called by Bullet in each step. A world that does not hold the chassis is ignored.
    void updateAction(btCollisionWorld* world, btScalar step) override;
    void updateVehicle(btScalar step) override;  // the same with the raycaster's rays
    void updateFriction(btScalar) override {}    // the tyres have done it

    // ---- Beyond the stock vehicle ----

    // Longest substep, s: 0.001 unless set; between 0.0001 and 0.02. Larger is cheaper and coarser.
    void setSubstep(double longest);

    // Called for each ray that meets something; a default-made function takes it away.
    void setSurface(SurfaceAt surface);

    // Groups and mask of the wheels' own rays; all unless set.
    void setCollisionFilter(int group, int mask);

    // Edges between the triangles of a mesh or height field that are flatter than this are rounded under the wheels'
    // own rays, over a third of the wheel's radius: 0.45 rad unless set, 0 for none.
    void setEdgeAngle(double angle);

    // Tyre of one wheel from now on, in place of what tuning or file say.
    void setTyre(int wheel, const TyreParams& tyre);

    // Velocities at the instant of the last step, m/s and rad/s in the world: Bullet's own hold what gravity will take
    // back in the next one.
    Vector3 velocity() const;
    Vector3 angularVelocity() const;

    WheelTelemetry telemetry(int wheel) const;

    // Where to draw a wheel between two steps: at the chassis as its motion state shows it, with steering angle,
    // suspension length and rotation of the same instant. Bullet's updateWheelTransform(wheel, true) takes only the
    // chassis back to that instant.
    btTransform drawnWheel(int wheel) const;
    const char* surfaceName(int wheel) const;

    // A restored vehicle repeats its steps bit for bit as long as inputs and ground are the same.
    RaycastVehicleState snapshot() const;
    void restore(const RaycastVehicleState& state);

private:
    friend class RaycastFleet;
    bool isHeldBy(const btCollisionWorld& world) const;
    struct TREAD_INTERNAL Implementation;
    std::unique_ptr<Implementation> self_;
};
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
