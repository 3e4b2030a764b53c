// `tread tyre --table`: steady-state forces at the points of a table.
#pragma once

#include <cstddef>

#include "commands.h"
#include "tread/tyre.h"
#include "tyre_axes.h"

namespace tread::program {

// Reads columns Fz, gamma, Vx, Vsx, Vsy (TyreSlip) and any lambda_<name> (TyreScaling), which takes the place of the
// tyre's own factor in its row; writes them as given, followed by the fields of TyreSteadyState. Returns the number of
// points. An empty output is standard output.
std::size_t writeSteadyTable(const TyreParams& tyre, const Path& input, Axes axes, const std::string& output);

}  // namespace tread::program
