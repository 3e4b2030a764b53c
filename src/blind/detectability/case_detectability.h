// Detectability of each fault of a case, computed with tread from the true car.
//
// The change by a fault (delta of detectability.h) is taken at the true car: its readings less those of the same car
// without the fault, driven with the inputs that the instruments of the true car recorded.
#pragma once

#include <map>
#include <string>

#include "blind/detectability/examination.h"
#include "blind/faults/drawn_case.h"

namespace tread::blind::detectability {

// By name of effect and outsider; `examination` is that of DrawnCase::healthy. Throws SimulationError when the car
// without a fault cannot be driven.
std::map<std::string, key::Detectability> detectabilities(const Examination& examination,
                                                          const faults::DrawnCase& drawn, int threads = 0);

}  // namespace tread::blind::detectability
