// A car of the other simulator as a blind check sees it: under which of tread's paths it has which number, so that the
// effects of the catalogue can be planted in it and its numbers can err within tread's tolerances.
#pragma once

#include <string>
#include <vector>

#include "base/random.h"
#include "blind/key.h"
#include "diagnose/catalogue/effect.h"
#include "recording/instruments.h"
#include "shared/other_car/car.h"
#include "tread/vehicle.h"

namespace other_car {

struct Truth {
    Params car;
    tread::recording::Instruments instruments;
    double steering_delay = 0, brake_delay = 0;  // s
};

// A number of the other car that changes with one of tread's: by as much, or by the same factor.
struct SharedNumber {
    std::string path;
    std::vector<double*> values;  // in the truth; valid as long as that is not moved
    bool by_factor;
};
std::vector<SharedNumber> sharedNumbers(Truth& truth);

// The effects of which the other car has all numbers that `nominal` has.
std::vector<tread::diagnose::catalogue::Effect> plantable(
    const std::vector<tread::diagnose::catalogue::Effect>& effects, const tread::VehicleParams& nominal);

// A car with small errors in all shared numbers, and with one effect unless the kind is `none`.
struct Drawn {
    Truth truth;
    Truth before;  // without the effect
    tread::CaseKey key;
};
Drawn draw(const Truth& known, const tread::VehicleParams& nominal,
           const std::vector<tread::diagnose::catalogue::Effect>& effects, tread::CaseKind kind, tread::Random& random);

}  // namespace other_car
