// Height and slopes of an obstacle, also averaged over the contact of a tyre.
#pragma once

#include "tread/road_params.h"

namespace tread {

class ObstacleSurface {
public:
    explicit ObstacleSurface(const Obstacle& obstacle);

    // Averaged over a square of that half side, aligned with the obstacle; 0: the obstacle itself.
    SurfacePoint at(double x, double y, double half_side) const;

private:
    // A profile along one coordinate: its value, slope and integral from minus infinity.
    struct Value {
        double value, slope;
    };
    double profile(double s) const;
    double profileSlope(double s) const;
    double profileIntegral(double s) const;
    Value along(double s, double half) const;
    Value across(double t, double half) const;

    Obstacle obstacle_;
    bool cosine_;
    double rise_;  // m, of a ramp; 0: a step
    double direction_x_, direction_y_;
};

}  // namespace tread
