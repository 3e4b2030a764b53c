// The report of an identification: the numbers that were found, how sure they are, and how far the gap shrinks.
#pragma once

#include <string>

#include "diagnose/identification.h"

namespace tread {

std::string identificationReport(const std::string& vehicle, const std::string& version, const Identification& found);

}  // namespace tread
