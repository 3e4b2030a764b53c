// A car that moves without a physics engine: alone, or in a lane of the convoy of its thread (convoy.h).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/step_inputs.h"
#include "host/substep.h"
#include "run/push.h"
#include "tread/equilibrium.h"
#include "tread/vehicle.h"
#include "vehicle/fleet/lane_kind.h"

namespace tread {

class Convoy;

class Rider {
public:
    // The road must outlive it. `substep`: the longest, s.
    Rider(Vehicle vehicle, Road& road, const Equilibrium& start, double substep);
    ~Rider();
    Rider(const Rider&) = delete;
    Rider& operator=(const Rider&) = delete;

    VehicleInput next;  // at the end of the next step

    void setWind(const Vector3& velocity_W);
    void move(double dt);

    // What a push over the last dt has changed, axes of the world: the velocity by the acceleration times dt, the pose
    // by that times dt, as Bullet does.
    void push(const Push& push_W, double dt);

    // Somebody changes the motion, and of the state the rates of the wheels and what is no number of a wheel.
    void put(const ChassisMotion& motion, const VehicleState& state);
    // From now on, whatever it was before.
    void hold(const VehicleInput& input) { input_ = next = input; }

    const Vehicle& vehicle() const { return vehicle_; }
    const ChassisMotion& motion() const { return motion_; }
    const VehicleState& state();
    const VehicleState& stateAtGlance() const { return state_; }

private:
    friend class Convoy;

    void moveAlone(const StepInputs& inputs, double dt);

    Vehicle vehicle_;
    Road& road_;
    ChassisMotion motion_;
    VehicleState state_;  // in a lane: what glance() reads, and the rest where `whole_`
    VehicleInput input_;  // at the time of the last step
    Vector3 wind_W_ = Vector3::Zero();
    Substep substep_{0.001, Substep::kLongest};  // as in BulletVehicle

    // In a convoy.
    Convoy* convoy_ = nullptr;  // that has kept a seat for it
    std::size_t seat_ = 0;
    std::size_t place_ = 0;        // its lane, where it is in one
    std::vector<double> numbers_;  // of the vehicle, for lanes
    std::optional<GroundNumbers> plane_{};
    LaneCar lane_{};
    bool in_lane_ = false;                // its motion is computed there
    bool whole_ = true;                   // all of the state is here
    bool moved_ = false, blown_ = false;  // motion or wind are others than in the lane
};

}  // namespace tread
