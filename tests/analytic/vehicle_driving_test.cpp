// Braking, coasting and accelerating against closed forms; energy and momentum of a whole drive.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <numbers>

#include "shared/vehicles.h"

namespace tread::vehicle_driving_test {
namespace {

constexpr double kStep = 0.001;  // s

std::vector<VehicleParams> cars() {
    return {reference::compact(), reference::rearDriveSedan()};
}

VehicleParams withoutAir(VehicleParams car) {
    car.aero = {};
    return car;
}

double rollingResistance(const reference::Car& car) {
    double torque = 0;  // N m
    for (std::size_t i = 0; i < kWheels; ++i) {
        const TyreParams& tyre = car.vehicle.corners[i].tyre;
        torque += tyre.parameters.qy1 * car.state.wheels[i].load * 2 / std::numbers::pi *
                  std::atan(tyre.parameters.Re * car.state.wheels[i].spin);  // (85)
    }
    return torque;
}

// Mass that a longitudinal force has to accelerate: the car and its rolling wheels.
double effectiveMass(const VehicleParams& params) {
    const double front = params.front.tyre.parameters.Re, rear = params.rear.tyre.parameters.Re;
    return params.mass + 2 * params.front.wheel_inertia / (front * front) +
           2 * params.rear.wheel_inertia / (rear * rear);
}

// ---- Braking ----

TEST(Braking, LockedWheelsStopWithinTheSlidingFriction) {
    // Sliding friction at slip -1 and the loads under braking; both axles slide.
    VehicleParams params = withoutAir(reference::simplified(reference::compact()));
    params.brakes.full_pedal_torque = 40000;
    params.brakes.front_share = 0.5;
    const PlaneRoad road;
    reference::Car car = reference::settled(params, road, {.speed = 30});
    for (int k = 1; k <= 200; ++k) car.step({.brake = k / 200.0, .clutch = 1}, kStep);
    for (double t = 0; t < 1; t += kStep) car.step(kStep);

    const Vector3 from = car.motion.position_W;
    const double speed = car.output().chassis.vx;
    double friction = 0, load = 0;
    for (std::size_t i = 0; i < kWheels; ++i) {
        EXPECT_EQ(car.state.wheels[i].spin, 0) << "locked";
        const TyreSteadyState slide = steadyState(
            car.vehicle.corners[i].tyre, {.Fz = car.state.wheels[i].load, .gamma = 0, .Vx = 10, .Vsx = 10, .Vsy = 0});
        friction -= slide.Fx;
        load += car.state.wheels[i].load;
    }
    friction /= load;
    while (car.output().chassis.vx > 3) car.step(kStep);
    const double end = car.output().chassis.vx;
    const double distance = (car.motion.position_W - from).norm();
    const double closed = (speed * speed - end * end) / (2 * friction * kStandardGravity);
    std::printf("locked from %.2f to %.2f m/s: %.3f m, closed form %.3f m (sliding friction %.4f)\n", speed, end,
                distance, closed, friction);
    EXPECT_NEAR(distance, closed, 0.002 * closed);
}

TEST(Braking, LoadTransferAndBalanceFollowFromTheDeceleration) {
    for (const VehicleParams& shipped : cars()) {
        const VehicleParams params = withoutAir(shipped);
        const PlaneRoad road;
        reference::Car car = reference::settled(params, road, {.speed = 40});
        for (int k = 1; k <= 500; ++k) car.step({.brake = 0.3 * k / 500, .clutch = 1}, kStep);
        for (double t = 0; t < 2; t += kStep) car.step(kStep);

        const VehicleOutput out = car.output();
        const double deceleration = -out.chassis.ax;
        const double b = params.wheelbase - params.front_axle_distance;
        // Moments about the rear contacts, at the height and pitch to which the car dived; the wheels that spin down
        // push the body forwards over them.
        double spinning = 0;
        for (std::size_t i = 0; i < kWheels; ++i)
            spinning += car.vehicle.corners[i].wheel_inertia * deceleration / car.vehicle.corners[i].tyre.parameters.Re;
        const double height = car.motion.position_W.z();
        const double pitch = out.chassis.pitch;
        const double ahead =
            b * std::cos(pitch) + (params.centre_of_gravity_height - car.state.wheels[2].radius) * std::sin(pitch);
        const double front =
            (params.mass * (kStandardGravity * ahead + deceleration * height) + spinning - rollingResistance(car)) /
            (params.wheelbase * std::cos(pitch));
        const double got = car.state.wheels[0].load + car.state.wheels[1].load;
        std::printf("%s braking at %.2f m/s2: front axle %.1f N, closed form %.1f N (at rest %.1f N)\n",
                    params.name.c_str(), deceleration, got, front,
                    params.mass * kStandardGravity * b / params.wheelbase);
        EXPECT_GT(deceleration, 2);
        EXPECT_NEAR(got, front, 0.002 * front);

        // Balance: each tyre's force is what its brake, less its spinning down, gives.
        for (std::size_t i = 0; i < kWheels; ++i) {
            const WheelState& wheel = car.state.wheels[i];
            const double share = i < 2 ? params.brakes.front_share : 1 - params.brakes.front_share;
            const double brake = 0.5 * 0.3 * params.brakes.full_pedal_torque * share;
            const TyreParams& tyre = car.vehicle.corners[i].tyre;
            const double resistance =
                tyre.parameters.qy1 * wheel.load * 2 / std::numbers::pi * std::atan(tyre.parameters.Re * wheel.spin);
            const double inertia = car.vehicle.corners[i].wheel_inertia * deceleration / tyre.parameters.Re;
            EXPECT_DOUBLE_EQ(out.wheel[i].brake_torque, brake);
            // The driven wheels turn the gearbox, too; its inertia is small against the wheels'.
            EXPECT_NEAR(-wheel.fx * wheel.radius, brake + resistance - inertia - wheel.drive_torque, 0.003 * brake)
                << i;
        }
    }
}

TEST(Braking, SideViewSlopesTakeTheirShareOfTheDive) {
    // Statics of pitch with springs and tyres in series: the links carry slope times braking force.
    const PlaneRoad road;
    const auto dive = [&](double front, double rear) {
        VehicleParams params = withoutAir(reference::simplified(reference::compact()));
        params.front.suspension.side_view_slope_braking = front;
        params.rear.suspension.side_view_slope_braking = rear;
        reference::Car car = reference::settled(params, road, {.speed = 40});
        for (int k = 1; k <= 500; ++k) car.step({.brake = 0.2 * k / 500, .clutch = 1}, kStep);
        for (double t = 0; t < 2; t += kStep) car.step(kStep);
        return car;
    };
    const reference::Car plain = dive(0, 0);
    const double nose = plain.output().chassis.pitch;
    const reference::Car anti = dive(0.1, -0.1);
    // Braking presses the front wheel down by 0.1 Fx less and the rear less up: travels change by that over the spring.
    for (const std::size_t i : {0u, 2u}) {
        const double slope = i == 0 ? 0.1 : -0.1;
        const double spring =
            i == 0 ? plain.vehicle.params.front.suspension.spring : plain.vehicle.params.rear.suspension.spring;
        const double expected = plain.state.wheels[i].travel + slope * anti.state.wheels[i].fx / spring;
        std::printf("wheel %zu under braking: travel %.2f mm, with side-view slope %+.1f %.2f mm (statics %.2f mm)\n",
                    i, 1000 * plain.state.wheels[i].travel, slope, 1000 * anti.state.wheels[i].travel, 1000 * expected);
        EXPECT_NEAR(anti.state.wheels[i].travel, expected, 0.0004);
    }
    EXPECT_GT(nose, 0) << "the nose goes down";
    EXPECT_LT(anti.output().chassis.pitch, nose) << "positive in front, negative at the rear resist the dive";
}

// ---- Coasting ----

TEST(Coasting, SlowsAsDragAndRollingResistanceSay) {
    for (const VehicleParams& shipped : cars()) {
        VehicleParams params = reference::simplified(shipped);
        params.aero.drag_area = shipped.aero.drag_area;
        params.aero.height = shipped.aero.height;
        params.driveline.gearbox.inertia = 1e-6;
        params.driveline.gearbox.efficiency = 1;
        const PlaneRoad road;
        reference::Car car = reference::settled(params, road, {.speed = 40});
        for (int k = 1; k <= 200; ++k) car.step({.clutch = std::min(k / 50.0, 1.0)}, kStep);
        const double speed = car.output().chassis.vx;
        const double duration = 20;
        for (double t = 0; t < duration - 1e-9; t += kStep) car.step(kStep);

        // m v' = -(A + B v^2): v = sqrt(A / B) tan(atan(v0 sqrt(B / A)) - sqrt(A B) t / m). The rolling resistance (85)
        // is all but constant above 5 m/s; it acts at the loaded radius.
        const double mass = effectiveMass(params);
        const double A = rollingResistance(car) / car.state.wheels[0].radius;
        const double B = 0.5 * params.aero.air_density * params.aero.drag_area;
        const double closed =
            std::sqrt(A / B) * std::tan(std::atan(speed * std::sqrt(B / A)) - std::sqrt(A * B) * duration / mass);
        std::printf("%s coasts from %.3f m/s for %.0f s: %.3f m/s, closed form %.3f m/s\n", params.name.c_str(), speed,
                    duration, car.output().chassis.vx, closed);
        EXPECT_NEAR(car.output().chassis.vx, closed, 0.003 * (speed - closed));
    }
}

// A dragging brake takes its torque over the loaded radius from the car, at its own wheel.
TEST(Coasting, DraggingBrakeSlowsTheCarAndTurnsItToItsSide) {
    constexpr double kTorque = 120;  // N m
    const PlaneRoad road;
    const auto coasting = [&](double drag) {
        VehicleParams params = reference::simplified(reference::compact());
        params.driveline.gearbox.inertia = 1e-6;
        reference::Car car = reference::settled(params, road, {.speed = 30});
        for (int k = 1; k <= 200; ++k) car.step({.clutch = std::min(k / 50.0, 1.0)}, kStep);
        car.vehicle.corners.front_right.brake_drag = drag;
        return car;
    };
    reference::Car free = coasting(0), dragging = coasting(kTorque);
    const double force = kTorque / free.state.wheels[1].radius, speed = free.output().chassis.vx;
    for (int k = 0; k < 2000; ++k) free.step(kStep), dragging.step(kStep);
    const double lost = (free.output().chassis.vx - dragging.output().chassis.vx) / 2;
    const double closed = force / effectiveMass(free.vehicle.params);
    std::printf("brake that drags with %.0f N m at %.1f m/s: %.5f m/s2, closed form %.5f m/s2\n", kTorque, speed, lost,
                closed);
    EXPECT_NEAR(lost, closed, 0.01 * closed);
    // Each tyre's force is what drag and rolling resistance, less the wheel's spinning down, give.
    for (std::size_t i = 0; i < kWheels; ++i) {
        const WheelState& wheel = dragging.state.wheels[i];
        const TyreParams& tyre = dragging.vehicle.corners[i].tyre;
        const double resistance =
            tyre.parameters.qy1 * wheel.load * 2 / std::numbers::pi * std::atan(tyre.parameters.Re * wheel.spin);
        const double spinning_down = -dragging.vehicle.corners[i].wheel_inertia * wheel.spin_rate;
        EXPECT_NEAR(-wheel.fx * wheel.radius, (i == 1 ? kTorque : 0) + resistance - spinning_down - wheel.drive_torque,
                    0.001 * kTorque)
            << i;
    }
    EXPECT_LT(dragging.output().chassis.yaw_rate, -1e-3) << "to the right";
}

// ---- Accelerating ----

TEST(Accelerating, DriveTorqueMovesCarWheelsAndEngine) {
    for (const VehicleParams& shipped : cars()) {
        VehicleParams params = withoutAir(reference::simplified(shipped));
        const PlaneRoad road;
        reference::Car car = reference::settled(params, road, {.speed = 20});
        for (int k = 1; k <= 300; ++k) car.step({.throttle = std::min(1.0, car.input.throttle + 0.01)}, kStep);
        const int gear = car.state.driveline.gear;
        for (int k = 0; k < 200; ++k) car.step(kStep);
        ASSERT_EQ(car.state.driveline.gear, gear) << "no shift in the measured time";
        const EngineParams& engine = *params.driveline.engine;
        const GearboxParams& box = params.driveline.gearbox;
        const double ratio = box.ratios[static_cast<std::size_t>(gear - 1)] * box.final_drive;
        const double radius = car.vehicle.corners[0].tyre.parameters.Re;
        const double full = engine.full_load(car.state.driveline.engine_speed);
        const double rolling = effectiveMass(params);
        const double with_engine =
            rolling + box.efficiency * (engine.inertia + box.inertia) * ratio * ratio / (radius * radius);
        const double expected =
            (full * ratio * box.efficiency - rollingResistance(car)) / car.state.wheels[0].radius / with_engine;
        std::printf("%s in gear %d: %.4f m/s2, closed form %.4f m/s2 (car %.0f kg, with rotating parts %.0f kg)\n",
                    params.name.c_str(), gear, car.output().chassis.ax, expected, params.mass, with_engine);
        // A rim rolls at Re but pulls at the loaded radius, 6 % less: 1 % for that and for the slip that grows.
        EXPECT_NEAR(car.output().chassis.ax, expected, 0.02 * expected);
    }
}

TEST(Accelerating, ZeroToHundredTakesAPlausibleTime) {
    for (const VehicleParams& params : cars()) {
        const PlaneRoad road;
        reference::Car car = reference::settled(params, road, {.input = {.brake = 1}});
        double t = 0;
        for (; t < 30 && car.output().chassis.vx < 100 / 3.6; t += kStep)
            car.step({.throttle = std::min(1.0, t / 0.3)}, kStep);
        std::printf("%s: 0 to 100 km/h in %.1f s, in gear %d\n", params.name.c_str(), t, car.state.driveline.gear);
        EXPECT_GT(t, 7);
        EXPECT_LT(t, 14);
    }
}

// ---- Momentum and energy of a whole drive ----

struct Drive {
    const char* name;
    double speed;
    std::function<VehicleInput(double, const VehicleInput&)> driver;
    double duration;
};

std::vector<Drive> drives() {
    const auto smooth = [](double t, double from, double to) {
        const double x = std::clamp((t - from) / (to - from), 0.0, 1.0);
        return x * x * (3 - 2 * x);
    };
    return {{"slalom at 25 m/s", 25,
             [=](double t, const VehicleInput& start) {
                 VehicleInput in = start;
                 in.steering_wheel_angle = 0.8 * smooth(t, 0, 0.5) * std::sin(3 * t);
                 return in;
             },
             4},
            {"full throttle, then braking in a turn", 15,
             [=](double t, const VehicleInput& start) {
                 VehicleInput in = start;
                 in.throttle += (1 - in.throttle) * smooth(t, 0, 0.5) - smooth(t, 2.5, 2.8);
                 in.throttle = std::clamp(in.throttle, 0.0, 1.0);
                 in.brake = 0.4 * smooth(t, 3, 3.4);
                 in.clutch = smooth(t, 2.7, 3);
                 in.steering_wheel_angle = 0.5 * smooth(t, 1, 2);
                 return in;
             },
             5}};
}

TEST(WholeDrive, RoadForcesChangeTheMomentumAsNewtonAndEulerSay) {
    for (const VehicleParams& shipped : cars()) {
        const VehicleParams params = withoutAir(shipped);
        for (const Drive& drive : drives()) {
            const PlaneRoad road;
            reference::Car car = reference::settled(params, road, {.speed = drive.speed});
            const VehicleInput start = car.input;
            const auto force = [&] {
                Vector3 sum = params.mass * car.gravity_W;
                for (std::size_t i = 0; i < kWheels; ++i) sum += reference::roadForce(car, i).force_W;
                return sum;
            };
            const auto momentum = [&] {
                const Vector3 up = car.motion.orientation * Vector3::UnitZ();
                Vector3 p = params.mass * car.motion.velocity_W;
                for (std::size_t i = 0; i < kWheels; ++i) {
                    const WheelState& wheel = car.state.wheels[i];
                    p += car.vehicle.corners[i].unsprung_mass *
                         (wheel.rate * up + car.motion.angular_velocity_W.cross(wheel.travel * up));
                }
                return p;
            };
            const Vector3 before = momentum();
            Vector3 impulse = Vector3::Zero(), last = force();
            double moved = 0;
            for (double t = kStep; t < drive.duration; t += kStep) {
                car.step(drive.driver(t, start), kStep);
                const Vector3 now = force();
                impulse += 0.5 * kStep * (last + now);
                last = now;
                moved = std::max(moved, (momentum() - before).norm());
            }
            const double error = (momentum() - before - impulse).norm();
            std::printf("%s, %s: impulse of the road and change of momentum differ by %.2f N s of %.0f N s\n",
                        params.name.c_str(), drive.name, error, moved);
            EXPECT_LT(error, 2e-4 * moved);
        }
    }
}

double kineticAndPotential(const reference::Car& car) {
    const VehicleParams& params = car.vehicle.params;
    const Eigen::Matrix3d body = car.motion.orientation.toRotationMatrix();
    const Vector3 v = body.transpose() * car.motion.velocity_W;
    const Vector3 w = body.transpose() * car.motion.angular_velocity_W;
    const DrivelineState& drive = car.state.driveline;
    const GearboxParams& box = params.driveline.gearbox;
    double sum = 0.5 * params.mass * v.squaredNorm() + params.mass * kStandardGravity * car.motion.position_W.z() +
                 0.5 * (params.inertia.roll * w.x() * w.x() + params.inertia.pitch * w.y() * w.y() +
                        params.inertia.yaw * w.z() * w.z()) +
                 0.5 * params.driveline.engine->inertia * drive.engine_speed * drive.engine_speed +
                 0.5 * box.inertia * drive.gearbox_speed * drive.gearbox_speed +
                 0.5 * params.driveline.shaft_stiffness * drive.twist * drive.twist;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const AxleParams& axle = i < 2 ? params.front : params.rear;
        const WheelState& wheel = car.state.wheels[i];
        const Vehicle::Corner& corner = car.vehicle.corners[i];
        const TyreCoefficients& p = axle.tyre.parameters;
        const Vector3 there = corner.hub_B + Vector3(0, 0, wheel.travel);
        const Vector3 hub = v + w.cross(there) + Vector3(0, 0, wheel.rate);
        sum += 0.5 * corner.unsprung_mass * (hub.squaredNorm() - (v + w.cross(corner.hub_B)).squaredNorm());
        sum += corner.unsprung_mass * kStandardGravity * wheel.travel * body(2, 2);
        sum += 0.5 * corner.wheel_inertia * wheel.spin * wheel.spin;
        const double force = std::max(corner.static_force + axle.suspension.spring * wheel.travel, 0.0);
        sum += 0.5 * force * force / axle.suspension.spring;
        sum += 0.5 * p.pz1 * std::pow(std::max(p.Ro - wheel.radius, 0.0), 2);
        sum += 0.5 * p.cFx * wheel.tyre.u * wheel.tyre.u + 0.5 * p.cFy * wheel.tyre.v * wheel.tyre.v;
        if (i % 2 == 0) {
            const double twist = wheel.travel - car.state.wheels[i + 1].travel;
            sum += 0.5 * axle.suspension.anti_roll_bar * twist * twist;
        }
    }
    return sum;
}

// What goes in and what is lost, W: engine, gearbox and clutch, brakes, dampers, tyres, air.
struct Power {
    double engine = 0, clutch = 0, gearbox = 0, shafts = 0, brakes = 0, dampers = 0, tyres = 0, air = 0;
    double net() const { return engine - clutch - gearbox - shafts - brakes - dampers - tyres - air; }
};

Power power(const reference::Car& car) {
    const VehicleParams& params = car.vehicle.params;
    const GearboxParams& box = params.driveline.gearbox;
    const DrivelineState& drive = car.state.driveline;
    Power power;
    power.engine = car.state.engine_torque * drive.engine_speed;
    const double ratio = box.ratios[static_cast<std::size_t>(drive.gear - 1)] * box.final_drive;
    double shaft = 0, spin = 0;
    for (std::size_t i = 0; i < kWheels; ++i) {
        const WheelState& wheel = car.state.wheels[i];
        const SuspensionParams& s = i < 2 ? params.front.suspension : params.rear.suspension;
        shaft += wheel.drive_torque;
        const double share = i < 2 ? params.driveline.front_share : 1 - params.driveline.front_share;
        spin += 0.5 * share * wheel.spin;
        if (wheel.spin != 0) power.brakes += wheel.brake_torque * std::abs(wheel.spin);
        power.dampers += (wheel.rate > 0 ? s.damper.bump : s.damper.rebound) * wheel.rate * wheel.rate;

        // The tyre: what the road does on the rim, less what the rim does; slip, rolling resistance, aligning torque.
        const TyreMotion& m = wheel.motion;
        const TyreCoefficients& p = car.vehicle.corners[i].tyre.parameters;
        const double yaw = car.motion.angular_velocity_W.z();
        power.tyres += -wheel.fx * (m.Vx - wheel.radius * wheel.spin) + wheel.fy * m.Vsy - wheel.mz * yaw;
        power.tyres += p.qy1 * wheel.load * 2 / std::numbers::pi * std::atan(p.Re * wheel.spin) * wheel.spin;
        power.tyres += p.pz2 * wheel.rate * wheel.rate;
    }
    // The shafts' damping, and the gearbox: it takes more (or gives less) than what the shafts carry.
    const double shaft_rate = drive.gearbox_speed / ratio - spin;
    power.shafts = params.driveline.shaft_damping * shaft_rate * shaft_rate;
    const double loss = shaft * drive.gearbox_speed > 0 ? box.efficiency : 1 / box.efficiency;
    power.gearbox = shaft / ratio * drive.gearbox_speed * (1 / loss - 1);
    const AeroForces air = forces(params.aero, car.motion.orientation.conjugate() * car.motion.velocity_W);
    power.air = -air.drag_B.dot(car.motion.orientation.conjugate() * car.motion.velocity_W);
    return power;
}

TEST(WholeDrive, WorkOfTheEngineIsFoundAgain) {
    for (const VehicleParams& params : cars()) {
        for (const Drive& drive : drives()) {
            const PlaneRoad road;
            reference::Car car = reference::settled(params, road, {.speed = drive.speed});
            const VehicleInput start = car.input;
            const double before = kineticAndPotential(car);
            Power work, last = power(car);
            double turnover = 0, lowest = before, highest = before;
            for (double t = kStep; t < drive.duration; t += kStep) {
                car.step(drive.driver(t, start), kStep);
                const Power now = power(car);
                const auto add = [&](double Power::*part) { work.*part += 0.5 * kStep * (last.*part + now.*part); };
                for (double Power::*part : {&Power::engine, &Power::gearbox, &Power::shafts, &Power::brakes,
                                            &Power::dampers, &Power::tyres, &Power::air})
                    add(part);
                last = now;
                const double energy = kineticAndPotential(car);
                lowest = std::min(lowest, energy);
                highest = std::max(highest, energy);
            }
            turnover = std::max({highest - lowest, work.engine, work.brakes, work.tyres});
            const double change = kineticAndPotential(car) - before;
            const double missing = work.net() - change;
            std::printf(
                "%s, %s [kJ]: engine %.2f, gearbox %.2f, brakes %.2f, dampers %.2f, tyres %.2f, air %.2f; change of "
                "energy %.2f, unaccounted %.3f (%.2f %% of the turnover)\n",
                params.name.c_str(), drive.name, work.engine / 1e3, work.gearbox / 1e3, work.brakes / 1e3,
                work.dampers / 1e3, work.tyres / 1e3, work.air / 1e3, change / 1e3, missing / 1e3,
                100 * missing / turnover);
            EXPECT_LT(std::abs(missing), 0.01 * turnover);
            EXPECT_GT(work.dampers, 0);
            EXPECT_GT(work.tyres, 0);
        }
    }
}

}  // namespace
}  // namespace tread::vehicle_driving_test
