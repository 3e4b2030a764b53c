// Checks of channels against each other. Kinematic relations reveal wrong signs and units and swapped channels. A
// finding must hold in the whole recording and in its gentler half, because in a spin, a drift, or with locked or
// spinning wheels sound channels break these relations.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/math/median.h"
#include "log/direction.h"
#include "recording/checks/log_checks.h"
#include "recording/checks/rigid_body.h"

namespace tread::recording::checks {
namespace {

constexpr double kRolling = 1;    // m/s2; at a larger change of speed, wheels may slip
constexpr double kFactor = 0.25;  // relative difference between a rolling wheel and the speed that tyres can explain
constexpr double kMuch = 1.5;     // relative difference that no car can explain

using Values = std::vector<double>;
using Use = std::function<bool(std::size_t)>;

struct Pair {
    std::string channel;  // channel that a warning names
    std::string other;    // the channel whose sign is compared with its own
    std::string says;     // what it is compared with
    const Values* measured;
    Values expected;
    double least;              // least standard deviation of the expected values for a conclusion
    double tolerance = kMuch;  // relative difference in size that is not reported; 0: size is not checked
    Use use = [](std::size_t) { return true; };
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

Values product(const Values& a, const Values& b) {
    Values out(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] * b[i];
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

// The pair over the samples that may be used, and over the gentler half of them. `clear`: both show the same quantity.
struct Related {
    Relation all, gentle;
    bool clear = false;
    double sign() const { return all.correlation < 0 ? -1 : 1; }
};

Related related(const LogChecks& checks, const Pair& pair) {
    const Values* vx = checks.values("chassis.vx");
    const Use moving = [&](std::size_t i) { return pair.use(i) && (!vx || (*vx)[i] > LogChecks::kMoving); };
    Values sizes;
    for (std::size_t i = 0; i < pair.expected.size(); ++i)
        if (moving(i)) sizes.push_back(std::abs(pair.expected[i]));
    const double middle = median(std::move(sizes));
    Related found{relation(pair.expected, *pair.measured, moving),
                  relation(pair.expected, *pair.measured,
                           [&](std::size_t i) { return moving(i) && std::abs(pair.expected[i]) <= middle; })};
    const auto shows = [](const Relation& r, double correlation) {
        return r.samples >= Relation::kFewest && std::abs(r.correlation) > correlation;
    };
    // Noise has more weight in the gentler half.
    found.clear = shows(found.all, Relation::kCorrelated) && found.all.spread >= pair.least &&
                  shows(found.gentle, 0.5 * Relation::kCorrelated) &&
                  found.all.correlation * found.gentle.correlation > 0;
    return found;
}

void checkSize(const LogChecks& checks, const Pair& pair, const Related& found) {
    if (!found.clear || found.sign() < 0 || pair.tolerance == 0) return;
    const double factor = std::abs(found.all.factor), gentle = std::abs(found.gentle.factor);
    const auto off = [&](double one) { return std::abs(std::log(one)) > std::log1p(pair.tolerance); };
    const std::string look = lookOf(factor);
    if (look.empty() ? !(off(factor) && off(gentle)) : look != lookOf(gentle) && !off(gentle)) return;
    checks.warn(pair.channel, fmt::format("is {:.3g} times {}{}", factor, pair.says, look),
                "A wrong unit or scale factor is mistaken for a difference between car and model",
                "Check the units of both signals (channels, import)");
}

// The wrong one of two channels with opposite signs is the one that disagrees with more of its other partners.
void checkSigns(const LogChecks& checks, const std::vector<Pair>& pairs, const std::vector<Related>& found) {
    std::map<std::string, int> votes;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!found[i].clear) continue;
        for (const std::string& member : {pairs[i].channel, pairs[i].other})
            votes[member] += found[i].sign() < 0 ? 1 : -1;
    }
    std::map<std::string, std::size_t> named;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (!found[i].clear || found[i].sign() > 0) continue;
        const bool other = votes[pairs[i].other] > votes[pairs[i].channel];
        named.emplace(other ? pairs[i].other : pairs[i].channel, i);
    }
    for (const auto& [channel, i] : named) {
        const Pair& pair = pairs[i];
        const bool either = votes[pair.channel] == votes[pair.other];
        const std::string partner = channel == pair.channel ? pair.says : pair.channel;
        checks.warn(channel,
                    fmt::format("has the opposite sign of {} (correlation {:.2f})", partner, found[i].all.correlation),
                    "A channel with the wrong sign cannot be compared with the model",
                    either ? fmt::format("Reverse the sign of {} or of {} on import: no other channel shows which is "
                                         "wrong. ISO 8855, x forward, y left, z up",
                                         pair.channel, pair.other)
                           : "Reverse the sign on import: ISO 8855, x forward, y left, z up");
    }
}

class Pairs {
public:
    explicit Pairs(const LogChecks& checks)
        : checks_(checks),
          vx_(checks.values("chassis.vx")),
          yaw_rate_(checks.values("chassis.yaw_rate")),
          ay_(checks.values("chassis.ay")) {}

    std::vector<Pair> all() {
        accelerations();
        angles();
        wheels();
        steering();
        return std::move(pairs_);
    }

private:
    const Values* get(const std::string& channel) const { return checks_.values(channel); }
    void add(Pair pair) { pairs_.push_back(std::move(pair)); }

    void accelerations() {
        if (vx_ && yaw_rate_ && ay_) {
            Values expected = product(*vx_, *yaw_rate_);
            const Values* vy = get("chassis.vy");
            const Values sideways = vy ? derivative(checks_.time(), *vy) : Values(expected.size(), 0);
            for (std::size_t i = 0; i < expected.size(); ++i) expected[i] += sideways[i];
            add({"chassis.ay", "chassis.yaw_rate",
                 vy ? "vx times yaw rate plus the derivative of vy" : "vx times yaw rate", ay_, std::move(expected),
                 0.4});
        }
        if (const Values* ax = get("chassis.ax"); vx_ && ax)
            add({"chassis.ax", "chassis.vx", "the derivative of vx", ax, derivative(checks_.time(), *vx_), 0.4});
    }

    void angles() {
        const Values *roll = get("chassis.roll"), *roll_rate = get("chassis.roll_rate"), *yaw = get("chassis.yaw"),
                     *vy = get("chassis.vy"), *sideslip = get("chassis.sideslip");
        if (yaw_rate_ && yaw)
            add({"chassis.yaw_rate", "chassis.yaw", "the derivative of the heading", yaw_rate_,
                 derivative(checks_.time(), continuous(*yaw)), 0.05});
        if (ay_ && roll) add({"chassis.roll", "chassis.ay", "ay", roll, *ay_, 0.5, 0});
        if (roll && roll_rate)
            add({"chassis.roll_rate", "chassis.roll", "the derivative of the roll angle", roll_rate,
                 derivative(checks_.time(), *roll), 0.02});
        if (!vx_ || !vy || !sideslip) return;
        Values expected = *vy;
        for (std::size_t i = 0; i < expected.size(); ++i)
            expected[i] = std::atan2(expected[i], std::max((*vx_)[i], 0.1));
        add({"chassis.sideslip", "chassis.vy", "the sideslip angle from vy and vx", sideslip, std::move(expected),
             0.005});
    }

    // Wheels tell about units only where they roll: neither braked nor driven much.
    void wheels() {
        const Values change = vx_ ? derivative(checks_.time(), *vx_) : Values{};
        for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"}) {
            const std::string channel = std::string("wheel.") + wheel + ".spin";
            const Values* spin = get(channel);
            const VehicleParams& car = checks_.nominal.vehicle;
            if (!vx_ || !spin) continue;
            Values expected = *vx_;
            for (double& value : expected) value /= (wheel[0] == 'f' ? car.front : car.rear).tyre.parameters.Re;
            add({channel, "chassis.vx", "vx divided by the rolling radius", spin, std::move(expected), 0.5, kFactor,
                 [change](std::size_t i) { return std::abs(change[i]) < kRolling; }});
        }
    }

    // Beyond the grip of the front tyres a driver may steer against the turn.
    void steering() {
        const Values* steer = get("driver.steering_wheel_angle");
        if (!steer) return;
        if (yaw_rate_)
            add({"driver.steering_wheel_angle", "chassis.yaw_rate", "the yaw rate", steer, *yaw_rate_, 0.03, 0,
                 [vx = vx_, r = yaw_rate_](std::size_t i) {
                     return !vx || std::abs((*vx)[i] * (*r)[i]) < LogChecks::kSliding;
                 }});
        if (ay_)
            add({"driver.steering_wheel_angle", "chassis.ay", "ay", steer, *ay_, 0.5, 0,
                 [ay = ay_](std::size_t i) { return std::abs((*ay)[i]) < LogChecks::kSliding; }});
    }

    const LogChecks& checks_;
    const Values *vx_, *yaw_rate_, *ay_;
    std::vector<Pair> pairs_;
};

// What the channels say as motion of one rigid body. A sign or a unit that is wrong is left to the checks above.
void checkRigidBody(const LogChecks& checks) {
    constexpr double kWrongUnit = 0.5;  // relative error of a gain
    const std::vector<Agreement> all = agreements(checks.log, checks.nominal.instruments);
    for (const Agreement& one : all) {
        const bool wrong_unit = std::any_of(one.errors.begin(), one.errors.end(), [](const InstrumentError& error) {
            return error.kind == InstrumentError::Kind::gain && std::abs(error.size) > kWrongUnit;
        });
        if (wrong_unit) continue;
        if (one.contradicts) {
            checks.warn(one.channel, toText(one),
                        "No rigid body can move like this, so at least one of the channels is wrong",
                        fmt::format("Check {}, which is the least certain of them", oddChannel(all)));
        } else if (!one.errors.empty()) {
            const InstrumentError& error = one.errors.front();
            const bool delay = error.kind == InstrumentError::Kind::delay;
            checks.warn(one.channel, toText(one), "Such an error looks like a difference between car and model",
                        fmt::format("If the instrument causes it, state it (instruments{})",
                                    delay ? fmt::format(", {} delay: {:.3f}", error.channel, error.size) : ""));
        }
    }
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
    const std::vector<Pair> pairs = Pairs(checks).all();
    std::vector<Related> found;
    for (const Pair& pair : pairs) found.push_back(related(checks, pair));
    for (std::size_t i = 0; i < pairs.size(); ++i) checkSize(checks, pairs[i], found[i]);
    checkSigns(checks, pairs, found);
    checkSwappedWheels(checks);
    checkSwappedAccelerations(checks);
    checkRigidBody(checks);
}

}  // namespace tread::recording::checks
