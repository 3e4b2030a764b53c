#include "recording/checks/rigid_body.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>

#include "inference/whitening.h"
#include "log/log_columns.h"
#include "recording/checks/windows.h"
#include "recording/observation.h"
#include "recording/position.h"
#include "recording/recorded_drive.h"

namespace tread::recording::checks {
namespace {

using Kind = InstrumentError::Kind;
using Values = std::vector<double>;

constexpr double kLongestDelay = 0.5;  // s, range of the search
constexpr double kWorthwhile = 0.15;   // share of the mean square that a further error of an instrument must explain
constexpr double kShareOfSize = 0.08;  // of the channel's standard deviation; smaller remainders are no contradiction
constexpr double kAboveNoise = 3;      // factor on the noise; smaller signals tell nothing about their instrument
constexpr double kSlow = 0.2;          // s, over which the remainder is averaged before it counts as a contradiction
constexpr double kSlowNoise = 1.1;     // factor on the noise of a window for averages over kSlow
constexpr double kMatters = 0.1;       // relative change of the remainder from which lateral velocity matters
constexpr std::size_t kFewest = 100;   // windows
constexpr double kLeastPlace = 0.3, kLeastSkew = 0.01;  // m, rad; smaller errors of mounting are not reported
constexpr double kLeastDelay = 0.025;                   // s
constexpr double kLeastGain = 0.04;
// Factor on the least gain and bias without lateral velocity, which then looks like them.
constexpr double kWithoutVy = 3;
// rad per m/s2, 6 deg/g: the largest rear cornering compliance of a car (2 to 4 deg/g are usual). Without lateral
// velocity, sideslip in proportion to ay makes ay look late by this times the speed.
constexpr double kRearCompliance = 6 * std::numbers::pi / 180 / 9.81;
constexpr double kBraking = 1.5;  // m/s2

// Per quantity: bias worth reporting, and remainder that is a contradiction. Both in the SI unit of the quantity.
struct Least {
    const char* quantity;
    double bias, remainder;
};
// From what is hardest to measure to what is easiest.
constexpr Least kQuantities[] = {{"chassis.sideslip", 0.01, 0.03},  {"chassis.vy", 0.15, 0.3},
                                 {"chassis.roll_rate", 0.02, 0.03}, {"chassis.roll", 0.02, 0.02},
                                 {"chassis.ax", 0.2, 0.32},         {"chassis.ay", 0.2, 0.32},
                                 {"chassis.vx", 0.3, 0.5},          {"chassis.yaw_rate", 0.01, 0.03}};

const Least& leastOf(std::string_view channel) {
    return *std::find_if(std::begin(kQuantities), std::end(kQuantities) - 1,
                         [&](const Least& one) { return one.quantity == quantityOf(channel); });
}

// Lateral velocity, from the sideslip angle if it is not measured itself.
std::optional<Channel> acrossOf(const Log& log) {
    if (const Channel* vy = measuredAs(log, "chassis.vy")) return *vy;
    const Channel *sideslip = measuredAs(log, "chassis.sideslip"), *vx = measuredAs(log, "chassis.vx");
    if (!sideslip || !vx) return std::nullopt;
    Channel across = *sideslip;
    for (std::size_t i = 0; i < across.values.size(); ++i)
        across.values[i] = vx->values[i] * std::tan(across.values[i]);
    return across;
}

bool showsAcross(std::string_view channel) {
    return quantityOf(channel) == "chassis.vy" || quantityOf(channel) == "chassis.sideslip";
}

// A column of the fit and the error that its coefficient is.
struct Column {
    Kind kind;
    Values values;
};

// A relation before it is fitted.
struct Claim {
    Agreement said;
    Values measured, expected;
    Values without_vy = {};  // what is expected if lateral velocity is ignored; empty if it plays no part
    std::vector<Column> mounting = {};
    double noise = 0;
    double of_sideslip = 0;  // s, delay that unknown sideslip may look like
};

struct Fit {
    double square = kInfinity;  // mean square of what remains
    std::ptrdiff_t later = 0;   // steps of the grid
    Eigen::VectorXd coefficients;
};

// Least squares of measured - delayed expected values over columns of the given kinds.
Fit fitted(const Claim& claim, const std::vector<Kind>& kinds, std::ptrdiff_t later, std::ptrdiff_t reach) {
    const auto size = std::ssize(claim.measured);
    Eigen::MatrixXd columns(size, std::ssize(kinds));
    Eigen::VectorXd off(size);
    Eigen::Index rows = 0;
    for (std::ptrdiff_t i = reach; i < size - reach; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double expected = claim.expected[static_cast<std::size_t>(i - later)];
        off(rows) = claim.measured[at] - expected;
        bool known = std::isfinite(off(rows));
        for (Eigen::Index k = 0; k < std::ssize(kinds); ++k) {
            const auto kind = kinds[static_cast<std::size_t>(k)];
            const auto column = std::find_if(claim.mounting.begin(), claim.mounting.end(),
                                             [&](const Column& one) { return one.kind == kind; });
            columns(rows, k) = kind == Kind::gain ? expected : kind == Kind::bias ? 1 : column->values[at];
            known = known && std::isfinite(columns(rows, k));
        }
        rows += known;
    }
    if (rows < static_cast<Eigen::Index>(kFewest)) return {};
    const Eigen::VectorXd given = off.head(rows);
    if (kinds.empty()) return {given.squaredNorm() / static_cast<double>(rows), later, {}};
    const Eigen::MatrixXd used = columns.topRows(rows);
    const Eigen::VectorXd best = (used.transpose() * used).ldlt().solve(used.transpose() * given);
    return {(given - used * best).squaredNorm() / static_cast<double>(rows), later, best};
}

// With `delayed`, the best delay on the grid.
Fit bestFit(const Claim& claim, const std::vector<Kind>& kinds, bool delayed, std::ptrdiff_t reach) {
    if (!delayed) return fitted(claim, kinds, 0, reach);
    Fit best;
    for (std::ptrdiff_t later = -reach; later <= reach; ++later) {
        Fit one = fitted(claim, kinds, later, reach);
        if (one.square < best.square) best = std::move(one);
    }
    return best;
}

// The delay between steps of the grid, by a parabola through the neighbouring mean squares.
double fineDelay(const Claim& claim, const std::vector<Kind>& kinds, std::ptrdiff_t later, std::ptrdiff_t reach,
                 double step) {
    if (std::abs(later) >= reach) return static_cast<double>(later) * step;
    const double a = fitted(claim, kinds, later - 1, reach).square, b = fitted(claim, kinds, later, reach).square,
                 c = fitted(claim, kinds, later + 1, reach).square;
    const double bend = a - 2 * b + c;
    return step * (static_cast<double>(later) + (bend > 0 ? 0.5 * (a - c) / bend : 0));
}

// Means over kSlow of all series.
Claim slowly(Claim claim, double step) {
    const auto length = static_cast<std::size_t>(std::max(1.0, std::round(kSlow / step)));
    const auto average = [&](Values& values) {
        const Values all = values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = kRequired;
            if (i + length > all.size()) continue;
            const auto first = all.begin() + static_cast<std::ptrdiff_t>(i);
            values[i] =
                std::accumulate(first, first + static_cast<std::ptrdiff_t>(length), 0.0) / static_cast<double>(length);
        }
    };
    average(claim.measured), average(claim.expected), average(claim.without_vy);
    for (Column& column : claim.mounting) average(column.values);
    return claim;
}

// The channels of which one must be wrong. Lateral velocity alone if the others agree better without it; not lateral
// velocity if it makes no difference.
std::vector<std::string> suspectsOf(const Claim& claim, const Fit& fit, const std::vector<Kind>& kinds,
                                    std::ptrdiff_t reach) {
    std::vector<std::string> all = claim.said.others;
    all.insert(all.begin(), claim.said.channel);
    if (claim.without_vy.empty()) return all;
    Claim without = claim;
    without.expected = claim.without_vy;
    const double ratio = std::sqrt(fitted(without, kinds, fit.later, reach).square / fit.square);
    if (ratio < 1 - kMatters) std::erase_if(all, [](const std::string& channel) { return !showsAcross(channel); });
    else if (ratio < 1 + kMatters) std::erase_if(all, showsAcross);
    return all;
}

double meanOf(const Values& values) {
    double n = 0, sum = 0;
    for (const double value : values)
        if (std::isfinite(value)) n += 1, sum += value;
    return n > 0 ? sum / n : 0;
}

double deviationOf(const Values& values) {
    const double mean = meanOf(values);
    Values squares;
    for (const double value : values) squares.push_back((value - mean) * (value - mean));
    return std::sqrt(meanOf(squares));
}

// Whether lateral velocity that is not measured can be all of a difference of accelerations but its mean: the velocity
// that this leads to is within that of sideslip in proportion to ay.
bool maybeSideslip(const Claim& claim, double step) {
    if (claim.said.complete) return false;
    Values off = claim.measured;
    for (std::size_t i = 0; i < off.size(); ++i) off[i] -= claim.expected[i];
    const double mean = meanOf(off);
    Values velocity;
    double sum = 0;
    for (const double value : off)
        if (std::isfinite(value)) velocity.push_back(sum += step * (value - mean));
    return deviationOf(velocity) < claim.of_sideslip * claim.said.size;
}

bool worthReporting(const InstrumentError& error, const Claim& claim, double step) {
    const double size = std::abs(error.size), doubt = claim.said.complete ? 1 : kWithoutVy;
    switch (error.kind) {
        case Kind::delay:
            return size >= std::max(kLeastDelay, claim.of_sideslip) && !maybeSideslip(claim, step);
        case Kind::gain:
            return size >= doubt * kLeastGain && !maybeSideslip(claim, step);
        case Kind::bias:
            return size >= doubt * leastOf(claim.said.channel).bias;
        case Kind::place:
            return size >= kLeastPlace;
        case Kind::skew:
            return size >= kLeastSkew;
        case Kind::sideslip:
            return false;
    }
    return false;
}

// Without lateral velocity, a delay beyond what sideslip can cause is taken for one; other errors are then unknown.
void judgeDelay(const Claim& claim, double step, std::ptrdiff_t reach, Agreement& said) {
    std::erase_if(said.errors, [](const InstrumentError& one) { return one.kind == Kind::place; });
    const Fit late = bestFit(claim, {}, true, reach);
    const double delay = fineDelay(claim, {}, late.later, reach, step);
    if (std::abs(delay) < claim.of_sideslip || std::abs(late.later) >= reach ||
        !(late.square < (1 - kWorthwhile) * said.apart * said.apart))
        return;
    said.errors = {{Kind::delay, delay, said.channel}};
    said.left = std::sqrt(late.square);
}

// Adds errors of the instruments one by one, each time the one that explains most, as long as it is worthwhile.
Agreement explained(const Claim& claim, double step) {
    const auto reach = static_cast<std::ptrdiff_t>(std::lround(kLongestDelay / step));
    std::vector<Kind> open{Kind::delay, Kind::gain, Kind::bias}, kinds;
    // An unknown lateral velocity looks like a delay or like another place, so that a place is always fitted then.
    bool delayed = false;
    if (!claim.said.complete) open.erase(open.begin());
    for (const Column& column : claim.mounting) (claim.said.complete ? open : kinds).push_back(column.kind);
    Agreement said = claim.said;
    said.apart = std::sqrt(fitted(claim, {}, 0, reach).square);
    Fit now = fitted(claim, kinds, 0, reach);
    const Fit sign = fitted(claim, {Kind::gain, Kind::bias}, 0, reach);
    // Too few windows, or a wrong sign, which other checks name.
    if (!std::isfinite(now.square) || sign.coefficients(0) < -1) {
        said.complete = false;
        return said;
    }
    while (!open.empty()) {
        Fit best;
        auto which = open.end();
        for (auto one = open.begin(); one != open.end(); ++one) {
            std::vector<Kind> with = kinds;
            if (*one != Kind::delay) with.push_back(*one);
            Fit fit = bestFit(claim, with, delayed || *one == Kind::delay, reach);
            if (fit.square < best.square) best = std::move(fit), which = one;
        }
        if (which == open.end() || !(best.square < (1 - kWorthwhile) * now.square)) break;
        if (*which == Kind::delay) delayed = true;
        else kinds.push_back(*which);
        now = best;
        open.erase(which);
    }
    said.left = std::sqrt(now.square);
    if (delayed) {
        const double delay = fineDelay(claim, kinds, now.later, reach, step);
        // Of two instruments the late one is named.
        const bool of_other = delay < 0 && said.others.size() == 1;
        said.errors.push_back({Kind::delay, of_other ? -delay : delay, of_other ? said.others[0] : said.channel});
    }
    for (std::size_t k = 0; k < kinds.size(); ++k)
        said.errors.push_back({kinds[k], now.coefficients(static_cast<Eigen::Index>(k)), said.channel});
    if (!claim.said.complete) judgeDelay(claim, step, reach, said);
    // A channel that shows little but noise tells nothing about its instrument.
    const bool moves = said.size > kAboveNoise * claim.noise;
    std::erase_if(said.errors, [&](const InstrumentError& one) { return !moves || !worthReporting(one, claim, step); });
    const Claim slow = slowly(claim, step);
    const Fit lasting = fitted(slow, kinds, now.later, reach);
    const double allowed =
        std::max({leastOf(said.channel).remainder, kShareOfSize * said.size, kSlowNoise * claim.noise});
    said.contradicts = said.complete && std::isfinite(lasting.square) && std::sqrt(lasting.square) > allowed;
    if (said.contradicts) said.suspects = suspectsOf(slow, lasting, kinds, reach);
    return said;
}

// ---- The relations ----

std::vector<const Channel*> channelsOf(const Log& log, std::string_view quantity) {
    std::vector<const Channel*> all;
    if (const Channel* first = log.find(quantity)) all.push_back(first);
    for (const Channel& channel : log.channels) {
        if (channel.name != quantity && quantityOf(channel.name) == quantity) all.push_back(&channel);
    }
    return all;
}

Values sum(Values a, const Values& b, double factor = 1) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
    return a;
}

// The channels of one recording that the relations need, on the grid of the windows.
class Body {
public:
    Body(const Log& log, const Instruments& instruments)
        : log_(log), instruments_(instruments), windows_(log.channels.front().values), across_(acrossOf(log)) {}

    std::vector<Claim> claims() const {
        std::vector<Claim> all;
        for (const Channel* ay : channelsOf(log_, "chassis.ay")) add(all, lateral(*ay));
        for (const Channel* ax : channelsOf(log_, "chassis.ax")) add(all, longitudinal(*ax));
        for (const Channel* rate : channelsOf(log_, "chassis.roll_rate")) add(all, rolling(*rate));
        for (const Least& one : kQuantities) {
            const std::vector<const Channel*> same = channelsOf(log_, one.quantity);
            for (std::size_t i = 1; i < same.size(); ++i) add(all, alike(*same[i], *same[0]));
        }
        return all;
    }
    double step() const { return windows_.step(); }

private:
    // Block values with the described gain, bias and delay taken out. The bias of lateral velocity is an angle and
    // stays.
    Values blocks(const Channel& channel) const {
        const Instrument known = instrumentOf(instruments_, channel.name);
        Values values = windows_.blocks(channel.values, known.delay);
        const double bias = showsAcross(channel.name) ? 0 : known.bias;
        for (double& value : values) value = (value - bias) / known.gain;
        return values;
    }
    Values mean(const Channel& channel) const { return windows_.mean(blocks(channel)); }
    Values rate(const Channel& channel) const { return windows_.rate(blocks(channel)); }
    Values product(const Channel& a, const Channel& b) const {
        Values x = blocks(a);
        const Values y = blocks(b);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] *= y[i];
        return windows_.mean(x);
    }

    // Standard deviation that noise and vibration of a channel leave in its mean, or rate, over a window.
    double noise(const Channel& channel, bool of_rate) const {
        return windows_.noise(inference::noiseBehind(blocks(channel), inference::kBand), of_rate);
    }

    Claim claim(const Channel& channel, std::string follows_from, std::vector<const Channel*> others) const {
        Claim made;
        made.said.channel = channel.name;
        made.said.follows_from = std::move(follows_from);
        for (const Channel* one : others) made.said.others.push_back(one->name);
        made.said.unit = channel.unit;
        made.measured = mean(channel);
        made.said.size = deviationOf(made.measured);
        made.noise = noise(channel, false);
        return made;
    }

    // ay = vy' + vx r; an accelerometer x in front of the other instruments reads x r' more.
    std::optional<Claim> lateral(const Channel& ay) const {
        const Channel *vx = measuredAs(log_, "chassis.vx"), *r = measuredAs(log_, "chassis.yaw_rate"),
                      *vy = across_ ? &*across_ : nullptr;
        if (!vx || !r) return std::nullopt;
        Claim made =
            vy ? claim(ay, fmt::format("{} times {} plus the rate of {}", vx->name, r->name, vy->name), {vx, r, vy})
               : claim(ay, fmt::format("{} times {}", vx->name, r->name), {vx, r});
        made.expected = product(*vx, *r);
        made.said.complete = vy != nullptr;
        if (vy) {
            made.without_vy = made.expected;
            made.expected = sum(std::move(made.expected), rate(*vy));
            made.noise = std::hypot(made.noise, noise(*vy, true));
        }
        made.mounting.push_back({Kind::place, rate(*r)});
        if (!vy) {
            made.mounting.push_back({Kind::sideslip, rate(ay)});
            made.of_sideslip = delayOfSideslip(*vx);
            leaveOutBraking(made, *vx);
        }
        return made;
    }

    double delayOfSideslip(const Channel& vx) const { return kRearCompliance * meanOf(mean(vx)); }

    // Braking changes the lateral velocity by an amount that is unknown without it.
    void leaveOutBraking(Claim& claim, const Channel& vx) const {
        const Values change = rate(vx);
        for (std::size_t i = 0; i < change.size(); ++i)
            if (std::abs(change[i]) > kBraking) claim.measured[i] = kRequired;
    }

    // ax = vx' - vy r
    std::optional<Claim> longitudinal(const Channel& ax) const {
        const Channel *vx = measuredAs(log_, "chassis.vx"), *r = measuredAs(log_, "chassis.yaw_rate"),
                      *vy = across_ ? &*across_ : nullptr;
        if (!vx) return std::nullopt;
        Claim made = vy && r ? claim(ax, fmt::format("the rate of {} minus {} times {}", vx->name, vy->name, r->name),
                                     {vx, vy, r})
                             : claim(ax, fmt::format("the rate of {}", vx->name), {vx});
        made.expected = rate(*vx);
        if (vy && r) {
            made.without_vy = made.expected;
            made.expected = sum(std::move(made.expected), product(*vy, *r), -1);
        }
        made.said.complete = vy && r;
        if (!made.said.complete) made.of_sideslip = delayOfSideslip(*vx);
        made.noise = std::hypot(made.noise, noise(*vx, true));
        return made;
    }

    std::optional<Claim> rolling(const Channel& roll_rate) const {
        const Channel* roll = measuredAs(log_, "chassis.roll");
        if (!roll) return std::nullopt;
        Claim made = claim(roll_rate, fmt::format("the rate of {}", roll->name), {roll});
        made.expected = rate(*roll);
        made.noise = std::hypot(made.noise, noise(*roll, true));
        return made;
    }

    // A further instrument and the first one of its quantity, at different places of the car.
    std::optional<Claim> alike(const Channel& further, const Channel& first) const {
        Claim made = claim(further, first.name, {&first});
        made.expected = mean(first);
        made.noise = std::hypot(made.noise, noise(first, false));
        const Channel *vx = measuredAs(log_, "chassis.vx"), *r = measuredAs(log_, "chassis.yaw_rate");
        const std::string_view quantity = quantityOf(first.name);
        if (quantity == "chassis.vy" && r) made.mounting.push_back({Kind::place, mean(*r)});
        if (quantity == "chassis.vy" && vx)
            made.mounting.push_back({Kind::skew, sum(Values(made.measured.size(), 0), mean(*vx), -1)});
        if (quantity == "chassis.ay" && r) made.mounting.push_back({Kind::place, rate(*r)});
        return made;
    }

    static void add(std::vector<Claim>& all, std::optional<Claim> one) {
        if (one) all.push_back(std::move(*one));
    }

    const Log& log_;
    const Instruments& instruments_;
    Windows windows_;
    std::optional<Channel> across_;  // lateral velocity
};

// ---- Words ----

std::string errorText(const InstrumentError& error, const Agreement& said) {
    const std::string whose = error.channel == said.channel ? "it" : error.channel;
    switch (error.kind) {
        case Kind::delay:
            return fmt::format("{} {} by {:.0f} ms", whose, error.size > 0 ? "lags" : "leads",
                               1000 * std::abs(error.size));
        case Kind::gain: {
            std::string text = fmt::format("{} is {:.3g} times as large", whose, 1 + error.size);
            // Gravity through the roll angle adds to the reading in proportion to ay.
            if (quantityOf(error.channel) == "chassis.ay" && error.size > 0)
                text += fmt::format(" (as gravity does at a body roll of {:.1f} deg per g)",
                                    error.size * 180 / std::numbers::pi);
            return text;
        }
        case Kind::bias:
            return fmt::format("{} reads {:.2g} {} too {}", whose, std::abs(error.size), said.unit,
                               error.size > 0 ? "high" : "low");
        case Kind::place:
            return fmt::format("{} is measured {:.2g} m further {}", whose, std::abs(error.size),
                               error.size > 0 ? "forward" : "back");
        case Kind::skew:
            return fmt::format("its axes are turned by {:.2g} rad", error.size);
        case Kind::sideslip:
            break;
    }
    return {};
}

}  // namespace

std::vector<Agreement> agreements(const Log& log, const Instruments& instruments) {
    std::vector<Agreement> all;
    if (log.samples() < 2) return all;
    const Body body(log, instruments);
    for (const Claim& claim : body.claims()) {
        Agreement one = explained(claim, body.step());
        if (std::isfinite(one.apart)) all.push_back(std::move(one));
    }
    return all;
}

std::string oddChannel(const std::vector<Agreement>& all) {
    std::map<std::string, int> votes;
    for (const Agreement& one : all) {
        for (const std::string& suspect : one.suspects) ++votes[suspect];
        if (one.contradicts || !one.complete) continue;
        --votes[one.channel];
        for (const std::string& other : one.others) --votes[other];
    }
    // Of two instruments of a quantity the further one is named, unless it follows from positions.
    const auto weight = [&](const std::string& channel) {
        const std::string_view source = sourceOf(channel);
        return std::tuple(votes[channel], &kQuantities[0] - &leastOf(channel),
                          !source.empty() && source != kPositionSource);
    };
    std::string odd;
    for (const Agreement& one : all) {
        for (const std::string& suspect : one.suspects)
            if (odd.empty() || weight(suspect) > weight(odd)) odd = suspect;
    }
    return odd;
}

std::string toText(const Agreement& said) {
    std::string text = fmt::format("differs from {} by {:.2g} {} rms", said.follows_from, said.apart, said.unit);
    std::vector<std::string> errors;
    for (const InstrumentError& error : said.errors) errors.push_back(errorText(error, said));
    if (!errors.empty())
        text += fmt::format("; {}, which leaves {:.2g} {}", fmt::join(errors, " and "), said.left, said.unit);
    return text;
}

std::vector<std::string> leaveOutContradictions(const DiagnosisFile& file, Recorded& recorded) {
    std::vector<std::string> sentences;
    if (file.contradictions == Contradictions::keep) return sentences;
    for (;;) {
        std::map<std::string, int> odd, shown;
        for (const std::vector<Log>* logs : {&recorded.logs, &recorded.before}) {
            for (const Log& log : *logs) {
                ++odd[oddChannel(agreements(withUsedChannels(log, file), file.instruments))];
                for (const Channel& channel : log.channels) ++shown[channel.name];
            }
        }
        odd.erase("");
        const auto worst =
            std::max_element(odd.begin(), odd.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
        if (worst == odd.end() || 2 * worst->second < shown[worst->first]) return sentences;
        sentences.push_back(
            fmt::format("{} is left out: it contradicts the other channels in {} of {} recordings. Set contradictions: "
                        "keep to use it anyway.",
                        worst->first, worst->second, shown[worst->first]));
        for (std::vector<Log>* logs : {&recorded.logs, &recorded.references, &recorded.before}) {
            for (Log& log : *logs)
                std::erase_if(log.channels, [&](const Channel& one) { return one.name == worst->first; });
        }
    }
}

}  // namespace tread::recording::checks
