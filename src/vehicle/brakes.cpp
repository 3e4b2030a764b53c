#include "tread/brakes.h"

namespace tread {

PerAxle<double> brakeTorques(const BrakeParams& params, double pedal) {
    const double total = params.full_pedal_torque * pedal;
    return {.front = 0.5 * total * params.front_share, .rear = 0.5 * total * (1 - params.front_share)};
}

}  // namespace tread
