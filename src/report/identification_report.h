// The report of an identification: the numbers that were found, how sure they are, and how far the gap shrinks.
#pragma once

#include <string>

#include "calibrate/identification.h"

namespace tread {

std::string identificationReport(const std::string& vehicle, const std::string& version,
                                 const calibrate::Identification& found);

}  // namespace tread
