// Golden logs: every scenario file, driven by the compact car, a few channels at a low rate.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "log/log.h"
#include "tread/vehicle.h"

namespace tread::golden {

// Names of the scenarios; and of those with a golden log, which for `x.yaml` is `x.csv`. Sorted.
std::vector<std::string> scenarios();
std::vector<std::string> names();

std::filesystem::path fileOf(const std::string& name);

// The car that drives them.
VehicleParams car();

// The run as the program now drives it, rounded to the digits that a golden log keeps.
Log run(const std::string& name, const VehicleParams& car);

// Against the golden log: as narrow as another order of roundings allows.
Comparison compareToGolden(const std::string& name, const Log& log);

}  // namespace tread::golden
