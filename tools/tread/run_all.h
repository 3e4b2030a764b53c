// The whole catalogue with one car.
#pragma once

#include "commands.h"

namespace tread::program {

// Drives every scenario of the folder `options.all`; a faulty file or a run that fails does not stop the others.
int runAll(const RunOptions& options);

}  // namespace tread::program
