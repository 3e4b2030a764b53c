// An identification as a sentence, as a table, as the vehicle file that it found, and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "calibrate/identification.h"

namespace tread::calibrate {

// "4 of 5 numbers are determined by these drives; ...".
std::string identificationInWords(const Identification& found);

// Yes when the drives determine every number, the fit has converged and the car has become better: the exit status of
// the command and the sign of the page's badge.
bool hasSucceeded(const Identification& found);
// "determined", or what is wrong first.
std::string outcomeInWords(const Identification& found);

// The other numbers that close most of the gap, if the chosen numbers do not; otherwise empty.
std::string otherNumbersInWords(const Identification& found);

std::string identificationText(const Identification& found);

nlohmann::ordered_json identificationJson(const Identification& found);

// Text of calibrated.yaml: the nominal car with the fitted numbers, below a comment on their origin.
std::string calibratedVehicleYaml(const recording::Subject& nominal, const Identification& found);

}  // namespace tread::calibrate
