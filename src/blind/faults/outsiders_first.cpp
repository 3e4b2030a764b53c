// First family: may be used to develop the diagnosis.

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

// A steering ratio that changes with the square of the steering-wheel angle.
void curveRatio(Truth& truth, Random& random) {
    SteeringParams& steering = truth.car.vehicle.steering;
    const double curvature =
        eitherSign(random) * between(random, 0.12, 0.25);  // relative change of the ratio at kAngle
    constexpr double kAngle = std::numbers::pi / 2;        // rad
    constexpr int kPoints = 24;
    for (int i = 0; i <= kPoints; ++i) {
        const double angle = 1.6 * kAngle * i / kPoints;
        const double share = angle / kAngle;
        steering.ratio_curve.points.push_back({angle, steering.ratio * (1 + curvature * share * share)});
    }
}

// An oscillating yaw moment, as from wind between buildings.
void gust(Truth& truth, Random& random) {
    const double amplitude = between(random, 300, 600);  // N m
    const double phase = 2 * std::numbers::pi * random.uniform();
    truth.push = [=] {
        return [=](double time, const VehicleInput&, const VehicleOutput&) {
            constexpr double kFrequency = 0.7;  // Hz
            return Push{.moment = {0, 0, amplitude * std::sin(2 * std::numbers::pi * kFrequency * time + phase)}};
        };
    };
}

// Wheel speeds of one axle that a control unit filters.
void lagWheelSpeeds(Truth& truth, Random& random) {
    const bool front = eitherSign(random) < 0;
    const double corner = between(random, 0.8, 1.5);  // Hz
    for (const char* side : {"left", "right"})
        truth.low_pass[std::string("wheel.") + (front ? "front_" : "rear_") + side + ".spin"] = corner;
}

// A bent rear axle: load transfer in a turn steers it to the same side whatever the direction of the turn.
void bendAxle(Truth& truth, Random& random) {
    const double per_acceleration = eitherSign(random) * between(random, 60, 120);  // N s2/m
    const double arm = truth.car.vehicle.wheelbase - truth.car.vehicle.front_axle_distance;
    truth.push = [=] {
        return [=](double, const VehicleInput&, const VehicleOutput& car) {
            const double force = per_acceleration * std::abs(car.chassis.ay);
            return Push{.force = {0, force, 0}, .moment = {0, 0, -arm * force}};
        };
    };
}

// Sloshing liquid: a mass on a lateral spring.
void slosh(Truth& truth, Random& random) {
    const double mass = between(random, 70, 130);                               // kg
    const double frequency = 2 * std::numbers::pi * between(random, 0.5, 0.8);  // rad/s
    const double above = between(random, 0.1, 0.3);                             // m above the centre of gravity
    truth.push = [=] {
        return [=, place = 0.0, rate = 0.0, last = 0.0](double time, const VehicleInput&,
                                                        const VehicleOutput& car) mutable {
            constexpr double kDamping = 0.08;
            const double dt = time - last;
            last = time;
            const double pull = frequency * frequency * place + 2 * kDamping * frequency * rate;  // m/s2
            rate += dt * (-pull - car.chassis.ay);
            place += dt * rate;
            return Push{.force = {0, mass * pull, 0}, .moment = {-above * mass * pull, 0, 0}};
        };
    };
}

}  // namespace

std::vector<Outsider> firstOutsiders() {
    using enum Family;
    return {
        {"cubic_steering_ratio",
         "the steering ratio changes with the angle squared",
         first,
         {"lateral", "yaw"},
         curveRatio},
        {"yaw_gust", "a yaw moment comes and goes at 0.7 Hz", first, {"yaw"}, gust},
        {"wheel_speed_lag", "the wheel speeds of one axle are filtered", first, {}, lagWheelSpeeds},
        {"bent_axle", "the rear axle steers to one side with every load shift", first, {"lateral", "yaw"}, bendAxle},
        {"sloshing_load", "a liquid load swings across the car", first, {"lateral", "roll", "yaw"}, slosh},
    };
}

}  // namespace tread::blind::faults
