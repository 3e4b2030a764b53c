#include "import/doubts.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace tread {
namespace {

constexpr double kSlowest = 3;       // m/s: below, a car can do anything
constexpr std::size_t kFewest = 50;  // samples
constexpr double kCorrelated = 0.7;  // from here two channels show the same thing
constexpr double kTurning = 0.3;     // m/s2 of vx times yaw rate, rms: less is noise
constexpr double kRolling = 2;       // m/s2: a car that brakes harder may slide anywhere
constexpr double kDegree = 180 / std::numbers::pi;

struct Fit {
    double correlation;
    double slope;  // of the second over the first, through the origin
};

// Over the samples at which the car moves; nothing when there are too few or the first hardly varies.
std::optional<Fit> fit(const Log& log, const std::function<double(std::size_t)>& first, const Channel& second,
                       double least) {
    const Channel& vx = *log.find("chassis.vx");
    const Channel* const ax = log.find("chassis.ax");
    double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < vx.values.size(); ++i) {
        const double x = first(i), y = second.values[i];
        if (ax && std::abs(ax->values[i]) > kRolling) continue;
        if (!(vx.values[i] > kSlowest) || !std::isfinite(x) || !std::isfinite(y)) continue;
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

// What a factor between two channels looks like; nothing for one that a slide or noise can make.
std::string lookOf(double factor) {
    const auto near = [&](double known) { return std::abs(factor / known - 1) < 0.15; };
    if (near(9.80665) || near(1 / 9.80665)) return ", as if one of them were in g";
    if (near(kDegree) || near(1 / kDegree)) return ", as if one of them were in degrees";
    if (near(3.6) || near(1 / 3.6)) return ", as if one of them were in km/h";
    return "";
}

void judge(std::vector<Change>& found, const std::optional<Fit>& fit, std::string_view what, std::string_view channel,
           bool size_too) {
    if (!fit || std::abs(fit->correlation) < kCorrelated) return;
    const std::string name(channel);
    if (fit->correlation < 0) {
        found.push_back({"doubt", name, 1,
                         fmt::format("{} have opposite signs (correlation {:.2f}): one of them is not ISO 8855 (left "
                                     "and up positive); its sign should be -1",
                                     what, fit->correlation)});
    }
    const double size = std::abs(fit->slope);
    const std::string look = lookOf(size);
    if (size_too && !look.empty()) {
        found.push_back(
            {"doubt", name, 1, fmt::format("{} differ by a factor of {:.3g}{}; is a unit wrong?", what, size, look)});
    }
}

}  // namespace

std::vector<Change> doubts(const Log& log) {
    std::vector<Change> found;
    const Channel* const vx = log.find("chassis.vx");
    if (!vx) return found;
    const Channel* const yaw_rate = log.find("chassis.yaw_rate");
    const Channel* const ay = log.find("chassis.ay");
    const Channel* const wheel = log.find("driver.steering_wheel_angle");
    if (yaw_rate && ay) {
        const auto expected = [&](std::size_t i) { return vx->values[i] * yaw_rate->values[i]; };
        judge(found, fit(log, expected, *ay, kTurning), "chassis.ay and chassis.vx times chassis.yaw_rate",
              "chassis.ay", true);
    }
    if (wheel && (yaw_rate || ay)) {
        const Channel& turn = yaw_rate ? *yaw_rate : *ay;
        const auto hand = [&](std::size_t i) { return wheel->values[i]; };
        judge(found, fit(log, hand, turn, 0.05), "driver.steering_wheel_angle and " + turn.name, wheel->name, false);
    }
    return found;
}

}  // namespace tread
