// Who moves the car of a run. A car that nothing pushes has, bit for bit, the same motion with each.
#pragma once

#include <memory>
#include <optional>

#include "run/push.h"
#include "tread/equilibrium.h"
#include "tread/road.h"
#include "tread/vehicle.h"
#include "vehicle/settling.h"

namespace tread {

enum class MovedBy {
    bullet,  // the plugin moves a body in a Bullet world
    itself   // `advance` of vehicle.h; several cars at once where a thread drives them together (together.h)
};

class Mover {
public:
    virtual ~Mover() = default;

    // Driver's input at the end of the next step, within which it moves linearly from the last one; velocity of the
    // air over that step, m/s.
    virtual void setInput(const VehicleInput& input) = 0;
    virtual void setWind(const Vector3& velocity_W) = 0;

    // By dt, and by what else pushes the body; axes of the world.
    virtual void move(double dt, const std::optional<Push>& push_W) = 0;

    virtual const Vehicle& vehicle() const = 0;
    virtual const ChassisMotion& motion() const = 0;
    virtual const VehicleState& state() = 0;
    // The state as far as glance() and referenceMotion() of vehicle.h read it.
    virtual const VehicleState& stateAtGlance() = 0;
};

// settle() of vehicle/settling.h; a car that will move by itself also settles beside others.
Settled settledBy(MovedBy by, const Vehicle& vehicle, Road& road, const Vector3& wind_W, const Start& start,
                  const Settled* from);

// A car in equilibrium on a road, which must outlive it. `substep`: its longest, s.
std::unique_ptr<Mover> mover(MovedBy by, const VehicleParams& params, Road& road, const Equilibrium& start,
                             double substep);

// Acceleration by gravity in which all runs take place, m/s2.
inline const Vector3 kGravityOfRuns_W{0, 0, -kStandardGravity};

}  // namespace tread
