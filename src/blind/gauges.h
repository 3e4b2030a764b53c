// The instruments on board of the car of a blind case.
#pragma once

#include <string_view>
#include <vector>

#include "recording/instruments.h"

namespace tread {

struct Gauge {
    std::string_view channel;
    recording::Instrument recording::Instruments::*instrument;
    double noise;      // standard deviation of one reading, in the SI unit of the channel
    double vibration;  // amplitude of what engine and road shake it with, at about 8 Hz
};

const std::vector<Gauge>& gauges();

}  // namespace tread
