// The cross-plots of a run. Each is empty when the log lacks a channel that it needs.
#pragma once

#include <optional>
#include <vector>

#include "log/log.h"
#include "report/car_shape.h"
#include "report/svg.h"

namespace tread {

// The path seen from above, with the car's outline at a few moments. Lengths in metres.
std::optional<Chart> pathFigure(const Log& log, const CarShape& car);

// Fx/Fz against Fy/Fz, with the circle of friction 1 for scale: of all wheels in one figure, or one figure each.
std::optional<Chart> frictionFigure(const Log& log);
std::vector<Chart> wheelFrictionFigures(const Log& log);

// Lateral acceleration against steering-wheel angle; nothing for a run without steering.
std::optional<Chart> steeringFigure(const Log& log);

// Longitudinal against lateral acceleration, with the circle of 1 g.
std::optional<Chart> accelerationFigure(const Log& log);

struct Pose {
    double time, x, y, yaw;
};

// The car's outline from above, closed, with a pointed nose.
Series carOutline(const Pose& pose, double ahead, double behind, double width);

}  // namespace tread
