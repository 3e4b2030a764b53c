// A car of the other simulator as a blind check sees it: under which of tread's paths it has which number, so that the
// effects of the catalogue can be planted in it and its numbers can err as tread's do.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/random.h"
#include "diagnose/catalogue/effect.h"
#include "log/log.h"
#include "recording/instruments.h"
#include "recording/subject.h"
#include "run/push.h"
#include "shared/other_car/car.h"
#include "tread/vehicle.h"

namespace other_car {

struct Truth {
    Params car;
    tread::recording::Instruments instruments;
    double steering_delay = 0, brake_delay = 0;           // s
    std::map<std::string, double, std::less<>> low_pass;  // 1/s, by channel: instruments that are slow
    std::function<tread::Pushing()> push;                 // from outside the catalogue; asked once for each drive
    // What instruments from outside the catalogue make of the readings of a drive, before their noise.
    std::function<void(tread::Log& log, tread::Random& random)> misread;
};

// A number of the other car that changes with one of tread's: by a share of it, or by the same factor.
struct SharedNumber {
    std::string path;
    double* value;  // in the truth; valid as long as that is not moved
    bool by_factor;
    double share = 1;
};
std::vector<SharedNumber> sharedNumbers(Truth& truth);

// A tread car with nothing wrong and nothing around it.
tread::recording::Subject asInFile(const tread::VehicleParams& vehicle);

// `known` goes with `nominal`: the other car with the changes that lead from `nominal` to `changed`.
Truth withChanges(const Truth& known, const tread::recording::Subject& nominal,
                  const tread::recording::Subject& changed);

// The effects of which the other car has all numbers that `nominal` has.
std::vector<tread::diagnose::catalogue::Effect> plantable(
    const std::vector<tread::diagnose::catalogue::Effect>& effects, const tread::recording::Subject& nominal);

}  // namespace other_car
