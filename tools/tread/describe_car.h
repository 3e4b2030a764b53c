// `tread describe car.yaml`: the data sheet of a car.
#pragma once

#include "commands.h"

namespace tread::program {

int describeCar(const DescribeOptions& options);

}  // namespace tread::program
