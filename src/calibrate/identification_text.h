// An identification in words, as a table, as the car that it found, and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "calibrate/identification.h"

namespace tread::calibrate {

// "4 of 5 numbers are determined by these drives; ...".
std::string identificationInWords(const Identification& found);

// The answer, the numbers, how they hang together, how far the gap shrinks.
// What closes most of the gap where the chosen numbers do not; empty where they do.
std::string otherNumbersInWords(const Identification& found);

std::string identificationText(const Identification& found);

nlohmann::ordered_json identificationJson(const Identification& found);

// calibrated.yaml: the nominal car with the fitted numbers, headed by what they rest on.
std::string calibratedVehicleYaml(const recording::Subject& nominal, const Identification& found);

}  // namespace tread::calibrate
