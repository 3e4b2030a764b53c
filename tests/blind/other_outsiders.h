// Faults from outside of the catalogue, in the other car.
#pragma once

#include "base/random.h"
#include "blind/other_truth.h"
#include "blind/outsiders.h"
#include "recording/subject.h"

namespace other_car {

// Plants what `outsider` does in tread's car `nominal` in the other one. Those that push the car or spoil readings are
// taken as they are; what they do to numbers of tread's car is done to those of this car. Throws
// std::invalid_argument for one that this car cannot have.
void plant(const tread::Outsider& outsider, const tread::recording::Subject& nominal, Truth& truth,
           tread::Random& random);

}  // namespace other_car
