// What road and air do to a car on a proving ground that no log tells, as processes of the examiner's own: turbulence,
// gusts at random times, a road that waves and has ruts here and there. None of them is an Ornstein-Uhlenbeck process,
// which the diagnosis assumes; their autocovariances are known, which the examiner needs (shows.h).
#pragma once

#include <string_view>
#include <vector>

#include "base/random.h"
#include "run/push.h"
#include "tread/vehicle.h"

namespace tread {

// A random process that pushes in one direction: what it is multiplies `push`.
struct PushSource {
    std::string_view name;
    Push push;                 // for a value of 1, at kSourceSpeed
    bool by_speed = false;     // grows in proportion to the speed of the car, as the air's forces do
    bool by_distance = false;  // a function of the way travelled (m), else of time (s)

    // A sum of waves of random phases, or bumps (1 - cos) / 2 of normally distributed heights at random places.
    struct Wave {
        double amplitude, frequency;  // -; rad/s or rad/m
    };
    std::vector<Wave> waves;
    double bumps_per = 0;    // 1/s or 1/m
    double bump_length = 0;  // s or m
};
inline constexpr double kSourceSpeed = 25;  // m/s

// Of one case: levels are those of a good proving ground on a day with little wind.
std::vector<PushSource> drawnSurroundings(const VehicleParams& nominal, Random& random);

// Of one drive; the same seed gives the same pushes.
Pushing pushingOf(const std::vector<PushSource>& sources, std::uint64_t seed);

// Of the values of a source at places (s or m) so far apart.
double autocovariance(const PushSource& source, double apart);

}  // namespace tread
