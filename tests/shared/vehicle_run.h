// Short drives for tests and benchmarks: a shipped car, a scenario, changed as a test needs it.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "places/places.h"
#include "run/simulate.h"
#include "scenario/load.h"
#include "tread/load.h"

namespace tread::shared {

inline VehicleParams compact() {
    return loadVehicle(sourceFile("vehicles/compact.yaml"));
}
inline VehicleParams sedan() {
    return loadVehicle(sourceFile("vehicles/rear_drive_sedan.yaml"));
}
inline Scenario scenario(const std::string& name) {
    return loadScenario(sourceFile("scenarios/" + name + ".yaml"));
}

inline const std::vector<double>& channel(const Log& log, std::string_view name) {
    const Channel* found = log.find(name);
    if (!found) throw std::runtime_error("no channel " + std::string(name));
    return found->values;
}

// Linear interpolation in time.
inline double valueAt(const Log& log, std::string_view name, double time) {
    const auto& t = channel(log, "time");
    const auto& y = channel(log, name);
    const auto right = std::upper_bound(t.begin(), t.end(), time);
    if (right == t.begin()) return y.front();
    if (right == t.end()) return y.back();
    const auto i = static_cast<std::size_t>(right - t.begin());
    return y[i - 1] + (y[i] - y[i - 1]) * (time - t[i - 1]) / (t[i] - t[i - 1]);
}

inline double peak(const Log& log, std::string_view name) {
    double largest = 0;
    for (const double x : channel(log, name)) largest = std::max(largest, std::abs(x));
    return largest;
}

}  // namespace tread::shared
