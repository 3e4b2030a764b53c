// A car that a host program steps: a game, a co-simulation, a driving simulator, a robot's middleware.
//
//     host::Car car(loadVehicle("vehicles/compact.yaml"));
//     car.start({.speed = 20});
//     for (;;) {
//         car.setInput({.steering_wheel_angle = 0.3, .throttle = 0.2});
//         car.advance(0.01);
//         car.output().chassis.yaw_rate;
//     }
//
// tread moves the chassis (advance), or the host does with forces of tread (push; see host/body.h). World and vehicle
// axes are ISO 8855, z up, gravity kStandardGravity. What a host gives wrongly and a car that breaks down are Failures;
// a broken car goes on only after start() or restore(). Cars are independent of each other: one thread at a time for
// each of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/body.h"
#include "host/ground.h"
#include "host/pace.h"
#include "host/snapshot.h"
#include "tread/equilibrium.h"
#include "tread/vehicle.h"

namespace tread::host {

// How an input gets from its last value to the new one in the next step of the host.
enum class Course {
    held,  // at once: it holds the new value all the step
    ramp   // linearly: it has the new value at the end of the step
};

class Car {
public:
    static constexpr double kUsualStep = 1e-3;  // s, as in `tread run`
    static constexpr double kLongestStep = 0.01;
    static constexpr double kShortestStep = 1e-4;

    // `step`: the inner one (host/pace.h).
    explicit Car(const VehicleParams& params, double step = kUsualStep);
    Car(const Car&) = delete;
    Car& operator=(const Car&) = delete;

    // Planes, a function or a road; to be chosen before start().
    Ground& ground() { return ground_; }

    // Ground and air of another car.
    void takeSurroundings(const Car& other);

    // Velocity of the air, m/s, in the world. Still at first.
    void setWind(const Vector3& velocity_W);

    // Puts the car on its ground in equilibrium, at time 0. The input is then the one that keeps it there.
    void start(const Start& start);

    // For the steps from now on.
    void setInput(const VehicleInput& input, Course course = Course::held);
    const VehicleInput& input() const { return now_.next; }

    // Advances car and chassis.
    void advance(double duration);

    // Advances the car on the host's body, which shows this motion now; gives what moves the body for `duration`.
    // Between start() and the first push(), the host puts its body where motion() says.
    BodyForce push(const ChassisMotion& body, double duration, Integration integration = Integration::exact);

    double time() const { return now_.time; }  // s, since start()
    const ChassisMotion& motion() const { return now_.motion; }
    const VehicleState& state() const { return now_.state; }
    const Vehicle& vehicle() const { return vehicle_; }
    double step() const { return pace_.step(); }
    BodyProperties body() const { return bodyProperties(vehicle_); }

    // At time(); the yaw angle counts on over whole turns.
    const VehicleOutput& output() const;

    // Copies of all that the car remembers; from them it goes on bit for bit. Grounds are part of them as planes only.
    Snapshot snapshot() const;
    void restore(const Snapshot& snapshot);

    // The same as bytes, which refuse other cars and other versions.
    std::vector<std::byte> bytes() const;
    void restore(std::span<const std::byte> bytes);

private:
    void move(ChassisMotion& motion, double duration);
    void count(double duration);
    void followYaw(const ChassisMotion& motion);
    void checkHealth();
    std::uint64_t identity() const;

    Vehicle vehicle_;
    Pace pace_;
    Ground ground_;
    Snapshot now_;
    bool started_ = false;
    bool broken_ = false;
    mutable VehicleOutput output_;
    mutable bool observed_ = false;
    mutable std::uint64_t identity_ = 0;  // 0: not yet computed
};

}  // namespace tread::host
