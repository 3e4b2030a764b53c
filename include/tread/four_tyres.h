// The tyres of a car's four wheels, evaluated together: the same formulas as for one, and the same bits.
#pragma once

#include "tread/lanes.h"
#include "tread/tyre.h"

namespace tread {

struct FourTyres {
    BasicTyreCoefficients<Lanes> parameters;
    BasicTyreScaling<Lanes> lambda;
};
FourTyres together(const PerWheel<TyreParams>& tyres);

// Advances contact patches and spins as `advance` in tyre.h does, near standstill with its extension; `friction` is
// that of the road under each wheel, as a factor on both lambda_mu.
PerWheel<TyreForces> advance(PerWheel<TyreState>& states, PerWheel<double>& Omega, const FourTyres& tyres,
                             const PerWheel<double>& friction, const PerWheel<TyreMotion>& begin,
                             const PerWheel<TyreMotion>& end, const PerWheel<TyreSpin>& spins, double dt);

}  // namespace tread
