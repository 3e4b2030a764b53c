// The step of one car. What it does stands in step.h.

#include "tread/vehicle.h"

#include "tyre/four_tyres.h"
#include "vehicle/recession.h"
#include "vehicle/step.h"

namespace tread {

// ---- The single car among the cars of step.h ----

static VehicleState& stateOf(VehicleState& state, std::size_t) {
    return state;
}
static const Vehicle& carOf(const Vehicle& vehicle, std::size_t) {
    return vehicle;
}
static const VehicleParams& paramsOf(const Vehicle& vehicle, std::size_t) {
    return vehicle.params;
}

// Its four wheels are computed together.
static PerWheel<TyreForces> advanceTyres(PerWheel<WheelState>& wheels, const Vehicle& vehicle, TyreStep<double>& step,
                                         double dt) {
    if (vehicle.tyres_shifted) shiftMotions(step.begin, step.end, vehicle);
    if (vehicle.warmth_felt) applyWarmth(step.factors, wheels, vehicle);
    PerWheel<TyreState> tyres{wheels[0].tyre, wheels[1].tyre, wheels[2].tyre, wheels[3].tyre};
    PerWheel<double> spin{wheels[0].spin, wheels[1].spin, wheels[2].spin, wheels[3].spin};
    const PerWheel<TyreForces> forces =
        advance(tyres, spin, *vehicle.tyres, step.factors, step.begin, step.end, step.torques, dt);
    for (std::size_t i = 0; i < kWheels; ++i) {
        wheels[i].tyre = tyres[i];
        wheels[i].spin = spin[i];
    }
    return forces;
}

void advance(ChassisMotion& motion, VehicleState& state, const Vehicle& vehicle, const VehicleInput& begin,
             const VehicleInput& end, const Surroundings& surroundings, double dt) {
    step<double>(motion, state, vehicle, Inputs{&begin, &end},
                 BasicSurroundings<double, Road>{surroundings.road, surroundings.gravity_W, surroundings.wind_W}, dt);
}

}  // namespace tread
