// The tyres of a car's four wheels, evaluated together: the same formulas as for one, and the same bits.
#pragma once

#include "base/math/lanes.h"
#include "tread/tyre.h"

namespace tread {

// What a wheel's road and temperature make of its tyre, as factors on the tyre's own lambdas.
template <class T>
struct BasicTyreFactors {
    T friction = 1;   // on lambda_mux and lambda_muy
    T stiffness = 1;  // on lambda_Kx and lambda_Ky
};
using TyreFactors = BasicTyreFactors<double>;

struct FourTyres {
    BasicTyreCoefficients<Lanes> parameters;
    BasicTyreScaling<Lanes> lambda;
};
FourTyres together(const PerWheel<TyreParams>& tyres);

// Advances contact patches and spins as `advance` in tyre.h does, near standstill with its extension.
PerWheel<TyreForces> advance(PerWheel<TyreState>& states, PerWheel<double>& Omega, const FourTyres& tyres,
                             const PerWheel<TyreFactors>& factors, const PerWheel<TyreMotion>& begin,
                             const PerWheel<TyreMotion>& end, const PerWheel<TyreSpin>& spins, double dt);

}  // namespace tread
