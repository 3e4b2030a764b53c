// What follows from the tyres of a body on wheels.
#include "tyre/standstill.h"
#include "vehicle/wheeled_body.h"

namespace tread {

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
}

}  // namespace tread
