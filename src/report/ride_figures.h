// Figures of rides on uneven roads.
#pragma once

#include <vector>

#include "log/log.h"
#include "report/svg.h"

namespace tread {

// Vertical acceleration over time, its spectrum as it is and weighted by Wk (ISO 2631-1), and the spectra of the wheel
// loads, over the time that the metrics evaluate. What the log lacks is left out.
std::vector<Chart> rideFigures(const Log& log);

// One obstacle: vertical acceleration and wheel loads over time.
std::vector<Chart> bumpFigures(const Log& log);

}  // namespace tread
