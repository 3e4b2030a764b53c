// Where a diagnosis draws its lines. Set on development cases (seeds 2001 to 2004, 3001, 3101, 3201, 5001, 6007, 6203,
// 8111, 9111, 9112, 10111, 10113, 11111 and 11113 of blind checks) and on the rows of the catalogue planted one by one;
// checked on cases drawn after that.
#pragma once

#include <algorithm>
#include <cstddef>

namespace tread::diagnose {

struct Settings {
    double effect = 5;              // nats that one effect must gain over none: in empty cases the best never gained 3
    double further_effect = 5;      // nats that one more effect must gain,
    double further_share = 0.002;   // and of the nats explained already: no signature is known better than that,
    double further_most = 6;        // but of these no more nats than this
    double structure = 0.25;        // share of a value by which a model of another structure than the car's errs,
    double structure_share = 0.15;  // and of the nats explained, that one more effect then seems to explain
    double unknown = 6;             // nats over the best model, that larger disturbances or a law of forces gain
    double separable = 6;           // nats between two effects
    double shows = 6;               // nats to expect of an effect: below, a drive cannot show it
    double testable = 22;           // nats to expect at typical size: 19 in 20 such effects gain `effect`, see below
    double sure = 0.9;              // probability of the causes together, below which alternatives are named
    double credible = 0.9;

    // Nats of effects besides the first that are not to be trusted when so many are explained in all; more of them
    // where recordings are `compared` with references, for there the model may have another structure (D30).
    double structureAllowance(std::size_t effects, double evidence, bool compared) const {
        if (effects < 2) return 0;
        return static_cast<double>(effects - 1) *
               (compared ? structure_share * evidence : std::min(further_share * evidence, further_most));
    }
};

// An effect of s times its typical size, of which n nats were to be expected at that, gains (z + s sqrt(2 n))^2 / 2 -
// ln(1 + 2 n) / 2 with z standard normal: the last is for its freedom. Of sizes from 0.6 to 1.6, evenly, 96 in 100 gain
// `effect` when n is `testable`.
inline constexpr Settings kSettings{};

}  // namespace tread::diagnose
