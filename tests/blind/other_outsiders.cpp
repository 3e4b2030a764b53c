#include "blind/other_outsiders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "blind/world/draws.h"
#include "recording/subject.h"

namespace other_car {
namespace {

using tread::blind::faults::Outsider;
using tread::blind::world::between;
using tread::blind::world::eitherSign;

// A drag torque on one front wheel.
void stickCaliper(Params& car, tread::Random& random) {
    const double torque = between(random, 60, 150);  // N m
    car.wheels[eitherSign(random) < 0 ? 0 : 1].drag_torque = torque;
}

// One tyre with low pressure: less cornering stiffness, smaller radii.
void softenTyre(Params& car, tread::Random& random) {
    const std::size_t wheel = (eitherSign(random) < 0 ? 0u : 2u) + (eitherSign(random) < 0 ? 0u : 1u);
    car.wheels[wheel].stiffness = between(random, 0.55, 0.7);
    car.wheels[wheel].smaller = between(random, 0.003, 0.005);  // m
}

void curveRatio(Params& car, tread::Random& random) {
    constexpr double kAngle = std::numbers::pi / 2;  // rad, at which the ratio has changed by the share below
    car.ratio_curvature = eitherSign(random) * between(random, 0.12, 0.25) / (kAngle * kAngle);
}

// Outsiders that change numbers of the car.
struct Own {
    std::string_view name;
    void (*plant)(Params&, tread::Random&);
};
constexpr std::array kOwn{Own{"stuck_caliper", stickCaliper}, Own{"soft_tyre", softenTyre},
                          Own{"cubic_steering_ratio", curveRatio}};

}  // namespace

void plant(const Outsider& outsider, const tread::recording::Subject& nominal, Truth& truth, tread::Random& random) {
    const auto own = std::find_if(kOwn.begin(), kOwn.end(), [&](const Own& one) { return one.name == outsider.name; });
    if (own != kOwn.end()) return own->plant(truth.car, random);
    tread::blind::world::Truth as_tread;
    as_tread.car = nominal;
    outsider.plant(as_tread, random);
    if (!as_tread.push && !as_tread.misread && as_tread.low_pass.empty())
        throw std::invalid_argument("the other car cannot have the outsider " + outsider.name);
    truth.push = as_tread.push;
    truth.misread = as_tread.misread;
    truth.low_pass = as_tread.low_pass;
}

}  // namespace other_car
