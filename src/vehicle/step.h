// The wiring of the car: the one place where sub-models meet. T is double for one car, or lanes of which each holds
// another car.
//
// A step is velocity Verlet for the body with an implicit step of every wheel inside it: the body moves with the
// accelerations of the last step, the wheels are advanced between both ends of that motion, and their forces at the end
// correct its velocity. Second order; undamped bounce keeps its energy; at rest nothing is biased, so a parked car
// stays.
//
// What a single car (vehicle.cpp) and cars in lanes (fleet/lane_cars.h) bring along, each in its own way:
//   stateOf, carOf, paramsOf                 the car in a lane, for what is computed car by car
//   advanceTyres                             the step of the four tyres
//   advanceRecession, recede, addRecession   the longitudinal compliance of the suspension
#pragma once

#include "tread/vehicle.h"
#include "vehicle/body.h"
#include "vehicle/controls.h"
#include "vehicle/travel.h"
#include "vehicle/tyre_conditions.h"
#include "vehicle/wheel.h"

namespace tread {
inline namespace TREAD_ISA {

// What surrounds the cars during a step; the road is asked as Road in road.h is.
template <class T, class Ground>
struct BasicSurroundings {
    const Ground& road;
    VectorOf<T> gravity_W;
    VectorOf<T> wind_W;  // m/s, velocity of the air
};

// The driver's inputs of the car in each lane, at both ends of the step.
struct Inputs {
    const VehicleInput* begin;
    const VehicleInput* end;
};

// Angles of the wheels at both ends of the step, without toe, rad; those of the rear wheels are 0.
template <class T>
struct FrontSteering {
    PerWheel<T> begin{};
    PerWheel<T> end{};
};

// Rate of the steer angle by what yields to the aligning moments.
template <class T, class State>
PerWheel<T> yieldingRates(State& state) {
    PerWheel<T> rates{state.wheels[0].moment_steer.rate, state.wheels[1].moment_steer.rate,
                      state.wheels[2].moment_steer.rate, state.wheels[3].moment_steer.rate};
    T steering = 0;
    for (std::size_t i = 0; i < kLanesOf<T>; ++i) setLane(steering, i, stateOf(state, i).steering.yielding.rate);
    rates.front_left += steering;
    rates.front_right += steering;
    return rates;
}

template <class T, class State, class Car>
FrontSteering<T> steerCars(State& state, const Car& vehicle, const Inputs& inputs, double dt) {
    FrontSteering<T> front;
    const BasicWheelState<T>&left = state.wheels.front_left, &right = state.wheels.front_right;
    const T resistance =
        turningResistance(vehicle.corners[0], left.spin, dt) + turningResistance(vehicle.corners[1], right.spin, dt);
    for (std::size_t i = 0; i < kLanesOf<T>; ++i) {
        const FrontWheels wheels{.left = {lane(left.fx, i), lane(left.fy, i), lane(left.mz, i)},
                                 .right = {lane(right.fx, i), lane(right.fy, i), lane(right.mz, i)},
                                 .turning_resistance = lane(resistance, i)};
        const SteeringMotion motion =
            steer(stateOf(state, i).steering, carOf(vehicle, i), wheels, inputs.begin[i], inputs.end[i], dt);
        setLane(front.begin.front_left, i, motion.begin.left);
        setLane(front.begin.front_right, i, motion.begin.right);
        setLane(front.end.front_left, i, motion.end.left);
        setLane(front.end.front_right, i, motion.end.right);
    }
    return front;
}

// Torques on the wheels: of the driveline, and that the brakes can hold at the end of the step and in its mean.
template <class T>
struct Torques {
    PerWheel<T> drive, brake_end, brake_mean;
};

// Shows a car's wheels where a commanded force looks for them (force_command.h): those of a single car are there.
template <class T, class State>
void showWheels(State& state, std::size_t car) {
    for (std::size_t k = 0; k < kWheels; ++k) {
        const BasicWheelState<T>& wheel = state.wheels[k];
        WheelState& shown = stateOf(state, car).wheels[k];
        shown.radius = lane(wheel.radius, car);
        shown.spin = lane(wheel.spin, car);
        shown.fx = lane(wheel.fx, car);
        shown.motion.Vx = lane(wheel.motion.Vx, car);
    }
}

template <class T, class State, class Car>
Torques<T> driveAndBrakeCars(State& state, const Car& vehicle, const BasicBodyFrame<T>& from,
                             const BasicBodyFrame<T>& to, const PerWheel<T>& steer, const Inputs& inputs, double dt) {
    Torques<T> torques;
    const T mean_steer = 0.5 * (steer.front_left + steer.front_right);
    for (std::size_t i = 0; i < kLanesOf<T>; ++i) {
        CarSeen seen{.lateral_acceleration = lane(from.acceleration_B.y(), i),
                     .forward_speed = lane(to.motion.velocity_B.x(), i),
                     .yaw_rate = lane(to.motion.angular_velocity_B.z(), i),
                     .steer = lane(mean_steer, i)};
        for (std::size_t k = 0; k < kWheels; ++k) {
            const BasicWheelState<T>& wheel = state.wheels[k];
            seen.spin[k] = lane(wheel.spin, i);
            seen.spin_rate[k] = lane(wheel.spin_rate, i);
            seen.drive_torque[k] = lane(wheel.drive_torque, i);
            seen.speed[k] = lane(wheel.motion.Vx, i);
        }
        if (inputs.end[i].force_command != 0) showWheels<T>(state, i);
        const WheelTorques car =
            driveAndBrake(stateOf(state, i), carOf(vehicle, i), seen, inputs.begin[i], inputs.end[i], dt);
        for (std::size_t k = 0; k < kWheels; ++k) {
            setLane(torques.drive[k], i, car.drive[k]);
            setLane(torques.brake_end[k], i, car.brake.end[k]);
            setLane(torques.brake_mean[k], i, car.brake.mean[k]);
        }
    }
    return torques;
}

// What four tyres are given over a step.
template <class T>
struct TyreStep {
    PerWheel<BasicTyreMotion<T>> begin, end;
    PerWheel<BasicTyreSpin<T>> torques;
    PerWheel<BasicTyreFactors<T>> factors;
};

template <class T, class Motion, class State, class Car, class Ground>
void step(Motion& motion, State& state, const Car& vehicle, const Inputs& inputs,
          const BasicSurroundings<T, Ground>& surroundings, double dt) {
    // Body: where it is at the end of the step.
    Motion next = predictedMotion<T>(motion, state.acceleration_W, state.angular_acceleration_W, dt);
    const BasicBodyFrame<T> from = bodyFrameOf<T>(motion, state, surroundings.gravity_W);
    const BasicBodyFrame<T> to = bodyFrameOf<T>(next, state, surroundings.gravity_W);

    // Steering.
    const PerWheel<T> yielding_begin = yieldingRates<T>(state);
    const FrontSteering<T> front = steerCars<T>(state, vehicle, inputs, dt);

    // Suspension travel and wheel loads.
    advanceRecession(state.wheels, vehicle, dt);
    const auto contacts = advanceTravel(state.wheels, vehicle, from, to, front.end, surroundings.road, dt);

    // Driveline and brake torques, with their mean over the step.
    const Torques<T> torques = driveAndBrakeCars(state, vehicle, from, to, front.end, inputs, dt);

    // Tyre forces and spin.
    TyreStep<T> tyres;
    PerWheel<T> steer_rate;
    const PerWheel<T> yielding_end = yieldingRates<T>(state);
    for (std::size_t i = 0; i < kWheels; ++i) {
        BasicWheelState<T>& wheel = state.wheels[i];
        const auto& corner = vehicle.corners[i];
        wheel.drive_torque = torques.drive[i];
        wheel.brake_torque = torques.brake_end[i];
        steer_rate[i] = (front.end[i] - front.begin[i]) / dt + wheel.moment_steer.rate;
        tyres.begin[i] = wheel.motion;
        tyres.begin[i].psidot -= yielding_end[i] - yielding_begin[i];  // it yields evenly over the step
        tyres.end[i] = tyreMotion<T>(contacts[i], to, contactSlopes(wheel, vehicle, i), wheel.rate, steer_rate[i],
                                     grippingLoad<T>(corner.tyre, wheel.load));
        recede(tyres.end[i], vehicle, wheel.recession, contacts[i]);
        wheel.motion = tyres.end[i];
        tyres.torques[i] = {corner.wheel_inertia, contacts[i].radius, wheel.drive_torque, torques.brake_mean[i]};
        tyres.factors[i].friction = contacts[i].friction;
    }
    const PerWheel<T> spin_begin{state.wheels[0].spin, state.wheels[1].spin, state.wheels[2].spin,
                                 state.wheels[3].spin};
    const PerWheel<BasicTyreForces<T>> paper = advanceTyres(state.wheels, vehicle, tyres, dt);

    // What each wheel hands to the body.
    BasicWrench<T> wrench = weight(vehicle, to);
    for (std::size_t i = 0; i < kWheels; ++i) {
        BasicWheelState<T>& wheel = state.wheels[i];
        wheel.spin_rate = (wheel.spin - spin_begin[i]) / dt;
        const BasicTyreForces<T> tyre = toIso(paper[i]);
        takeTyreForces(wheel, tyre, vehicle, contacts[i], i, dt);
        addWheel(wrench, vehicle.corners[i], contacts[i], tyre, wheel, steer_rate[i], to);
    }
    wrench.add(displacedWheels(vehicle, state.wheels, to));
    addRecession(wrench, state.wheels, vehicle, contacts, to, dt);
    if (vehicle.tyres_warm) warmTyres(state.wheels, vehicle, dt);

    // Aerodynamics.
    wrench.add(aeroWrench(vehicle, to, surroundings.wind_W));

    // One wrench moves the body.
    correct(next, state, vehicle, to, wrench, dt);
    motion = next;
}

}  // namespace TREAD_ISA
}  // namespace tread
