// The wiring of the car: the one place where sub-models meet.
//
// A step is velocity Verlet for the body with an implicit step of every wheel inside it: the body moves with the
// accelerations of the last step, the wheels are advanced between both ends of that motion, and their forces at the end
// correct its velocity. Second order; undamped bounce keeps its energy; at rest nothing is biased, so a parked car
// stays.

#include "tread/vehicle.h"

#include <cmath>

#include "tyre/four_tyres.h"
#include "vehicle/body.h"
#include "vehicle/force_command.h"
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
        .aligning_stiffness = vehicle.corners[0].aligning_stiffness + vehicle.corners[1].aligning_stiffness,
        .turning_resistance = turningResistance(vehicle.corners[0], left.spin, dt) +
                              turningResistance(vehicle.corners[1], right.spin, dt)};
    return advance(state.steering, params.steering, input, dt);
}

// Rate of the steer angle by what yields to the aligning moments.
double yieldingRate(const VehicleState& state, std::size_t wheel) {
    return state.wheels[wheel].moment_steer.rate + (axleOf(wheel) == 0 ? state.steering.yielding.rate : 0);
}
PerWheel<double> yieldingRates(const VehicleState& state) {
    return {yieldingRate(state, 0), yieldingRate(state, 1), yieldingRate(state, 2), yieldingRate(state, 3)};
}

double middle(double begin, double end) {
    return 0.5 * (begin + end);
}

PerWheel<double> spins(const PerWheel<WheelState>& wheels) {
    return {wheels[0].spin, wheels[1].spin, wheels[2].spin, wheels[3].spin};
}

// What the driver asks of the driveline, and what it sees of the wheels and of the body that leans on them.
DrivelineInput drivelineInput(const Vehicle& vehicle, const VehicleState& state, const BodyFrame& body,
                              const VehicleInput& begin, const VehicleInput& end) {
    DrivelineInput input{.throttle = middle(begin.throttle, end.throttle),
                         .clutch_pedal = middle(begin.clutch, end.clutch),
                         .wheel_spin = spins(state.wheels)};
    for (std::size_t i = 0; i < kWheels; ++i) {
        const WheelState& wheel = state.wheels[i];
        input.wheel_inertia[i] = vehicle.corners[i].wheel_inertia;
        input.wheel_load[i] = vehicle.corners[i].wheel_inertia * wheel.spin_rate - wheel.drive_torque;
    }
    input.lateral_acceleration = body.acceleration_B.y();
    // A motor leaves wheels that may lock to their brakes.
    if (regulatedWheels(state.brakes.anti_lock) == 0)
        input.brake_torque = vehicle.params.brakes.full_pedal_torque * middle(begin.brake, end.brake);
    return input;
}

// The same for the brakes and their controllers.
BrakeInput brakeInput(const Vehicle& vehicle, const VehicleState& state, const VehicleInput& begin,
                      const VehicleInput& end) {
    BrakeInput input{.pedal_begin = begin.brake,
                     .pedal_end = end.brake,
                     .parking_begin = begin.parking_brake,
                     .parking_end = end.parking_brake};
    for (std::size_t i = 0; i < kWheels; ++i) {
        input.spin[i] = state.wheels[i].spin;
        input.speed[i] = state.wheels[i].motion.Vx;
        input.rolling[i] = vehicle.corners[i].tyre.parameters.Re * state.wheels[i].spin;
        input.drag[i] = vehicle.corners[i].brake_drag;
    }
    return input;
}

// Puts a commanded force in the place of engine, motor and brake pedal.
void takeCommand(DrivelineInput& driveline, BrakeInput& brakes, const Vehicle& vehicle, const VehicleState& state,
                 double force, double dt) {
    const CommandedTorques torques = commandedTorques(vehicle, state.wheels, force);
    driveline.commanded = torques.drive;
    driveline.brake_torque = 0;
    brakes.pedal_begin = brakes.pedal_end = 0;
    brakes.commanded = torques.brake;
    for (std::size_t i = 0; i < kWheels; ++i)
        brakes.commanded[i] *= takenShare(state.wheels[i], vehicle.corners[i], brakes.commanded[i], dt);
}

StabilityControlInput stabilityControlInput(const Vehicle& vehicle, const BodyFrame& body,
                                            const PerWheel<double>& steer) {
    return {.speed = body.motion.velocity_B.x(),
            .steer = middle(steer.front_left, steer.front_right),
            .yaw_rate = body.motion.angular_velocity_B.z(),
            .wheelbase = vehicle.params.wheelbase};
}

}  // namespace

void advance(ChassisMotion& motion, VehicleState& state, const Vehicle& vehicle, const VehicleInput& begin,
             const VehicleInput& end, const Surroundings& surroundings, double dt) {
    const VehicleParams& params = vehicle.params;

    // Body: where it is at the end of the step.
    ChassisMotion next = predicted(motion, state.acceleration_W, state.angular_acceleration_W, dt);
    const BodyFrame from = bodyFrame(motion, state, surroundings.gravity_W);
    const BodyFrame to = bodyFrame(next, state, surroundings.gravity_W);

    // Steering.
    const PerWheel<double> yielding_begin = yieldingRates(state);
    const SteeringMotion front = steer(state, vehicle, begin, end, dt);
    const PerWheel<double> steer_begin{front.begin.left, front.begin.right, 0, 0};
    const PerWheel<double> steer_end{front.end.left, front.end.right, 0, 0};

    // Suspension travel and wheel loads.
    if (vehicle.recedes) advanceRecession(state.wheels, vehicle, dt);
    const auto contacts = advanceTravel(state.wheels, vehicle, from, to, steer_end, surroundings.road, dt);

    // Driveline and brake torques, with their mean over the step.
    DrivelineInput drive_input = drivelineInput(vehicle, state, from, begin, end);
    BrakeInput brake_input = brakeInput(vehicle, state, begin, end);
    const bool commanded = end.force_command > 0.5;
    if (commanded)
        takeCommand(drive_input, brake_input, vehicle, state, middle(begin.longitudinal_force, end.longitudinal_force),
                    dt);
    const DrivelineTorques drive = advance(state.driveline, params.driveline, drive_input, dt);
    brake_input.recovered = drive.braked;
    brake_input.car = stabilityControlInput(vehicle, to, steer_end);
    const BrakeTorques brake = advance(state.brakes, params.brakes, brake_input, dt);
    state.engine_torque = drive.engine;
    state.motor_torque = drive.motor;

    // Tyre forces and spin.
    PerWheel<TyreState> tyres;
    PerWheel<TyreMotion> motion_begin, motion_end;
    PerWheel<TyreSpin> torques;
    PerWheel<TyreFactors> factors;
    PerWheel<double> steer_rate, spin;
    const PerWheel<double> spin_begin = spins(state.wheels);
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = state.wheels[i];
        wheel.drive_torque = drive.wheel[i];
        if (commanded) wheel.drive_torque *= takenShare(wheel, vehicle.corners[i], std::abs(drive.wheel[i]), dt);
        wheel.brake_torque = brake.end[i];
        steer_rate[i] = (steer_end[i] - steer_begin[i]) / dt + wheel.moment_steer.rate;
        tyres[i] = wheel.tyre;
        motion_begin[i] = wheel.motion;
        motion_end[i] = tyreMotion(contacts[i], to, contactSlopes(wheel, vehicle, i), wheel.rate, steer_rate[i],
                                   grippingLoad(vehicle.corners[i].tyre, wheel.load));
        motion_begin[i].psidot -= yieldingRate(state, i) - yielding_begin[i];  // it yields evenly over the step
        if (vehicle.recedes) recede(motion_end[i], wheel.recession, contacts[i]);
        wheel.motion = motion_end[i];
        torques[i] = {vehicle.corners[i].wheel_inertia, contacts[i].radius, wheel.drive_torque, brake.mean[i]};
        factors[i].friction = contacts[i].friction;
        spin[i] = wheel.spin;
    }
    if (vehicle.tyres_shifted) shiftMotions(motion_begin, motion_end, vehicle);
    if (vehicle.warmth_felt) applyWarmth(factors, state.wheels, vehicle);
    const PerWheel<TyreForces> paper =
        advance(tyres, spin, *vehicle.tyres, factors, motion_begin, motion_end, torques, dt);

    // What each wheel hands to the body.
    Wrench wrench = weight(vehicle, to);
    for (std::size_t i = 0; i < kWheels; ++i) {
        WheelState& wheel = state.wheels[i];
        wheel.tyre = tyres[i];
        wheel.spin = spin[i];
        wheel.spin_rate = (wheel.spin - spin_begin[i]) / dt;
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
                  .spin_rate = wheel.spin_rate,
                  .steer_rate = steer_rate[i]},
                 to);
    }

    wrench.add(displacedWheels(vehicle, state.wheels, to));
    if (vehicle.recedes) wrench.add(recessionWrench(state.wheels, vehicle, contacts, to, dt));
    if (vehicle.tyres_warm) warmTyres(state.wheels, vehicle, dt);

    // Aerodynamics.
    wrench.add(aeroWrench(vehicle, to, surroundings.wind_W));

    // One wrench moves the body.
    correct(next, state, vehicle, to, wrench, dt);
    motion = next;
}

}  // namespace tread
