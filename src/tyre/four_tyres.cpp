#include "tyre/four_tyres.h"

#include "tyre/four_tyres_step.h"

namespace tread {

PerWheel<TyreForces> takeWithAvx2(const FourTyresStep& step);  // four_tyres_avx2.cpp

namespace {

bool hasAvx2() {
#ifdef __x86_64__
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

}  // namespace

FourTyres together(const PerWheel<TyreParams>& t) {
    return {together<BasicTyreCoefficients>(
                {t.front_left.parameters, t.front_right.parameters, t.rear_left.parameters, t.rear_right.parameters}),
            together<BasicTyreScaling>(
                {t.front_left.lambda, t.front_right.lambda, t.rear_left.lambda, t.rear_right.lambda})};
}

PerWheel<TyreForces> advance(PerWheel<TyreState>& states, PerWheel<double>& Omega, const FourTyres& tyres,
                             const PerWheel<TyreFactors>& factors, const PerWheel<TyreMotion>& begin,
                             const PerWheel<TyreMotion>& end, const PerWheel<TyreSpin>& spins, double dt) {
    static const bool avx2 = hasAvx2();
    const FourTyresStep step{states, Omega, tyres, factors, begin, end, spins, dt};
    return avx2 ? takeWithAvx2(step) : take(step);
}

}  // namespace tread
