// Second family: never used to develop the diagnosis, drawn only in a frozen check. Sizes are guesses of faults that
// would bring a driver to a workshop.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blind/faults/outsiders.h"
#include "blind/world/draws.h"
#include "tread/vehicle.h"

namespace tread::blind::faults {
namespace {

using key::Family;
using world::between;
using world::eitherSign;
using world::Truth;

// First-order lag from 0.
class Following {
public:
    explicit Following(double time_constant) : time_constant_(time_constant) {}
    double operator()(double input, double dt) {
        return value_ += (input - value_) * -std::expm1(-dt / time_constant_);
    }

private:
    double time_constant_;  // s
    double value_ = 0;
};

// Time since the previous call; 0 at the first.
class Clock {
public:
    double operator()(double time) {
        const double dt = begun_ ? time - last_ : 0;
        begun_ = true;
        last_ = time;
        return dt;
    }

private:
    bool begun_ = false;
    double last_ = 0;
};

double rearDistance(const VehicleParams& car) {
    return car.wheelbase - car.front_axle_distance;
}

// Torque steer by half shafts of different length: the drive torque leaves a net moment about the steering axes.
void steerByTorque(Truth& truth, Random& random) {
    const double per_torque =
        eitherSign(random) * between(random, 1.5, 3.5);  // N of lateral force per N m of engine torque
    const double front = truth.car.vehicle.front_axle_distance;
    truth.push = [=] {
        return [=, lagged = Following(0.1), clock = Clock()](double time, const VehicleInput&,
                                                             const VehicleOutput& car) mutable {
            const double torque = std::max(0.0, car.driveline.engine_torque + car.driveline.motor_torque);
            const double force = per_torque * lagged(torque, clock(time));
            return Push{.force = {0, force, 0}, .moment = {0, 0, front * force}};
        };
    };
}

// The collapsed hose of one front brake: its pressure lags.
void collapseHose(Truth& truth, Random& random) {
    const VehicleParams& car = truth.car.vehicle;
    const double side = eitherSign(random), late = between(random, 0.4, 1.0);  // s
    const double full =
        0.5 * car.brakes.front_share * car.brakes.full_pedal_torque / car.front.tyre.parameters.Re;  // N
    const double arm = side * car.front.track / 2;
    truth.push = [=] {
        return [=, pressure = Following(late), clock = Clock()](double time, const VehicleInput& driver,
                                                                const VehicleOutput&) mutable {
            const double missing = full * (driver.brake - pressure(driver.brake, clock(time)));
            return Push{.force = {missing, 0, 0}, .moment = {0, 0, -arm * missing}};
        };
    };
}

// A box in the middle of the boot with Coulomb friction on the floor, between two walls.
void loosenCargo(Truth& truth, Random& random) {
    const double mass = between(random, 60, 100);                       // kg
    const double grip = between(random, 0.18, 0.3) * kStandardGravity;  // m/s2
    const double behind = rearDistance(truth.car.vehicle) + 0.1;        // m
    constexpr double kRoom = 0.45, kWall = 20000, kDamping = 1500;      // m, N/m, N s/m
    truth.push = [=] {
        return [=, place = 0.0, rate = 0.0, clock = Clock()](double time, const VehicleInput&,
                                                             const VehicleOutput& car) mutable {
            const double dt = clock(time), ay = car.chassis.ay;
            const double over = std::abs(place) - kRoom;
            const double wall = over > 0 ? (-std::copysign(kWall * over, place) - kDamping * rate) / mass : 0;
            // In the frame of the car: friction that would stop the box in this step, limited by its grip.
            const double stop = dt > 0 ? -rate / dt - wall + ay : ay;
            const double hold = std::clamp(stop, -grip, grip);
            rate += dt * (wall + hold - ay);
            place += dt * rate;
            // The mass of the car already includes the box at rest in the middle.
            const double side = -mass * (wall + hold - ay);
            return Push{.force = {0, side, 0}, .moment = {-mass * kStandardGravity * place, 0, -behind * side}};
        };
    };
}

// A damper without oil on one wheel: it loses most of its force above a low velocity.
void drainDamper(Truth& truth, Random& random) {
    const bool front = random.uniform() < 0.5;
    const double side = eitherSign(random), gone = between(random, 0.8, 1.0);
    const double slow = between(random, 0.01, 0.03);  // m/s, below which friction of the seals still resists
    const VehicleParams& car = truth.car.vehicle;
    const AxleParams& axle = front ? car.front : car.rear;
    const double x = front ? car.front_axle_distance : -rearDistance(car), y = side * axle.track / 2;
    const double bump = axle.suspension.damper.bump, rebound = axle.suspension.damper.rebound;
    const std::size_t wheel = (front ? 0u : 2u) + (side > 0 ? 0u : 1u);
    truth.push = [=] {
        return [=, last = 0.0, clock = Clock()](double time, const VehicleInput&, const VehicleOutput& output) mutable {
            const double dt = clock(time), travel = output.wheel[wheel].travel;
            const double rate = dt > 0 ? (travel - last) / dt : 0;  // m/s, of compression
            last = travel;
            const double beyond = std::copysign(std::max(0.0, std::abs(rate) - slow), rate);
            const double force = -gone * (beyond > 0 ? bump : rebound) * beyond;  // N, up on the body
            return Push{.force = {0, 0, force}, .moment = {y * force, -x * force, 0}};
        };
    };
}

// Shimmy of the front wheels at their natural frequency, largest at the speed at which imbalance excites it.
void shimmy(Truth& truth, Random& random) {
    const double at = between(random, 21, 27), width = between(random, 1.5, 2.5);  // m/s
    const double amplitude = between(random, 400, 800);                            // N
    const double frequency = 2 * std::numbers::pi * between(random, 5, 7);         // rad/s
    const double front = truth.car.vehicle.front_axle_distance;
    truth.push = [=] {
        return [=](double time, const VehicleInput&, const VehicleOutput& car) {
            const double detuned = (car.chassis.vx - at) / width;
            const double force = amplitude / (1 + detuned * detuned) * std::sin(frequency * time);
            return Push{.force = {0, force, 0}, .moment = {0, 0, front * force}};
        };
    };
}

// A creeping bush of the rear axle: compliance steer that grows while a lateral force lasts.
void creepBush(Truth& truth, Random& random) {
    const VehicleParams& car = truth.car.vehicle;
    const double share = between(random, 0.06, 0.12);  // of the axle's lateral force that is lost in the steady state
    const double slowly = between(random, 1.5, 2.5);   // s, time constant
    const double behind = rearDistance(car), carried = car.mass * car.front_axle_distance / car.wheelbase;
    truth.push = [=] {
        return [=, yielded = Following(slowly), clock = Clock()](double time, const VehicleInput&,
                                                                 const VehicleOutput& output) mutable {
            const double lost = share * yielded(carried * output.chassis.ay, clock(time));
            return Push{.force = {0, -lost, 0}, .moment = {0, 0, behind * lost}};
        };
    };
}

// Worn links of the front anti-roll bar: no roll moment within their free play.
void slackenAntiRollBar(Truth& truth, Random& random) {
    const AxleParams& axle = truth.car.vehicle.front;
    const double play = between(random, 0.004, 0.008);                                 // rad of roll, to either side
    const double stiffness = axle.suspension.anti_roll_bar * axle.track * axle.track;  // N m/rad
    truth.push = [=] {
        return [=](double, const VehicleInput&, const VehicleOutput& car) {
            return Push{.moment = {stiffness * std::clamp(car.chassis.roll, -play, play), 0, 0}};
        };
    };
}

// Misfire under load: part of the drive force fails for short times.
void misfire(Truth& truth, Random& random) {
    const auto seed = static_cast<std::uint64_t>(0x1p52 * random.uniform());
    const double share = between(random, 0.4, 0.7), every = between(random, 0.8, 1.6);  // -, s
    constexpr double kLasts = 0.25, kLoad = 0.5;                                        // s, throttle (0 to 1)
    const double mass = truth.car.vehicle.mass;
    truth.push = [=] {
        return [=, own = Random(seed), next = 0.0, until = -1.0, fading = Following(0.03), clock = Clock()](
                   double time, const VehicleInput& driver, const VehicleOutput& car) mutable {
            for (; next <= time; next -= every * std::log(1 - own.uniform())) until = next + kLasts;
            const bool fails = time < until && driver.throttle > kLoad;
            const double pull = mass * std::max(0.0, car.chassis.ax);
            return Push{.force = {-fading(fails ? share * pull : 0, clock(time)), 0, 0}};
        };
    };
}

std::vector<double>* valuesOf(Log& log, std::string_view name) {
    const auto found = std::find_if(log.channels.begin(), log.channels.end(),
                                    [&](const Channel& channel) { return channel.name == name; });
    return found == log.channels.end() ? nullptr : &found->values;
}

// Accelerometers that compress large readings.
void compressAccelerometers(Truth& truth, Random& random) {
    const double range = between(random, 9, 13);  // m/s2, largest possible reading
    truth.misread = [=](Log& log, Random&) {
        for (const char* name : {"chassis.ax", "chassis.ay"}) {
            std::vector<double>* values = valuesOf(log, name);
            for (double& value : *values) value = range * std::tanh(value / range);
        }
    };
}

// A yaw-rate gyro whose zero drifts as it warms up in each drive.
void driftGyro(Truth& truth, Random& random) {
    const double most = eitherSign(random) * between(random, 0.006, 0.012);  // rad/s
    const double slowly = between(random, 4, 8);                             // s
    truth.misread = [=](Log& log, Random&) {
        const std::vector<double>& time = log.channels.front().values;
        std::vector<double>& yaw_rate = *valuesOf(log, "chassis.yaw_rate");
        for (std::size_t i = 0; i < time.size(); ++i) yaw_rate[i] -= most * std::expm1(-time[i] / slowly);
    };
}

// A satellite receiver that loses its fix: the speed reading freezes and then catches up.
void freezeSpeed(Truth& truth, Random& random) {
    const double every = between(random, 2.5, 4), catches_up = between(random, 0.2, 0.4);  // s
    truth.misread = [=](Log& log, Random& own) {
        const std::vector<double>& time = log.channels.front().values;
        std::vector<double>& shown = *valuesOf(log, "chassis.vx");
        const std::vector<double> speed = shown;
        const auto pause = [&] { return -every * std::log(1 - own.uniform()); };
        double begins = pause(), ends = begins + between(own, 0.6, 1.2), behind = 0;
        for (std::size_t i = 1; i < time.size(); ++i) {
            if (time[i] >= ends) begins = ends + pause(), ends = begins + between(own, 0.6, 1.2);
            if (time[i] >= begins) behind += speed[i] - speed[i - 1];
            else behind *= std::exp(-(time[i] - time[i - 1]) / catches_up);
            shown[i] = speed[i] - behind;
        }
    };
}

}  // namespace

std::vector<Outsider> secondOutsiders() {
    using enum Family;
    return {
        {"torque_steer", "the drive torque pulls the steering to one side", second, {"lateral", "yaw"}, steerByTorque},
        {"collapsed_brake_hose",
         "one front brake comes late with every braking",
         second,
         {"longitudinal", "yaw"},
         collapseHose},
        {"loose_cargo",
         "a box slides across the boot and stays there",
         second,
         {"lateral", "roll", "yaw"},
         loosenCargo},
        {"drained_damper", "one damper has lost its oil", second, {"roll"}, drainDamper},
        {"wheel_shimmy", "the front wheels flutter about one speed", second, {"lateral", "yaw"}, shimmy},
        {"creeping_bush", "the rear axle gives way slowly in long turns", second, {"lateral", "yaw"}, creepBush},
        {"slack_anti_roll_bar", "the front anti-roll bar has free play", second, {"roll"}, slackenAntiRollBar},
        {"misfire", "the engine fails for moments under load", second, {"longitudinal"}, misfire},
        {"compressed_accelerometers",
         "accelerometers show too little of what is large",
         second,
         {},
         compressAccelerometers},
        {"drifting_gyro", "the yaw-rate gyro drifts in each drive", second, {}, driftGyro},
        {"frozen_speed", "the speed over ground stands still for moments", second, {}, freezeSpeed},
    };
}

}  // namespace tread::blind::faults
