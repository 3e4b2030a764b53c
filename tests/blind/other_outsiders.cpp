#include "blind/other_outsiders.h"

#include <numbers>
#include <stdexcept>

#include "blind/world/draws.h"
#include "recording/subject.h"

namespace other_car {
namespace {

using tread::blind::faults::Outsider;
using tread::blind::world::between;
using tread::blind::world::eitherSign;

// A steering ratio that changes with the square of the steering-wheel angle.
void curveRatio(Params& car, tread::Random& random) {
    constexpr double kAngle = std::numbers::pi / 2;  // rad, at which the ratio has changed by the share below
    car.ratio_curvature = eitherSign(random) * between(random, 0.12, 0.25) / (kAngle * kAngle);
}

}  // namespace

void plant(const Outsider& outsider, const tread::recording::Subject& nominal, Truth& truth, tread::Random& random) {
    if (outsider.name == "cubic_steering_ratio") return curveRatio(truth.car, random);
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
