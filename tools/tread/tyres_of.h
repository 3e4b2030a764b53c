// The tyres that a car's file names, each with its path.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tread/vehicle.h"

namespace tread {

inline std::vector<std::pair<std::string, const TyreParams*>> tyresOf(const VehicleParams& car) {
    std::vector<std::pair<std::string, const TyreParams*>> tyres;
    const auto add = [&](const std::string& path, const AxleParams& axle) {
        tyres.emplace_back(path + ".tyre", &axle.tyre);
        if (axle.left.tyre) tyres.emplace_back(path + ".left.tyre", &*axle.left.tyre);
        if (axle.right.tyre) tyres.emplace_back(path + ".right.tyre", &*axle.right.tyre);
    };
    add("front", car.front);
    add("rear", car.rear);
    return tyres;
}

}  // namespace tread
