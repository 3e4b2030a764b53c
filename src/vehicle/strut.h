// A massless strut in series with a tyre: how far each gives way, and the load between tyre and road.
#pragma once

#include "vehicle/wheeled_body.h"

namespace tread {

// What the road does to the wheel when the strut is fully extended.
struct StrutPush {
    double deflection;  // m, of the tyre; negative when it does not reach the road
    double closing;     // m/s, rate of that deflection
    double lift;        // m of deflection lost per m of compression
    double share;       // component along the strut of a normal force of 1
    double before;      // m, that deflection as it was at the start of the step
    double heaving;  // s/kg, change of the body's speed within the step, per force that every wheel has: up and down,
    double turning;  // s/kg, and where the wheels are, in roll or pitch
};
struct StrutYield {
    double compression;  // m
    double rate;         // m/s
    double force;        // N, of the strut
    double deflection;   // m, of the tyre
    double load;         // N, normal to the road
};

// Implicit in the compression, so that any damper and any step are stable. `partner` is the compression of the wheel
// at the other end of the anti-roll bar.
StrutYield yield(const StrutParams& params, const TyreParams& tyre, const StrutPush& push, double compression,
                 double partner, double dt);

}  // namespace tread
