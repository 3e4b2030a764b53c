// Checks of channels against each other. Kinematic relations reveal wrong signs and units, swapped channels and delays.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "compare/time_shift.h"
#include "recording/checks/log_checks.h"

namespace tread::recording::checks {
namespace {

constexpr double kLongestDelay = 0.2;     // s, range of the search
constexpr double kDelay = 0.025;          // s; shorter delays are not reported
constexpr double kDelayOfSideslip = 0.1;  // s; sideslip can make lateral acceleration look late by this much
constexpr double kMuchLikelier = 3;       // factor by which a reported delay reduces the unexplained variance
constexpr double kUnlike = 0.02;          // least share of the variance that must be unexplained without the delay
constexpr double kBraking = 1.5;          // m/s2
constexpr double kFactor = 0.25;          // relative difference that wheel slip cannot explain
constexpr double kMuch = 1.5;             // relative difference that no car can explain

using Values = std::vector<double>;

struct Pair {
    std::string channel;  // channel that a warning names
    std::string says;     // what it is compared with
    const Values* measured;
    Values expected;
    double least;              // least standard deviation of the expected values for a conclusion
    double tolerance = kMuch;  // relative difference in size that is not reported; 0: size is not checked
    double delay = 0;          // s, delay that is not reported; 0: delay is not checked
};

Values derivative(const Values& time, const Values& values) {
    constexpr std::size_t kReach = 5;  // samples on either side, to suppress noise
    Values rates(values.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t a = i > kReach ? i - kReach : 0, b = std::min(i + kReach, values.size() - 1);
        if (b > a) rates[i] = (values[b] - values[a]) / (time[b] - time[a]);
    }
    return rates;
}

Values product(const Values& a, const Values& b, double factor = 1) {
    Values out(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) out[i] = factor * a[i] * b[i];
    return out;
}

std::string lookOf(double factor) {
    const auto near = [&](double known) {
        return std::abs(factor / known - 1) < 0.12 || std::abs(factor * known - 1) < 0.12;
    };
    if (near(9.80665)) return ", as if one of them were in g";
    if (near(180 / std::numbers::pi)) return ", as if one of them were in degrees";
    if (near(3.6)) return ", as if one of them were in km/h";
    return "";
}

// Share of the measured variance that the expected values leave unexplained when delayed by `later` samples.
double unlikeness(const Pair& pair, std::ptrdiff_t later) {
    const Values &x = pair.expected, &y = *pair.measured;
    const auto size = static_cast<std::ptrdiff_t>(x.size());
    Values a, b;
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, later); i < std::min(size, size + later); ++i) {
        a.push_back(x[static_cast<std::size_t>(i - later)]);
        b.push_back(y[static_cast<std::size_t>(i)]);
    }
    const double correlation = relation(a, b).correlation;
    return 1 - correlation * correlation;
}

void checkDelay(const LogChecks& checks, Pair pair) {
    // Under braking sideslip adds to vx times yaw rate, which looks like a delay, so these samples are set to 0.
    Values measured_values = *pair.measured;
    if (pair.channel == "chassis.ay") {
        const Values rates = derivative(checks.time(), *checks.values("chassis.vx"));
        for (std::size_t i = 0; i < rates.size(); ++i) {
            if (std::abs(rates[i]) > kBraking) measured_values[i] = pair.expected[i] = 0;
        }
        pair.measured = &measured_values;
    }
    const Log expected{{{"time", "s", checks.time()}, {"x", "", pair.expected}}};
    const Log measured{{{"time", "s", checks.time()}, {"x", "", *pair.measured}}};
    const auto shift = estimateTimeShift(expected, measured, "x", kLongestDelay);
    if (!shift || std::abs(*shift) < pair.delay) return;
    const double now = unlikeness(pair, 0), shifted = unlikeness(pair, std::lround(*shift * checks.rate()));
    if (now < kUnlike || now < kMuchLikelier * shifted) return;
    checks.warn(pair.channel,
                fmt::format("{} by {:.0f} ms relative to {}", *shift > 0 ? "is late" : "is early",
                            1000 * std::abs(*shift), pair.says),
                "A delay between channels looks like a lag of the car",
                "Specify the delay of the later channel (instruments, or delay in the import mapping)");
}

void check(const LogChecks& checks, const Pair& pair) {
    const Values* vx = checks.values("chassis.vx");
    const Relation r =
        relation(pair.expected, *pair.measured, [&](std::size_t i) { return !vx || (*vx)[i] > LogChecks::kMoving; });
    if (r.samples < Relation::kFewest || r.spread < pair.least) return;
    if (r.correlation < -Relation::kCorrelated) {
        checks.warn(pair.channel,
                    fmt::format("has the opposite sign of {} (correlation {:.2f})", pair.says, r.correlation),
                    "A channel with the wrong sign cannot be compared with the model",
                    "Reverse the sign on import: ISO 8855, x forward, y left, z up");
        return;
    }
    if (r.correlation < Relation::kCorrelated) return;
    const double factor = std::abs(r.factor);
    const std::string look = lookOf(factor);
    if (pair.tolerance > 0 && (!look.empty() || std::abs(std::log(factor)) > std::log1p(pair.tolerance))) {
        checks.warn(pair.channel, fmt::format("is {:.3g} times {}{}", factor, pair.says, look),
                    "A wrong unit or scale factor is taken for a difference of the car",
                    "Check the units of both signals (channels, import)");
    }
    if (pair.delay > 0) checkDelay(checks, pair);
}

std::vector<Pair> pairsOf(const LogChecks& checks) {
    const auto get = [&](const char* channel) { return checks.values(channel); };
    const Values *vx = get("chassis.vx"), *ax = get("chassis.ax"), *ay = get("chassis.ay"),
                 *yaw_rate = get("chassis.yaw_rate"), *steer = get("driver.steering_wheel_angle");
    const VehicleParams& car = checks.nominal.vehicle;
    std::vector<Pair> pairs;
    const auto add = [&](Pair pair) { pairs.push_back(std::move(pair)); };
    if (vx && yaw_rate && ay) {
        Values expected = product(*vx, *yaw_rate);
        const Values* vy = get("chassis.vy");
        const Values sideways = vy ? derivative(checks.time(), *vy) : Values(expected.size(), 0);
        for (std::size_t i = 0; i < expected.size(); ++i) expected[i] += sideways[i];
        add({"chassis.ay", vy ? "vx times yaw rate plus the derivative of vy" : "vx times yaw rate", ay, expected, 0.4,
             kMuch, vy ? kDelay : kDelayOfSideslip});
    }
    if (vx && ax) add({"chassis.ax", "the derivative of vx", ax, derivative(checks.time(), *vx), 0.4, kMuch, kDelay});
    if (yaw_rate && get("chassis.yaw"))
        add({"chassis.yaw_rate", "the derivative of the heading", yaw_rate,
             derivative(checks.time(), *get("chassis.yaw")), 0.05, kMuch, kDelay});
    if (ay && get("chassis.roll")) add({"chassis.roll", "ay", get("chassis.roll"), *ay, 0.5, 0});
    if (get("chassis.roll") && get("chassis.roll_rate"))
        add({"chassis.roll_rate", "the derivative of the roll angle", get("chassis.roll_rate"),
             derivative(checks.time(), *get("chassis.roll")), 0.02, kMuch, kDelay});
    if (vx && get("chassis.vy") && get("chassis.sideslip")) {
        Values expected = *get("chassis.vy");
        for (std::size_t i = 0; i < expected.size(); ++i)
            expected[i] = std::atan2(expected[i], std::max((*vx)[i], 0.1));
        add({"chassis.sideslip", "the sideslip angle from vy and vx", get("chassis.sideslip"), std::move(expected),
             0.005});
    }
    for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"}) {
        const std::string channel = std::string("wheel.") + wheel + ".spin";
        const Values* spin = checks.values(channel);
        const double radius = (wheel[0] == 'f' ? car.front : car.rear).tyre.parameters.Re;
        if (vx && spin) {
            Values expected = *vx;
            for (double& value : expected) value /= radius;
            add({channel, "vx divided by the rolling radius", spin, std::move(expected), 0.5, kFactor});
        }
    }
    if (steer && (yaw_rate || ay))
        add({"driver.steering_wheel_angle", yaw_rate ? "the yaw rate" : "ay", steer, yaw_rate ? *yaw_rate : *ay,
             yaw_rate ? 0.03 : 0.5, 0});
    return pairs;
}

// Checks that the outer wheel is the faster one in a turn.
void checkSwappedWheels(const LogChecks& checks) {
    const Values* yaw_rate = checks.values("chassis.yaw_rate");
    for (const char* axle : {"front", "rear"}) {
        const std::string left = fmt::format("wheel.{}_left.spin", axle),
                          right = fmt::format("wheel.{}_right.spin", axle);
        const Values *l = checks.values(left), *r = checks.values(right), *ax = checks.values("chassis.ax");
        if (!yaw_rate || !l || !r) continue;
        Values difference(l->size());
        for (std::size_t i = 0; i < l->size(); ++i) difference[i] = (*r)[i] - (*l)[i];
        const Relation turn = relation(*yaw_rate, difference,
                                       [&](std::size_t i) { return !ax || std::abs((*ax)[i]) < LogChecks::kSliding; });
        if (turn.samples < Relation::kFewest || turn.spread < 0.05 || turn.correlation > -Relation::kCorrelated)
            continue;
        checks.warn(left + " and " + right, "the inner wheel is the faster one in turns, so left and right are swapped",
                    "Differential locking and left-right grip differences would be found on the wrong side",
                    "Swap the two channels on import");
    }
}

// Checks whether longitudinal and lateral acceleration are exchanged.
void checkSwappedAccelerations(const LogChecks& checks) {
    const Values *vx = checks.values("chassis.vx"), *ax = checks.values("chassis.ax"),
                 *ay = checks.values("chassis.ay"), *yaw_rate = checks.values("chassis.yaw_rate");
    if (!vx || !ax || !ay || !yaw_rate) return;
    const Values lateral = product(*vx, *yaw_rate);
    const Relation crossed = relation(lateral, *ax), straight = relation(lateral, *ay);
    if (crossed.samples < Relation::kFewest || crossed.spread < 0.4 ||
        std::abs(crossed.correlation) < Relation::kCorrelated)
        return;
    if (std::abs(straight.correlation) > 0.5 * std::abs(crossed.correlation)) return;
    checks.warn("chassis.ax and chassis.ay", "ax follows vx times yaw rate and ay does not, so they are swapped",
                "The model would appear wrong in both directions", "Swap the two channels on import");
}

}  // namespace

Relation relation(const Values& x, const Values& y, const std::function<bool(std::size_t)>& use) {
    double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        if (!use(i) || !std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
        n += 1;
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        syy += y[i] * y[i];
        sxy += x[i] * y[i];
    }
    if (n < 2) return {};
    const double vx = sxx / n - sx * sx / (n * n), vy = syy / n - sy * sy / (n * n), c = sxy / n - sx * sy / (n * n);
    const double factor = sxx > 0 ? sxy / sxx : 0;
    if (!(vx > 0) || !(vy > 0)) return {0, 0, factor, std::sqrt(std::max(vx, 0.0)), static_cast<int>(n)};
    return {c / std::sqrt(vx * vy), c / vx, factor, std::sqrt(vx), static_cast<int>(n)};
}

void checkKinematics(const LogChecks& checks) {
    for (const Pair& pair : pairsOf(checks)) check(checks, pair);
    checkSwappedWheels(checks);
    checkSwappedAccelerations(checks);
}

}  // namespace tread::recording::checks
