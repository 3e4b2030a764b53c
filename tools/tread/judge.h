// A simulation judged against measurements: `tread compare --envelope`, `--score`.
#pragma once

#include "commands.h"

namespace tread::program {

int judge(const CompareOptions& options);

}  // namespace tread::program
