// Warnings about numbers that a file or an option may give and yet hardly means: where they stand, what is plausible,
// which slip explains them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "run/simulate.h"
#include "scenario/scenario.h"
#include "tread/problem.h"
#include "tread/tyre.h"
#include "tread/vehicle.h"

namespace tread::program {

// Settings that were applied over a file, the later over the earlier.
struct AppliedSettings {
    std::span<const std::string> assignments;  // path=value
    std::string source;                        // "--set", or a file
    std::string prefix = {};                   // of the paths, "scenario."
    std::string list = {};  // path of the list in the file, "car_settings"; empty: `source` is no file
};

// One for each implausible number, with the place of its value: the last setting of it, else the file. A number of an
// included file that two axles share is named once.
std::vector<Problem> implausibleIn(const VehicleParams& car, const std::string& file,
                                   const std::vector<AppliedSettings>& settings = {});
std::vector<Problem> implausibleIn(const TyreParams& tyre, const std::string& file,
                                   const std::vector<AppliedSettings>& settings = {});
std::vector<Problem> implausibleIn(const Scenario& scenario, const std::string& file,
                                   const std::vector<AppliedSettings>& settings = {});

// "warning: car.yaml:14:27: ...": to standard error, each once as long as the program runs; with `strict` LoadError.
void warnOfImplausible(const std::vector<Problem>& warnings, bool strict = false);

// What failed, and which inputs are suspected: at most three of the implausible numbers; where there is none and the
// numbers are what is to be looked at, that.
std::string withSuspects(const SimulationError& error, const std::vector<Problem>& implausible);

}  // namespace tread::program
