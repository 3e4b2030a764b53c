// Outsiders in the other car.
#pragma once

#include "base/math/random.h"
#include "blind/faults/outsiders.h"
#include "blind/other_truth.h"
#include "recording/subject.h"

namespace other_car {

// Plants `outsider`. Forces and distorted readings are those that it has in tread's car `nominal`; changes of numbers
// of the car are made by functions of this file. Throws std::invalid_argument for an outsider that the car cannot have.
void plant(const tread::blind::faults::Outsider& outsider, const tread::recording::Subject& nominal, Truth& truth,
           tread::Random& random);

}  // namespace other_car
