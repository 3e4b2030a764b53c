// The drop-in for Bullet's btRaycastVehicle: a game keeps its btRaycastVehicle* and changes the class that it makes.
//
//     btRaycastVehicle* vehicle = new tread::RaycastVehicle(tuning, chassis, raycaster);
//
// Needs Bullet and C++17, no exceptions, no run-time type information. Tyres and suspension of a vehicle file:
// raycast_vehicle_file.h.
//
// What the stock numbers mean here (mass is that of the chassis):
//   stiffness, damping     times mass: N/m and N s/m at the wheel, as in stock; the tyre's own spring is taken off, so
//                          that the car stands as high as in stock
//   max suspension force   N, most of spring and damper; the stop at the end of the travel carries what is beyond
//   friction slip          up to 1 the tyre's peak friction; beyond, it tends to 1.2 (10.5 gives 1.18); see setGrip
//   roll influence         height of the side force as in stock: 1 at the ground, 0 at the centre of gravity
//   engine force           N at the ground: torque over wheel radius; wheels spin when the tyre cannot hold it
//   brake                  stock takes it as an impulse per step; here it is the force that it gives at 60 steps a
//                          second, brake * 60 N, at every rate, also while the engine pushes
#pragma once

#include <BulletDynamics/Vehicle/btRaycastVehicle.h>

#include "tread/api.h"
#include "tread/bullet_precision.h"

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
// Says what lies under the wheels. If `at` throws, the vehicle stays as it was and the step throws.
class TREAD_API SurfaceSource {
public:
    SurfaceSource() = default;
    SurfaceSource(const SurfaceSource&) = delete;
    SurfaceSource& operator=(const SurfaceSource&) = delete;
    virtual ~SurfaceSource();
    virtual Surface at(const SurfaceQuery& query) = 0;
};

// What happens at a wheel, for sound, smoke, skid marks and force feedback.
struct WheelTelemetry {
    double load = 0;          // N, of the tyre, normal to the ground
    double fx = 0;            // N, force of the ground on the tyre, forward
    double fy = 0;            // N, to the left
    double slip_ratio = 0;    // longitudinal slip, positive when driving
    double slip_angle = 0;    // rad, positive when the wheel slides to the left
    double slip_power = 0;    // W, lost between tyre and ground: smoke, squeal, wear
    double spin = 0;          // rad/s, positive forward
    double compression = 0;   // m, of the suspension
    double deflection = 0;    // m, of the tyre
    double steer_torque = 0;  // N m, of the ground about the strut, positive to the left; their sum turns the wheel
    double grip = 0;          // N, largest force that the tyre can hold along the ground
    double contact_x = 0;     // m, contact point in the world
    double contact_y = 0;
    double contact_z = 0;
};

// All that a vehicle's next step depends on, its chassis' motion included. A copy is a snapshot of its own.
class TREAD_API RaycastSnapshot {
public:
    RaycastSnapshot(const RaycastSnapshot& other);
    RaycastSnapshot& operator=(const RaycastSnapshot& other);
    ~RaycastSnapshot();
    bool operator==(const RaycastSnapshot& other) const;  // every number alike: peers are in step
    bool operator!=(const RaycastSnapshot& other) const { return !(*this == other); }

    struct TREAD_INTERNAL State;

private:
    friend class RaycastVehicle;
    RaycastSnapshot();
    State* state_;
};

// Bullet's btRaycastVehicle on tread's tyres.
class TREAD_API RaycastVehicle : public ::btRaycastVehicle {
public:
    // In a class derived from this one, `btRaycastVehicle` means this class: what calls
    // btRaycastVehicle::updateVehicle(step) there, as one does on the stock vehicle, reaches tread.
    using btRaycastVehicle = RaycastVehicle;

    // `chassis` must not be null (std::invalid_argument) and must outlive the vehicle's steps; it may be built later,
    // before the first use. `raycaster` may be null. Bullet's own btDefaultVehicleRaycaster is replaced by a ray that
    // sees neither the chassis nor triggers; any other one is used as it is. From the first step on Bullet's gyroscopic
    // forces on the chassis are switched off: the vehicle has them.
    RaycastVehicle(const btVehicleTuning& tuning, btRigidBody* chassis, btVehicleRaycaster* raycaster);
    RaycastVehicle(const RaycastVehicle&) = delete;
    RaycastVehicle& operator=(const RaycastVehicle&) = delete;
    ~RaycastVehicle() override;

    // Called by Bullet in each step. A world that does not hold the chassis is ignored.
    void updateAction(btCollisionWorld* world, btScalar step) override;
    // The step itself, which updateAction calls; by hand, with the raycaster's rays. Called twice within one step of
    // the world, the vehicle's forces act twice, as in stock.
    void updateVehicle(btScalar step) override;

    // ---- Not for overriding: a compiler that points here has found an override that would do nothing ----
    void updateFriction(btScalar step) final;       // friction is the tyres': override updateVehicle, or see setGrip
    virtual btScalar rayCast(btWheelInfo&) final;   // give the constructor a btVehicleRaycaster of your own instead
    virtual void updateSuspension(btScalar) final;  // set stiffness, damping and force of the wheel infos instead

    // ---- Beyond the stock vehicle ----

    // Longest step of the car within one of the world, s: 1/30 unless set; between 0.0001 and 1/30. Shorter is finer
    // and costs more.
    void setSubstep(double longest);

    // Scales the grip of all tyres, for a game that was tuned on the stock vehicle's: 1 unless set, 0 to 10.
    void setGrip(double factor);

    // Whether wheels that the engine spins up or the brake stops turn the chassis against them, as real ones do: seen
    // in the air. Off unless set, as in stock.
    void setWheelReaction(bool on);

    // The vehicle keeps a copy of `surface` and calls `surface(query)` for each ray that meets something; it returns
    // the Surface that lies there.
    template <class Function>
    void setSurface(Function surface) {
        struct Source final : SurfaceSource {
            explicit Source(const Function& f) : function(f) {}
            Surface at(const SurfaceQuery& query) override { return function(query); }
            Function function;
        };
        takeSurface(new Source(surface));
    }
    void clearSurface() { takeSurface(nullptr); }
    void takeSurface(SurfaceSource* source);  // deleted by the vehicle; null: none

    // Groups and mask of the wheels' own rays; unless set those of Bullet's rays, the default group and all.
    void setCollisionFilter(int group, int mask);

    // Edges between the triangles of a mesh or height field that are flatter than this are rounded under the wheels'
    // own rays, over a third of the wheel's radius: 0.45 rad unless set, 0 for none.
    void setEdgeAngle(double angle);

    // Velocities at the instant of the last step, m/s and rad/s in the world: Bullet's own hold what gravity will take
    // back in the next one. Zero before the first step.
    btVector3 velocity() const;
    btVector3 angularVelocity() const;

    WheelTelemetry telemetry(int wheel) const;

    // Where to draw a wheel between two steps: at the chassis as its motion state shows it, with steering angle,
    // suspension length and rotation of the same instant. Bullet's updateWheelTransform(wheel, true) takes only the
    // chassis back to that instant.
    btTransform drawnWheel(int wheel) const;
    const char* surfaceName(int wheel) const;

    // A restored vehicle repeats its steps bit for bit as long as inputs and ground are the same.
    RaycastSnapshot snapshot() const;
    void snapshot(RaycastSnapshot& into) const;  // the same without allocating
    void restore(const RaycastSnapshot& snapshot);

private:
    struct TREAD_INTERNAL Implementation;
    friend class RaycastFleet;
    friend Implementation& implementationOf(RaycastVehicle& vehicle);
    Implementation* self_;
};
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
