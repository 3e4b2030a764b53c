// Steady-state cornering, after ISO 4138: constant radius, constant speed or constant steering angle.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kCircleHalfWidth = 0.5;       // s; everything changes slowly here
constexpr double kLowestAy = 0.1 * kGravity;   // below, offsets and play count for more than the car
constexpr double kHighestAy = 0.4 * kGravity;  // the end of the linear range of most cars ...
constexpr double kHighestShare = 0.6;          // ... and of those that grip less, of their largest ay
constexpr double kLeastSpan = 0.5;             // m/s2 between the slowest and the fastest turn
constexpr std::size_t kFewestSamples = 10;
constexpr double kFastestSteering = 0.6;  // rad/s; the slowly increasing steer has 0.24
constexpr std::size_t kMostSwings = 4;    // of the whole steering; a left and a right turn have up to four
constexpr double kSlowestCircle = 0.5;    // m/s; a car of scale 1:10 corners at 0.1 g from 0.6 m/s on
constexpr double kHeldSpeed = 0.03;       // standard deviation over mean of a speed that is held

enum class Method { constant_radius = 1, constant_speed = 2, constant_steering = 3 };

struct Circle {
    TimeSeries steering, v, yaw_rate, ay;
    std::optional<TimeSeries> brake;
    std::vector<std::vector<std::size_t>> turns;  // samples for the regressions, one list per direction driven
};

std::vector<std::size_t> samplesOfTurn(const Circle& circle, double direction) {
    double largest = 0;
    for (std::size_t i = 0; i < circle.ay.size(); ++i) largest = std::max(largest, direction * circle.ay.value[i]);
    const double high = std::min(kHighestAy, kHighestShare * largest);
    std::vector<std::size_t> samples;
    double least = high, most = 0;
    for (std::size_t i = 0; i < circle.ay.size(); ++i) {
        const double ay = direction * circle.ay.value[i];
        if (ay < kLowestAy || ay > high || circle.v.value[i] < kSlowestCircle) continue;
        if (circle.brake && circle.brake->value[i] > kRestingFoot) continue;
        samples.push_back(i);
        least = std::min(least, ay);
        most = std::max(most, ay);
    }
    if (samples.size() < kFewestSamples || most - least < kLeastSpan) return {};
    return samples;
}

Circle findCircle(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"});
    Circle circle{cleaned(needed[0], kCircleHalfWidth), cleaned(needed[1], kCircleHalfWidth),
                  cleaned(needed[2], kCircleHalfWidth), cleaned(needed[3], kCircleHalfWidth),
                  channelIfThere(log, "driver.brake"),  {}};
    // Changes of the steering that are too quick for a steady state are left out; a log made of them is refused.
    const TimeSeries rate = cleanDerivative(needed[0], kCircleHalfWidth);
    std::size_t all = 0, slow = 0;
    for (const double direction : {1.0, -1.0}) {
        auto samples = samplesOfTurn(circle, direction);
        all += samples.size();
        std::erase_if(samples, [&](std::size_t i) { return std::abs(rate.value[i]) > kFastestSteering; });
        slow += samples.size();
        if (!samples.empty()) circle.turns.push_back(samples);
    }
    if (all == 0) {
        notFound(
            fmt::format("expected a turn whose lateral acceleration covers at least {:.1f} m/s2 between "
                        "{:.1f} m/s2 and {:.0f} % of its largest value",
                        kLeastSpan, kLowestAy, 100 * kHighestShare));
    }
    if (slow < all / 2) {
        notFound(fmt::format("the steering moves faster than {:.0f} deg/s most of the time, expected slow changes",
                             kDegrees * kFastestSteering));
    }
    const auto swings = turningPoints(circle.steering, largestSample(circle.steering)).size();
    if (swings > kMostSwings) {
        notFound(fmt::format("the steering swings back and forth {} times, expected slow changes", swings));
    }
    return circle;
}

using Quantity = std::function<double(std::size_t)>;  // of a sample

// Standard deviation over mean, over all turns; magnitudes, so that left and right count alike.
double variation(const Circle& circle, const Quantity& quantity) {
    double n = 0, sum = 0, squares = 0;
    for (const auto& turn : circle.turns) {
        for (std::size_t i : turn) {
            const double value = std::abs(quantity(i));
            n += 1;
            sum += value;
            squares += value * value;
        }
    }
    return std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n))) / (sum / n);
}

// Slope of a quantity over lateral acceleration; mean of the directions driven, so that sensor offsets cancel.
double gradient(const Circle& circle, const Quantity& quantity) {
    double sum = 0;
    for (const auto& turn : circle.turns) {
        std::vector<double> x, y;
        for (std::size_t i : turn) {
            x.push_back(circle.ay.value[i]);
            y.push_back(quantity(i));
        }
        sum += fitLine(x, y).slope;
    }
    return sum / static_cast<double>(circle.turns.size());
}

double channelGradient(const Circle& circle, const std::optional<TimeSeries>& channel) {
    if (!channel) return kUndefined;
    const TimeSeries clean = cleaned(*channel, kCircleHalfWidth);
    return gradient(circle, [&](std::size_t i) { return clean.value[i]; });
}

Method methodOf(const Circle& circle) {
    const double radius =
        variation(circle, [&](std::size_t i) { return circle.yaw_rate.value[i] / circle.v.value[i]; });
    const double speed = variation(circle, [&](std::size_t i) { return circle.v.value[i]; });
    const double steering = variation(circle, [&](std::size_t i) { return circle.steering.value[i]; });
    if (speed < kHeldSpeed && speed < radius) return Method::constant_speed;
    return radius <= steering ? Method::constant_radius : Method::constant_steering;
}

std::optional<TimeSeries> roadWheelAngle(const Log& log, const Circle& circle, const KnownCar& car) {
    if (car.knowsRatio()) {
        TimeSeries road = circle.steering;
        for (double& angle : road.value) angle = car.roadWheelAngle(angle);
        return road;
    }
    auto road = frontLessRear(log, "steer");
    if (road) road = cleaned(*road, kCircleHalfWidth);
    return road;
}

// K = d(delta - L / R) / d ay, from the first of these that the log allows. rad per m/s2.
double understeer(const Log& log, const Circle& circle, const KnownCar& car, Method method) {
    const auto road = roadWheelAngle(log, circle, car);
    if (road && !std::isnan(car.wheelbase)) {
        return gradient(circle, [&](std::size_t i) {
            return road->value[i] - car.wheelbase * circle.yaw_rate.value[i] / circle.v.value[i];
        });
    }
    if (road && method == Method::constant_radius) {
        return gradient(circle, [&](std::size_t i) { return road->value[i]; });
    }
    // delta - L / R is also the front slip angle less the rear one, counted positive where the tyre pushes into the
    // turn.
    if (const auto slip = frontLessRear(log, "slip_angle")) {
        const TimeSeries front = *channelIfThere(log, "wheel.front_left.slip_angle");
        const double sign = gradient(circle, [&](std::size_t i) { return front.value[i]; }) < 0 ? -1 : 1;
        return sign * channelGradient(circle, slip);
    }
    return kUndefined;
}

// Means over the samples of the regression.
struct Means {
    double speed = 0;      // m/s
    double curvature = 0;  // 1/m
};

Means meansOf(const Circle& circle) {
    Means sum;
    double n = 0;
    for (const auto& turn : circle.turns) {
        for (std::size_t i : turn) {
            sum.speed += circle.v.value[i];
            sum.curvature += std::abs(circle.yaw_rate.value[i]) / circle.v.value[i];
            n += 1;
        }
    }
    return {sum.speed / n, sum.curvature / n};
}

struct SteadyCircle {
    Method method;
    Means means;
    double understeer, steering_wheel, roll, sideslip;  // gradients, rad per m/s2
    double largest_ay;                                  // m/s2
};

MetricTable<SteadyCircle> steadyCircleTable() {
    const std::string range = fmt::format("regression over {:.2g} to {:.2g} g, at most {:.0f} % of the largest",
                                          kLowestAy / kGravity, kHighestAy / kGravity, 100 * kHighestShare);
    constexpr double kPerG = kDegrees * kGravity;  // rad per m/s2 to deg per g
    return {
        {{"method", "Method (held: 1 radius, 2 speed, 3 steering)", "-",
          "what is held: 1 radius, 2 speed, 3 steering angle"},
         [](const SteadyCircle& s) { return static_cast<double>(s.method); }},
        {{"speed", "Speed, mean", "m/s", "mean over the samples of the regression"},
         [](const SteadyCircle& s) { return s.means.speed; }},
        {{"radius", "Radius", "m", "from the mean curvature yaw rate / speed of these samples"},
         [](const SteadyCircle& s) { return 1 / s.means.curvature; }},
        {{"understeer_gradient", "Understeer gradient", "deg/g",
          "d(road-wheel angle - wheelbase / radius) / d ay; " + range +
              "; undefined when neither wheelbase nor slip angles are known and the radius changes",
          Say{1, "understeer gradient {} deg/g", 2}},
         [](const SteadyCircle& s) { return kPerG * s.understeer; }},
        {{"steering_wheel_gradient", "Steering-wheel angle gradient", "deg/g",
          "d steering-wheel angle / d ay by the method; " + range + "; undefined when the steering wheel is held"},
         [](const SteadyCircle& s) { return kPerG * s.steering_wheel; }},
        {{"roll_gradient", "Roll gradient", "deg/g", "d roll angle / d ay; " + range,
          Say{2, "roll gradient {} deg/g", 2}},
         [](const SteadyCircle& s) { return kPerG * s.roll; }},
        {{"sideslip_gradient", "Sideslip gradient", "deg/g", "d sideslip angle / d ay by the method; " + range},
         [](const SteadyCircle& s) { return kPerG * s.sideslip; }},
        {{"largest_ay", "Lateral acceleration, maximum", "m/s2", "largest magnitude of the lateral acceleration",
          Say{3, "up to {} m/s2 of lateral acceleration", 2}},
         [](const SteadyCircle& s) { return s.largest_ay; }},
    };
}

SteadyCircle findSteadyCircle(const Log& log, const KnownCar& car) {
    const Circle circle = findCircle(log);
    const Method method = methodOf(circle);
    return {.method = method,
            .means = meansOf(circle),
            .understeer = understeer(log, circle, car, method),
            .steering_wheel = method == Method::constant_steering
                                  ? kUndefined
                                  : gradient(circle, [&](std::size_t i) { return circle.steering.value[i]; }),
            .roll = channelGradient(circle, channelIfThere(log, "chassis.roll")),
            .sideslip = channelGradient(circle, sideslip(log)),
            .largest_ay = largestSample(circle.ay)};
}

}  // namespace

Manoeuvre steadyCircle() {
    return {
        "steady_circle", "steady cornering: understeer, roll and sideslip gradients (after ISO 4138)",
        [] { return definitions(steadyCircleTable()); },
        [](const Log& log, const KnownCar& car) { return values(steadyCircleTable(), findSteadyCircle(log, car)); }};
}

}  // namespace tread
