// Where a diagnosis draws its lines. Set on development cases (seeds 2001 to 2004, 3001, 3101 and 3201 of blind checks)
// and on the rows of the catalogue planted one by one; checked on 120 cases drawn after that (seed 5001).
#pragma once

namespace tread {

struct Thresholds {
    double testable = 6;        // nats to expect at typical size: below, an effect cannot be seen in these drives
    double separable = 6;       // nats between two effects
    double effect = 7;          // nats that one effect must gain over none: in empty cases the best gained 9
    double further_effect = 6;  // nats that one more effect must gain
    double unknown = 6;         // nats that larger disturbances gain on top of the best model
    double constancy = 5;       // Cochran's Q over its degrees of freedom: the same effect in every drive
    double constancy_p = 1e-3;
    double constancy_spread = 0.25;      // large effects differ by a tenth from drive to drive: the fit is linear there
    double look_alike = 40;              // nats of the best effects, below which their constancy says nothing
    double look_alike_inflation = -2.5;  // nats of larger disturbances, per drive: with known causes it was -3 to -11
    double temperature = 1.5;            // evidence counts as if this many times as much data were needed
    double sure = 0.9;                   // probability of the causes together, below which alternatives are named
    double credible = 0.9;
};

inline constexpr Thresholds kThresholds{};

}  // namespace tread
