#include "vehicle/controls.h"

#include <cmath>

#include "vehicle/force_command.h"

namespace tread {
namespace {

double middle(double begin, double end) {
    return 0.5 * (begin + end);
}

// What the driver asks of the driveline, and what it sees of the wheels and of the body that leans on them.
DrivelineInput drivelineInput(const Vehicle& vehicle, const VehicleState& state, const CarSeen& seen,
                              const VehicleInput& begin, const VehicleInput& end) {
    DrivelineInput input{.throttle = middle(begin.throttle, end.throttle),
                         .clutch_pedal = middle(begin.clutch, end.clutch),
                         .wheel_spin = seen.spin};
    for (std::size_t i = 0; i < kWheels; ++i) {
        input.wheel_inertia[i] = vehicle.corners[i].wheel_inertia;
        input.wheel_load[i] = vehicle.corners[i].wheel_inertia * seen.spin_rate[i] - seen.drive_torque[i];
    }
    input.lateral_acceleration = seen.lateral_acceleration;
    // A motor leaves wheels that may lock to their brakes.
    if (regulatedWheels(state.brakes.anti_lock) == 0)
        input.brake_torque = vehicle.params.brakes.full_pedal_torque * middle(begin.brake, end.brake);
    return input;
}

// The same for the brakes and their controllers.
BrakeInput brakeInput(const Vehicle& vehicle, const CarSeen& seen, const VehicleInput& begin, const VehicleInput& end) {
    BrakeInput input{.pedal_begin = begin.brake,
                     .pedal_end = end.brake,
                     .parking_begin = begin.parking_brake,
                     .parking_end = end.parking_brake,
                     .spin = seen.spin,
                     .speed = seen.speed};
    for (std::size_t i = 0; i < kWheels; ++i) {
        input.rolling[i] = vehicle.corners[i].tyre.parameters.Re * seen.spin[i];
        input.drag[i] = vehicle.corners[i].brake_drag;
    }
    input.car = {.speed = seen.forward_speed,
                 .steer = seen.steer,
                 .yaw_rate = seen.yaw_rate,
                 .wheelbase = vehicle.params.wheelbase};
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

}  // namespace

SteeringMotion steer(SteeringState& state, const Vehicle& vehicle, const FrontWheels& wheels, const VehicleInput& begin,
                     const VehicleInput& end, double dt) {
    const VehicleParams& params = vehicle.params;
    const auto moment = [&](const FrontWheels::Forces& f, bool left) {
        return steeringMoment(params.steering, f.fx, f.fy, f.mz, left);
    };
    const SteeringInput input{
        .begin = begin.steering_wheel_angle,
        .end = end.steering_wheel_angle,
        .hands_off = end.hands_off > 0.5,
        .track = params.front.track,
        .wheelbase = params.wheelbase,
        .left_moment = moment(wheels.left, true),
        .right_moment = moment(wheels.right, false),
        .aligning_stiffness = vehicle.corners[0].aligning_stiffness + vehicle.corners[1].aligning_stiffness,
        .turning_resistance = wheels.turning_resistance};
    return advance(state, params.steering, input, dt);
}

WheelTorques driveAndBrake(VehicleState& state, const Vehicle& vehicle, const CarSeen& seen, const VehicleInput& begin,
                           const VehicleInput& end, double dt) {
    DrivelineInput drive_input = drivelineInput(vehicle, state, seen, begin, end);
    BrakeInput brake_input = brakeInput(vehicle, seen, begin, end);
    const bool commanded = end.force_command > 0.5;
    if (commanded)
        takeCommand(drive_input, brake_input, vehicle, state, middle(begin.longitudinal_force, end.longitudinal_force),
                    dt);
    DrivelineTorques drive = advance(state.driveline, vehicle.params.driveline, drive_input, dt);
    brake_input.recovered = drive.braked;
    const BrakeTorques brake = advance(state.brakes, vehicle.params.brakes, brake_input, dt);
    state.engine_torque = drive.engine;
    state.motor_torque = drive.motor;
    for (std::size_t i = 0; i < kWheels && commanded; ++i)
        drive.wheel[i] *= takenShare(state.wheels[i], vehicle.corners[i], std::abs(drive.wheel[i]), dt);
    return {drive.wheel, brake};
}

}  // namespace tread
