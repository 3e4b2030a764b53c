// Many RaycastVehicles as one action of a world, on one thread or on several.
//
//     tread::RaycastFleet fleet(4);
//     fleet.add(*vehicle);            // in place of world.addVehicle(vehicle)
//     world.addAction(&fleet);
//
// The result is the same, bit for bit, for any number of threads. All vehicles look at the world as it is before any of
// them pushes it, then push in the order in which they were added; as long as none stands on what another one moves,
// each does exactly what it would do alone. An updateVehicle that a class derived from RaycastVehicle overrides is not
// called: such a vehicle is added to the world itself.
#pragma once

#include "tread/api.h"
#include "tread/bullet_precision.h"
#include "tread/raycast_vehicle.h"

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

// The action. Vehicles and world must outlive its steps; a vehicle may belong to one fleet.
class TREAD_API RaycastFleet : public btActionInterface {
public:
    // Threads that compute, the caller's included; at least one. User raycasters and surface functions are called from
    // all of them, one call at a time; the world's broadphase and shapes are asked from all at once.
    explicit RaycastFleet(int threads = 1);
    RaycastFleet(const RaycastFleet&) = delete;
    RaycastFleet& operator=(const RaycastFleet&) = delete;
    ~RaycastFleet() override;

    // A vehicle that is already there is not added again; one that is not there is not removed.
    void add(RaycastVehicle& vehicle);
    void remove(RaycastVehicle& vehicle);
    int size() const;

    // Called by Bullet in each step. What a raycaster or surface function throws is thrown here, after the step.
    void updateAction(btCollisionWorld* world, btScalar step) override;
    void debugDraw(btIDebugDraw* drawer) override;

private:
    struct TREAD_INTERNAL Implementation;
    Implementation* self_;
};
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
