// Cars on their road, moving: what a page needs to replay logs in three dimensions.
#pragma once

#include <string>
#include <vector>

#include "log/log.h"
#include "report/car_shape.h"
#include "report/palette.h"
#include "scenario/scenario.h"

namespace tread {

struct ReplayCar {
    std::string name;
    const Log& log;
    CarShape shape;
    Colour colour = Colour::blue;
};

struct ReplayScene {
    RoadParams road = {};
    std::vector<Point> cones = {};
};
ReplayScene sceneOf(const Scenario& scenario);

// JSON for the page's script; empty when no log says where its car is (chassis.x, chassis.y, chassis.yaw). Cars whose
// log does not are left out; other channels that are missing do not move.
std::string replayData(const std::vector<ReplayCar>& cars, const ReplayScene& scene);

}  // namespace tread
