// Readings of the instruments for a motion of the car.
#pragma once

#include <string>
#include <string_view>
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

// The quantity that a channel shows, of the first instrument or of a further one; nullptr when a diagnosis cannot use
// it.
const ObservedQuantity* observedQuantity(std::string_view channel);

// The log's channel of a quantity: that of the first instrument, otherwise the one from positions, otherwise of another
// further instrument; nullptr without any.
const Channel* measuredAs(const Log& log, std::string_view quantity);

// The instrument that reads a channel. A further instrument that is not described is ideal.
Instrument instrumentOf(const Instruments& instruments, std::string_view channel);
std::string observedQuantitiesListed();

// Readings of the instrument of a channel at the times of its samples. The rows of `motion` are evenly spaced from time
// 0; before it the car is taken to have moved as at time 0 (D2), (D4). The channel must be one that a diagnosis can
// use.
std::vector<double> readings(const Log& motion, const Instruments& instruments, std::string_view channel,
                             const std::vector<double>& times);

}  // namespace tread::recording
