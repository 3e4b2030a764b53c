// Two folders of runs against each other: a baseline and what a change has made of it.
#pragma once

#include "commands.h"

namespace tread::program {

// Runs are matched by the names of their folders. Status 0: all are within tolerance, 1: some are not, or only one side
// has them, 2: nothing was compared.
int compareFolders(const CompareOptions& options);

}  // namespace tread::program
