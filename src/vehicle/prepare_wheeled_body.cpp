// What follows from the tyres of a body on wheels.
#include <algorithm>
#include <cmath>

#include "tyre/standstill.h"
#include "vehicle/tyre_load.h"
#include "vehicle/wheeled_body.h"

namespace tread {

namespace {

Yielding yieldingOf(const WheeledBody& body) {
    Vector3 arms = Vector3::Zero();
    for (std::size_t i = 0; i < body.wheel_count; ++i)
        arms += body.wheels[i].top_B.cross(body.wheels[i].down_B).cwiseAbs2();
    return {static_cast<double>(body.wheel_count) / body.mass, arms.cwiseProduct(body.inverse_inertia).maxCoeff()};
}

// The stiffness of all carcasses together, along and across, against the mass and the inertia about the other axis.
double rockingRate(const WheeledBody& body) {
    double along = 0, across = 0;
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        const BodyWheel& wheel = body.wheels[i];
        const TyreCoefficients& p = wheel.tyre.parameters;
        const Vector3 forward_B = wheel.left_B.cross(-wheel.down_B);
        const double height = wheel.top_B.dot(wheel.down_B) + wheel.strut.length + p.Ro;
        const auto yielding = [&](const Vector3& axis_B) {
            return 1 / body.mass + height * height * body.inverse_inertia.dot(axis_B.cwiseAbs2());
        };
        along += p.cFx * yielding(wheel.left_B);
        across += p.cFy * yielding(forward_B);
    }
    return std::sqrt(std::max(along, across));
}

// Springs and tyres together, against the mass and the inertia about each axis.
double bouncingRate(const WheeledBody& body) {
    double heave = 0;
    Vector3 turning = Vector3::Zero();
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        const BodyWheel& wheel = body.wheels[i];
        const double stiffness = 1 / (1 / wheel.strut.stiffness + 1 / radialStiffness(wheel.tyre));
        heave += stiffness / body.mass;
        turning += stiffness * wheel.top_B.cross(wheel.down_B).cwiseAbs2().cwiseProduct(body.inverse_inertia);
    }
    return std::sqrt(std::max(heave, turning.maxCoeff()));
}

}  // namespace

double longestStep(const WheeledBody& body, const WheeledBodyState& state) {
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        const BodyWheelState& wheel = state.wheels[i];
        if (wheel.touches && standstillSpeed(wheel.motion) < kNoHoldSpeed)
            return kFollowed / std::max(body.bouncing, body.rocking);
    }
    return kFollowed / body.bouncing;
}

void prepareTyres(WheeledBody& body) {
    for (std::size_t first = 0; first < body.wheel_count; first += kWheels) {
        PerWheel<TyreParams> tyres;
        for (std::size_t k = 0; k < kWheels; ++k)
            tyres[k] = body.wheels[first + k < body.wheel_count ? first + k : first].tyre;
        body.packs[first / kWheels] = together(tyres);
    }
    for (std::size_t i = 0; i < body.wheel_count; ++i) {
        const TyreParams& tyre = body.wheels[i].tyre;
        const auto nominal = delft97::loadCoefficients(tyre.parameters, tyre.lambda, tyre.parameters.Fzo, 0.0);
        const SlipLimit<double> peaks = slipLimit(nominal, 1.0);
        body.peak_ratio[i] = peaks.kappa_peak;
        body.peak_angle[i] = peaks.alpha_peak;
    }
    body.yielding = yieldingOf(body);
    body.bouncing = bouncingRate(body);
    body.rocking = rockingRate(body);
}

}  // namespace tread
