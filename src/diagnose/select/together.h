// How long car and model stay together. A drive is compared until they slide apart (D6). Before it is cut, effects that
// decide when a car slides are tried: a car with less grip than the model slides sooner, which is evidence and no
// reason to look away.
#pragma once

#include "diagnose/model/problem.h"
#include "diagnose/select/fit.h"

namespace tread::diagnose::select {

struct Calibration;

struct Together {
    Deviation at;               // the calibrated car with the effect that keeps them together longest
    std::vector<bool> further;  // per drive: it keeps them together for longer than the calibrated car
    std::map<std::size_t, Deviation> tried = {};  // where each effect that was tried is fitted
};

// Nothing when no drive is cut, or when no effect keeps car and model together for longer than the calibrated car and
// explains more of what is then compared.
std::optional<Together> keptTogether(const Calibration& car);

}  // namespace tread::diagnose::select
