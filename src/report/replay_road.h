// The road of a replay as the page's script draws it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "scenario/course.h"
#include "tread/road_params.h"

namespace tread {

// `way`: places that the cars pass, around which the road is drawn.
//
// The plane with its friction patches, and where the road is no plane its surface beside the way, as square tiles whose
// heights count from the plane.
nlohmann::ordered_json replayRoad(const RoadParams& road, std::span<const Point> way);

}  // namespace tread
