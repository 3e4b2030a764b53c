// Report of the parts of drives that are left out, with the reason.
#pragma once

#include <string>
#include <vector>

#include "recording/recorded_drive.h"

namespace tread::recording::checks {

// For each drive that ends at a finite `until`, s: a sentence or two.
std::vector<std::string> leftOut(Drives drives, const std::vector<double>& until);

}  // namespace tread::recording::checks
