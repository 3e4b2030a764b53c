#include "tread/steering.h"

#include <cmath>

namespace tread {

RoadWheelAngles roadWheelAngles(const SteeringParams& params, double steering_wheel_angle, double track,
                                double wheelbase) {
    const double mean = steering_wheel_angle / params.ratio;
    if (params.ackermann == 0) return {mean, mean};
    // The turn centre lies on the rear axle's extension, wheelbase / tan(mean) to the left.
    const double tangent = std::tan(mean);
    const double offset = params.ackermann * 0.5 * track / wheelbase * tangent;
    return {std::atan(tangent / (1 - offset)), std::atan(tangent / (1 + offset))};
}

}  // namespace tread
