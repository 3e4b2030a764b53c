// Readings of the instruments for a motion of the car.
#pragma once

#include <string>
#include <vector>

#include "log/log.h"
#include "recording/instruments.h"

namespace tread::recording {

// A channel that a diagnosis can use, and the instrument that measures it.
struct ObservedQuantity {
    std::string channel;
    Instrument Instruments::*instrument;
    std::string subsystem;  // name of the quantity in answers
};
const std::vector<ObservedQuantity>& observedQuantities();
std::string observedQuantitiesListed();

// Readings of an instrument at the times of its samples. The rows of `motion` are evenly spaced from time 0 (D2), (D4).
std::vector<double> readings(const Log& motion, const Instruments& instruments, const ObservedQuantity& quantity,
                             const std::vector<double>& times);

}  // namespace tread::recording
