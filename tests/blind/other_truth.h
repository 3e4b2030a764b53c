// The true car of the other simulator, and the map from paths of tread's car to its numbers: effects of the catalogue
// and errors are defined by paths.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/math/random.h"
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
    std::map<std::string, double, std::less<>> low_pass;  // 1/s, corner frequency of slow instruments, by channel
    std::function<tread::Pushing()> push;                 // force of an outsider; called once for each drive
    // Distorts the readings of a drive before noise is added: an outsider in an instrument.
    std::function<void(tread::Log& log, tread::Random& random)> misread;
};

// A number of the other car that follows one of tread's: by `share` of its change, or by the same factor.
struct SharedNumber {
    std::string path;
    double* value;  // points into the Truth
    bool by_factor;
    double share = 1;
};
std::vector<SharedNumber> sharedNumbers(Truth& truth);

// A car of tread as in its file, on a level road in still air, with ideal instruments.
tread::recording::Subject asInFile(const tread::VehicleParams& vehicle);

// `known`, which corresponds to `nominal`, with the changes that lead from `nominal` to `changed`.
Truth withChanges(const Truth& known, const tread::recording::Subject& nominal,
                  const tread::recording::Subject& changed);

// Effects for which the other car has all numbers that `nominal` has.
std::vector<tread::diagnose::catalogue::Effect> plantable(
    const std::vector<tread::diagnose::catalogue::Effect>& effects, const tread::recording::Subject& nominal);

}  // namespace other_car
