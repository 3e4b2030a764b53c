// A car on which every sub-model is on.
#pragma once

#include "tread/vehicle.h"

namespace tread::shared {

// A car with a little of everything that a driveline with engine and clutch, brakes and controllers can have.
inline void equipDriveline(VehicleParams& params) {
    DrivelineParams& drive = params.driveline;
    drive.front_share = 0.6;
    drive.engine->response_time = 0.02;
    drive.engine->part_load = {{0.5, {{{80, 40}, {700, 30}}}}};
    drive.gearbox.shift_time = 0.1;
    drive.front_differential =
        LimitedSlipDifferential{.preload = 20, .locking_driving = 0.05, .locking_coasting = 0.04, .viscosity = 1};
    drive.rear_differential = VectoringDifferential{.by_lateral_acceleration = 30, .largest = 100};
    drive.centre_differential =
        LimitedSlipDifferential{.preload = 10, .locking_driving = 0.03, .locking_coasting = 0.02, .viscosity = 2};
    BrakeParams& brakes = params.brakes;
    brakes.delay = 0.02;
    brakes.lag = 0.03;
    brakes.rear_proportioning = {.knee = 2e6, .slope = 0.5};
    brakes.front_disc = brakes.rear_disc = {
        .heat_capacity = 4000, .cooling = 5, .cooling_by_speed = 1, .friction = {{{300, 1}, {800, 0.8}}}};
    brakes.parking_torque = 1500;
    brakes.anti_lock.enabled = brakes.stability_control.enabled = true;
    brakes.stability_control.largest = 300;
    params.aero.side_force_area = params.aero.yaw_moment_volume = {{{0, 0}, {0.5, 1}}};
}

// The same, with every optional number of suspension, steering and tyres besides.
inline VehicleParams withEverything(VehicleParams params) {
    equipDriveline(params);
    // What the shipped car has not may still be wanted.
    params.inertia.roll_yaw = 20;
    params.rear.suspension.steer_by_lateral_force = 1e-6;
    for (AxleParams* axle : {&params.front, &params.rear}) {
        axle->suspension.damper.friction = 30;
        axle->suspension.side_view_slope_driving = 0.05;
        axle->tyre.parameters.pVx1 = 0.01;
        axle->tyre.parameters.qx1 = 1e-5;
        axle->suspension.steer_by_aligning_moment = 1e-5;
        axle->suspension.steer_by_longitudinal_force = 1e-6;
        axle->suspension.camber_by_lateral_force = 1e-6;
        axle->suspension.longitudinal_compliance = 1e-6;
        axle->tyre_surroundings = {.pressure = {.inflation = 200000,
                                                .radial_stiffness = 0.7,
                                                .slip_stiffness = 0.2,
                                                .cornering_stiffness = 0.5,
                                                .cornering_peak_load = 0.4},
                                   .temperature = {.start = 300,
                                                   .heat_capacity = 2000,
                                                   .slip_share = 0.7,
                                                   .cooling = 10,
                                                   .cooling_by_speed = 1,
                                                   .friction = 0.001,
                                                   .friction_squared = -1e-5,
                                                   .stiffness = -0.002},
                                   .ply_steer = 0.001,
                                   .conicity = 0.002};
    }
    // One wheel wears another tyre than its axle.
    params.rear.right = {.tyre = params.rear.tyre, .tyre_surroundings = params.rear.tyre_surroundings};
    params.rear.right.tyre->parameters.Ro -= 0.002;
    params.steering = {.ratio = params.steering.ratio,
                       .ratio_curve = {},
                       .ackermann = params.steering.ackermann,
                       .delay = 0.012,
                       .lag = 0.02,
                       .play = 0.02,
                       .column_compliance = 0.005,
                       .rack_compliance = 2e-5,
                       .caster_trail = 0.02,
                       .scrub_radius = 0.01,
                       .inertia = 0.05,
                       .damping = 0.2,
                       .friction = 0.3};
    return params;
}

}  // namespace tread::shared
