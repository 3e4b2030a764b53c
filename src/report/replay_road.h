// The road of a replay as the page's script draws it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "tread/road_params.h"

namespace tread {

// Places that the cars pass; the drawn part of the road lies around them.
struct WayPoint {
    double x, y;  // m
};

// The plane with its friction patches, and where the road is no plane its surface beside the way, as square tiles whose
// heights count from the plane.
nlohmann::ordered_json replayRoad(const RoadParams& road, std::span<const WayPoint> way);

}  // namespace tread
