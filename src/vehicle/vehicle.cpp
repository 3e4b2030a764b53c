// The wiring of the car: the one place where sub-models meet.
//
// A step is velocity Verlet for the body with an implicit step of every wheel inside it: the body moves with the
// accelerations of the last step, the wheels are advanced between both ends of that motion, and their forces at the end
// correct its velocity. Second order; undamped bounce keeps its energy; at rest nothing is biased, so a parked car
// stays.

#include "tread/vehicle.h"

#include "vehicle/body.h"
#include "vehicle/recession.h"
#include "vehicle/travel.h"
#include "vehicle/tyre_conditions.h"
#include "vehicle/wheel.h"

namespace tread {
namespace {

SteeringMotion steer(VehicleState& state, const Vehicle& vehicle, const VehicleInput& begin, const VehicleInput& end,
                     double dt) {
    const VehicleParams& params = vehicle.params;
    const WheelState &left = state.wheels.front_left, &right = state.wheels.front_right;
    const SteeringInput input{
        .begin = begin.steering_wheel_angle,
        .end = end.steering_wheel_angle,
        .hands_off = end.hands_off > 0.5,
        .track = params.front.track,
        .wheelbase = params.wheelbase,
        .left_moment = steeringMoment(params.steering, left.fx, left.fy, left.mz, true),
        .right_moment = steeringMoment(params.steering, right.fx, right.fy, right.mz, false),
        .aligning_stiffness = vehicle.corners[0].aligning_stiffness + vehicle.corners[1].aligning_stiffness};
    return advance(state.steering, params.steering, input, dt);
}

double middle(double begin, double end) {
    return 0.5 * (begin + end);
}

PerWheel<double> spins(const PerWheel<WheelState>& wheels) {
    return {wheels[0].spin, wheels[1].spin, wheels[2].spin, wheels[3].spin};
}

}  // namespace

void advance(ChassisMotion& motion, VehicleState& state, const Vehicle& vehicle, const VehicleInput& begin,
             const VehicleInput& end, const Surroundings& surroundings, double dt) {
    const VehicleParams& params = vehicle.params;

    // Body: where it is at the end of the step.
    ChassisMotion next = predicted(motion, state, dt);
    const BodyFrame from = bodyFrame(motion, state, surroundings.gravity_W);
    const BodyFrame to = bodyFrame(next, state, surroundings.gravity_W);

    // Steering.
    const SteeringMotion front = steer(state, vehicle, begin, end, dt);
    const PerWheel<double> steer_begin{front.begin.left, front.begin.right, 0, 0};
    const PerWheel<double> steer_end{front.end.left, front.end.right, 0, 0};

    // Suspension travel and wheel loads.
    if (vehicle.recedes) advanceRecession(state.wheels, vehicle, from, dt);
    const auto contacts = advanceTravel(state.wheels, vehicle, from, to, steer_end, surroundings.road, dt);

    // Driveline and brake torques, with their mean over the step.
    const DrivelineTorques drive =
        advance(state.driveline, params.driveline,
                {middle(begin.throttle, end.throttle), middle(begin.clutch, end.clutch), spins(state.wheels)}, dt);
    const PerAxle<double> brake = brakeTorques(params.brakes, end.brake);
    const PerAxle<double> mean_brake = brakeTorques(params.brakes, middle(begin.brake, end.brake));
    state.engine_torque = drive.engine;

    // Tyre forces and spin.
    PerWheel<TyreState> tyres;
    PerWheel<TyreMotion> motion_begin, motion_end;
    PerWheel<TyreSpin> torques;
    PerWheel<TyreFactors> factors;
    PerWheel<double> steer_rate, spin;
    const PerWheel<double> spin_begin = spins(state.wheels);
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = state.wheels[i];
        wheel.drive_torque = drive.wheel[axleOf(i)];
        wheel.brake_torque = brake[axleOf(i)];
        steer_rate[i] = (steer_end[i] - steer_begin[i]) / dt;
        tyres[i] = wheel.tyre;
        motion_begin[i] = wheel.motion;
        motion_end[i] =
            tyreMotion(contacts[i], to, contactSlopes(wheel, vehicle, i), wheel.rate, steer_rate[i], wheel.load);
        if (vehicle.recedes) recede(motion_end[i], wheel.recession, contacts[i]);
        wheel.motion = motion_end[i];
        torques[i] = {vehicle.corners[i].wheel_inertia, contacts[i].radius, wheel.drive_torque, mean_brake[axleOf(i)]};
        factors[i].friction = contacts[i].friction;
        spin[i] = wheel.spin;
    }
    if (vehicle.tyres_shifted) shiftMotions(motion_begin, motion_end, vehicle);
    if (vehicle.tyres_warm) applyWarmth(factors, state.wheels, vehicle);
    const PerWheel<TyreForces> paper =
        advance(tyres, spin, vehicle.tyres, factors, motion_begin, motion_end, torques, dt);

    // What each wheel hands to the body.
    Wrench wrench = weight(vehicle, to);
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = state.wheels[i];
        wheel.tyre = tyres[i];
        wheel.spin = spin[i];
        const TyreForces tyre = toIso(paper[i]);
        takeTyreForces(wheel, tyre, vehicle, contacts[i], i, dt);
        addWheel(wrench,
                 {.corner = vehicle.corners[i],
                  .contact = contacts[i],
                  .tyre = tyre,
                  .load = wheel.load,
                  .suspension_force = wheel.suspension_force,
                  .link_force = wheel.link_force,
                  .spin = wheel.spin,
                  .spin_rate = (wheel.spin - spin_begin[i]) / dt,
                  .steer_rate = steer_rate[i]},
                 to);
    }

    wrench.add(displacedWheels(vehicle, state.wheels, to));
    if (vehicle.recedes) wrench.add(recessionWrench(state.wheels, vehicle, contacts, to, dt));
    if (vehicle.tyres_warm) warmTyres(state.wheels, vehicle, dt);

    // Aerodynamics.
    wrench.add(aeroWrench(vehicle, to));

    // One wrench moves the body.
    correct(next, state, vehicle, to, wrench, dt);
    motion = next;
}

}  // namespace tread
