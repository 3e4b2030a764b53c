// Unmeasured forces of road and air in World::own: turbulence, gusts at random times, road undulation and ruts. None is
// an Ornstein-Uhlenbeck process, which is what the diagnosis assumes. Their autocovariances are known in closed form;
// detectability is computed from them.
#pragma once

#include <string_view>
#include <vector>

#include "base/math/random.h"
#include "run/push.h"
#include "tread/vehicle.h"

namespace tread::blind::world {

// A scalar random process times a fixed force and moment.
struct PushSource {
    std::string_view name;
    Push push;                 // at process value 1 and kSourceSpeed
    bool by_speed = false;     // proportional to the speed of the car, as forces of the air
    bool by_distance = false;  // the process runs over distance travelled (m), else over time (s)

    // Either cosines of random phase, or bumps (1 - cos) / 2 of normally distributed height that begin at the points of
    // a Poisson process.
    struct Wave {
        double amplitude, frequency;  // -; rad/s or rad/m
    };
    std::vector<Wave> waves;
    double bumps_per = 0;    // 1/s or 1/m, rate of the bumps
    double bump_length = 0;  // s or m
};
inline constexpr double kSourceSpeed = 25;  // m/s

// Surroundings of one case, at the level of a good proving ground on a day with little wind.
std::vector<PushSource> drawnSurroundings(const VehicleParams& nominal, Random& random);

// Forces in one drive. Deterministic in the seed.
Pushing pushingOf(const std::vector<PushSource>& sources, std::uint64_t seed);

// Autocovariance of the process at a lag of `apart` (s or m).
double autocovariance(const PushSource& source, double apart);

}  // namespace tread::blind::world
