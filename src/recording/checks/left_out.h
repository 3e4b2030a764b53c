// What is left out of the drives, and why.
#pragma once

#include <string>
#include <vector>

#include "recording/recorded_drive.h"

namespace tread::recording::checks {

// Of each drive what comes after `until`, s: a sentence or two each.
std::vector<std::string> leftOut(Drives drives, const std::vector<double>& until);

}  // namespace tread::recording::checks
