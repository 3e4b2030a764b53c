// The cross-plots of a run. Each is empty when the log lacks a channel that it needs.
#pragma once

#include <optional>

#include "log/log.h"
#include "report/car_shape.h"
#include "report/svg.h"

namespace tread {

// The path seen from above, with the car's outline at a few moments. Lengths in metres.
std::optional<Chart> pathFigure(const Log& log, const CarShape& car);

// Fx/Fz against Fy/Fz of each wheel, with the circle of friction 1 for scale.
std::optional<Chart> frictionFigure(const Log& log);

// Lateral acceleration against steering-wheel angle.
std::optional<Chart> steeringFigure(const Log& log);

// The channel of that name when it has a value for every moment of the log, otherwise nullptr.
const Channel* completeChannel(const Log& log, std::string_view name);

}  // namespace tread
