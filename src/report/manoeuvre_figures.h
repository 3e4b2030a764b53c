// The figures that an engineer of a test expects, by the kind of manoeuvre.
#pragma once

#include <vector>

#include "report/run_report.h"

namespace tread {

// A manoeuvre without a row of its own, or without a name, has path, response to steering and used friction. What the
// log cannot show is left out.
std::vector<Chart> manoeuvreFigures(const RunReport& content);

}  // namespace tread
