// What a locked wheel of the test's car gives over its load.
#pragma once

#include "stock_vs_tread/scene.h"
#include "tread/tyre.h"

namespace tread {

// The tyre's formulas at full slip.
inline double lockedFriction(double friction) {
    TyreParams tyre = similarTyre(0.25 * 1500 * scene::kGravity, 0.3);
    tyre.lambda.mux = tyre.lambda.muy = friction;
    const double load = tyre.parameters.Fzo;
    return -steadyState(tyre, {.Fz = load, .gamma = 0, .Vx = 15, .Vsx = 15, .Vsy = 0}).Fx / load;
}

}  // namespace tread
