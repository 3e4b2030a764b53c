// One step of four tyres together, to be included after TREAD_ISA is set: compiled once per instruction set.
#pragma once

#include "tyre/contact_patch.h"
#include "tyre/four_tyres.h"

namespace tread {

// What `advance` of four_tyres.h takes.
struct FourTyresStep {
    PerWheel<TyreState>& states;
    PerWheel<double>& Omega;
    const FourTyres& tyres;
    const PerWheel<TyreFactors>& factors;
    const PerWheel<TyreMotion>& begin;
    const PerWheel<TyreMotion>& end;
    const PerWheel<TyreSpin>& spins;
    double dt;
};

inline namespace TREAD_ISA {

inline Lanes together(const PerWheel<double>& x) {
    return Lanes(Lanes::Vector{x.front_left, x.front_right, x.rear_left, x.rear_right});
}

template <template <class> class Struct>
PerWheel<Struct<double>> perWheel(const Struct<Lanes>& lanes) {
    return {ofWheel(lanes, 0), ofWheel(lanes, 1), ofWheel(lanes, 2), ofWheel(lanes, 3)};
}

inline PerWheel<TyreForces> take(const FourTyresStep& s) {
    BasicTyreScaling<Lanes> lambda = s.tyres.lambda;
    const auto factors = together<BasicTyreFactors>(s.factors);
    lambda.mux *= factors.friction;
    lambda.muy *= factors.friction;
    lambda.Kx *= factors.stiffness;
    lambda.Ky *= factors.stiffness;

    BasicTyreState<Lanes> state = together<BasicTyreState>(s.states);
    Lanes Omega = together(s.Omega);
    const BasicTyreSpin<Lanes> spin = together<BasicTyreSpin>(s.spins);
    const auto forces = advance<Lanes>(state, Omega, {s.tyres.parameters, lambda}, together<BasicTyreMotion>(s.begin),
                                       together<BasicTyreMotion>(s.end), FreeSpin<Lanes>{spin}, s.dt, Standstill::hold);
    s.states = perWheel(state);
    s.Omega = {Omega[0], Omega[1], Omega[2], Omega[3]};
    return perWheel(forces);
}

}  // namespace TREAD_ISA
}  // namespace tread
