#include "import/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

namespace tread {
namespace {

constexpr double kSlowest = 3;       // m/s: below, a car can do anything
constexpr std::size_t kFewest = 50;  // samples
constexpr double kCorrelated = 0.7;  // from here two channels show the same thing
constexpr double kSwapped = 0.9;     // correlation from which channels in each other's place are believed
constexpr double kBetter = 0.02;     // by so much more it correlates in the right order
constexpr double kDegree = 180 / std::numbers::pi, kGravity = 9.80665;
constexpr double kTurning = 0.3;   // m/s2 of vx times yaw rate, rms: less is noise
constexpr double kRolling = 2;     // m/s2: a car that brakes harder may slide anywhere
constexpr std::size_t kReach = 5;  // samples on either side of a derivative, against noise
constexpr double kLikeOne = 1.5;   // a factor between 1 over this and this is taken for 1

using Values = std::vector<double>;
using At = std::function<double(std::size_t)>;

struct Fit {
    double correlation;
    double slope;  // of the second over the first, through the origin
};

bool likeOne(double factor) {
    return factor > 1 / kLikeOne && factor < kLikeOne;
}

class Body {
public:
    explicit Body(const Log& log)
        : log_(log),
          time_(log.channels.front().values),
          vx_(values("chassis.vx")),
          vy_(values("chassis.vy")),
          yaw_rate_(values("chassis.yaw_rate")),
          ax_(values("chassis.ax")),
          ay_(values("chassis.ay")) {}

    std::vector<BodyRelation> relations() {
        if (!vx_) return {};
        turning();
        steering();
        alongTheCar();
        angles();
        wheels();
        return std::move(relations_);
    }

    std::vector<Swapped> swapped() const {
        std::vector<Swapped> found;
        if (!vx_) return found;
        if (yaw_rate_ && ay_) {
            const auto right = fit(turn(), *ay_, kTurning);
            const auto wrong = fit([this](std::size_t i) { return (*vx_)[i] * (*ay_)[i]; }, *yaw_rate_, kTurning);
            if (wrong && std::abs(wrong->correlation) > kSwapped && !fitsAsItIs(right, *wrong) &&
                fitsSwapped(right, *wrong)) {
                found.push_back(
                    {"chassis.yaw_rate", "chassis.ay",
                     fmt::format(
                         "chassis.yaw_rate follows chassis.vx times chassis.ay (correlation {:.2f}), as the lateral "
                         "acceleration follows speed and yaw rate",
                         wrong->correlation)});
            }
        }
        if (yaw_rate_ && ax_ && ay_) {
            const Values change = derivative(*vx_);
            const At gains = [&](std::size_t i) { return change[i]; };
            const auto lateral = fit(turn(), *ax_, kTurning, false), along = fit(gains, *ay_, kTurning, false);
            const auto is = [](const std::optional<Fit>& one) {
                return one && std::abs(one->correlation) > kCorrelated && likeOne(std::abs(one->slope));
            };
            if (is(lateral) && (is(along) || !is(fit(turn(), *ay_, kTurning, false)))) {
                found.push_back({"chassis.ax", "chassis.ay",
                                 fmt::format("chassis.ax follows chassis.vx times chassis.yaw_rate (correlation "
                                             "{:.2f}), as the lateral acceleration does",
                                             lateral->correlation)});
            }
        }
        return found;
    }

private:
    // Where the speed varies, the right order correlates better than the wrong one.
    static bool isBetter(const Fit& wrong, const std::optional<Fit>& right) {
        return !right || std::abs(right->correlation) < std::abs(wrong.correlation) - kBetter;
    }
    static bool fitsAsItIs(const std::optional<Fit>& right, const Fit& wrong) {
        return right && std::abs(right->correlation) > kCorrelated && !isBetter(wrong, right) &&
               (likeOne(std::abs(right->slope)) || !lookOfFactor(std::abs(right->slope)).empty());
    }
    // Units that were guessed for swapped columns are wrong as well: deg/s for m/s2, g for rad/s.
    static bool fitsSwapped(const std::optional<Fit>& right, const Fit& wrong) {
        const double slope = std::abs(wrong.slope);
        if (likeOne(slope)) return true;
        return isBetter(wrong, right) &&
               (likeOne(slope * kDegree) || likeOne(slope * kGravity) || likeOne(slope * kDegree * kGravity));
    }

    const Values* values(const char* name) const {
        const Channel* const channel = log_.find(name);
        return channel ? &channel->values : nullptr;
    }

    At turn() const {
        return [this](std::size_t i) { return (*vx_)[i] * (*yaw_rate_)[i]; };
    }
    static At of(const Values& values) {
        return [&values](std::size_t i) { return values[i]; };
    }

    // Where an angle passes from one end of its range to the other there is no rate.
    Values derivative(const Values& values) const {
        Values rates(values.size(), 0);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t a = i > kReach ? i - kReach : 0, b = std::min(i + kReach, values.size() - 1);
            rates[i] = b > a ? (values[b] - values[a]) / (time_[b] - time_[a]) : 0;
        }
        return rates;
    }
    Values rateOfAngle(const Values& angle) const {
        Values rates = derivative(angle);
        for (double& rate : rates) {
            if (std::abs(rate) > 10) rate = std::numeric_limits<double>::quiet_NaN();
        }
        return rates;
    }

    // Over the samples at which the car moves (and rolls); nothing when there are too few or the first hardly varies.
    std::optional<Fit> fit(const At& first, const Values& second, double least, bool rolling = true) const {
        double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
        for (std::size_t i = 0; i < vx_->size(); ++i) {
            const double x = first(i), y = second[i];
            if (rolling && ax_ && std::abs((*ax_)[i]) > kRolling) continue;
            if (!((*vx_)[i] > kSlowest) || !std::isfinite(x) || !std::isfinite(y)) continue;
            n += 1;
            a += x;
            b += y;
            aa += x * x;
            bb += y * y;
            ab += x * y;
        }
        if (n < static_cast<double>(kFewest) || aa / n < least * least) return {};
        const double spread = (aa - a * a / n) * (bb - b * b / n);
        if (!(spread > 0)) return {};
        return Fit{(ab - a * b / n) / std::sqrt(spread), ab / aa};
    }

    void add(std::string channel, std::string other, std::string says, const std::optional<Fit>& fit, bool sized) {
        if (!fit || std::abs(fit->correlation) < kCorrelated) return;
        relations_.push_back(
            {std::move(channel), std::move(other), std::move(says), fit->correlation, std::abs(fit->slope), sized});
    }

    void turning() {
        if (!yaw_rate_ || !ay_) return;
        add("chassis.ay", "chassis.yaw_rate", "chassis.ay and chassis.vx times chassis.yaw_rate",
            fit(turn(), *ay_, kTurning), true);
        if (!vy_) return;
        Values sideways = *ay_;
        for (std::size_t i = 0; i < sideways.size(); ++i) sideways[i] -= turn()(i);
        const Values change = derivative(*vy_);
        add("chassis.vy", "chassis.ay",
            "the derivative of chassis.vy and chassis.ay minus chassis.vx times chassis.yaw_rate",
            fit(of(change), sideways, kTurning), false);
    }

    void steering() {
        const Values* const wheel = values("driver.steering_wheel_angle");
        if (!wheel) return;
        const std::string name = "driver.steering_wheel_angle";
        if (yaw_rate_) {
            add(name, "chassis.yaw_rate", name + " and chassis.yaw_rate", fit(of(*wheel), *yaw_rate_, 0.05), false);
        }
        if (ay_) add(name, "chassis.ay", name + " and chassis.ay", fit(of(*wheel), *ay_, 0.05), false);
    }

    void alongTheCar() {
        if (!ax_) return;
        Values expected = derivative(*vx_);
        for (std::size_t i = 0; vy_ && yaw_rate_ && i < expected.size(); ++i)
            expected[i] -= (*vy_)[i] * (*yaw_rate_)[i];
        add("chassis.ax", "chassis.vx",
            vy_ && yaw_rate_ ? "chassis.ax and the derivative of chassis.vx minus chassis.vy times chassis.yaw_rate"
                             : "chassis.ax and the derivative of chassis.vx",
            fit(of(expected), *ax_, kTurning, false), true);
        const Values* const pitch = values("chassis.pitch");
        if (!pitch) return;
        const At nose = [this](std::size_t i) { return -(*ax_)[i]; };
        add("chassis.pitch", "chassis.ax", "chassis.pitch (nose down positive) and deceleration",
            fit(nose, *pitch, 0.5, false), false);
    }

    void angles() {
        const Values *roll = values("chassis.roll"), *roll_rate = values("chassis.roll_rate"),
                     *yaw = values("chassis.yaw"), *heading = values("position.heading"),
                     *sideslip = values("chassis.sideslip");
        if (roll && ay_)
            add("chassis.roll", "chassis.ay", "chassis.roll and chassis.ay", fit(of(*ay_), *roll, 0.5), false);
        if (roll && yaw_rate_) {
            add("chassis.roll", "chassis.yaw_rate", "chassis.roll and chassis.vx times chassis.yaw_rate",
                fit(turn(), *roll, 0.5), false);
        }
        if (roll && roll_rate) {
            const Values rate = rateOfAngle(*roll);
            add("chassis.roll_rate", "chassis.roll", "chassis.roll_rate and the derivative of chassis.roll",
                fit(of(rate), *roll_rate, 0.01), true);
        }
        for (const auto& [name, angle] : {std::pair{"chassis.yaw", yaw}, std::pair{"position.heading", heading}}) {
            if (!angle || !yaw_rate_) continue;
            const Values rate = rateOfAngle(*angle);
            add(name, "chassis.yaw_rate", std::string("chassis.yaw_rate and the derivative of ") + name,
                fit(of(rate), *yaw_rate_, 0.05), true);
        }
        if (sideslip && vy_) {
            const At angle = [this](std::size_t i) { return std::atan2((*vy_)[i], (*vx_)[i]); };
            add("chassis.sideslip", "chassis.vy", "chassis.sideslip and the angle from chassis.vy and chassis.vx",
                fit(angle, *sideslip, 0.005), true);
        }
    }

    // A wheel turns forward while the car drives forward, whether or not the speed varies.
    void wheels() {
        for (const char* wheel : {"front_left", "front_right", "rear_left", "rear_right"}) {
            for (const char* quantity : {"speed", "spin"}) {
                const std::string name = std::string("wheel.") + wheel + "." + quantity;
                const Values* const turns = values(name.c_str());
                if (!turns) continue;
                auto rolls = fit(of(*vx_), *turns, kSlowest);
                if (!rolls || rolls->slope == 0) continue;
                rolls->correlation = rolls->slope > 0 ? 1 : -1;
                const bool speed = std::string_view(quantity) == "speed";
                add(name, "chassis.vx", name + " and chassis.vx", rolls, speed);
            }
        }
    }

    const Log& log_;
    const Values& time_;
    const Values *vx_, *vy_, *yaw_rate_, *ax_, *ay_;
    std::vector<BodyRelation> relations_;
};

std::size_t indexIn(std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    names.push_back(name);
    return names.size() - 1;
}

}  // namespace

std::string lookOfFactor(double factor) {
    const auto near = [&](double known) { return std::abs(factor / known - 1) < 0.15; };
    if (near(9.80665) || near(1 / 9.80665)) return ", as if one of them were in g";
    if (near(kDegree) || near(1 / kDegree)) return ", as if one of them were in degrees";
    if (near(3.6) || near(1 / 3.6)) return ", as if one of them were in km/h";
    return "";
}

std::vector<BodyRelation> bodyRelations(const Log& log) {
    return Body(log).relations();
}

std::vector<Swapped> swappedChannels(const Log& log) {
    return Body(log).swapped();
}

// Tries every set of channels to turn: there are few. What contradicts whatever is turned counts more than any turn.
OddOnes oddOnes(const std::vector<BodyRelation>& relations) {
    std::vector<std::string> names{"chassis.vx"};  // its bit stays 0
    struct Edge {
        std::size_t a, b;
        bool opposite;
    };
    std::vector<Edge> edges;
    for (const BodyRelation& relation : relations) {
        const std::size_t a = indexIn(names, relation.channel), b = indexIn(names, relation.other);
        edges.push_back({a, b, relation.correlation < 0});
    }
    std::size_t best = std::numeric_limits<std::size_t>::max(), in_all = 0, in_some = 0;
    for (std::size_t set = 0; set < std::size_t(1) << names.size(); set += 2) {
        std::size_t cost = 0;
        for (std::size_t bits = set; bits != 0; bits &= bits - 1) ++cost;
        for (const Edge& edge : edges) {
            const bool agree = (((set >> edge.a) ^ (set >> edge.b)) & 1) == (edge.opposite ? 1u : 0u);
            if (!agree) cost += names.size();
        }
        if (cost > best) continue;
        in_all = cost < best ? set : in_all & set;
        in_some = cost < best ? set : in_some | set;
        best = cost;
    }
    OddOnes found;
    for (std::size_t i = 1; i < names.size(); ++i) {
        if ((in_all >> i) & 1) found.turned.push_back(names[i]);
        if (((in_some & ~in_all) >> i) & 1) found.either.push_back(names[i]);
    }
    return found;
}

}  // namespace tread
