#include "sheet/braking.h"

#include <limits>

namespace tread::sheet {
namespace {

constexpr int kPedals = 2000;

double idealForceShare(const AtRest& rest, std::size_t axle, double deceleration) {
    const double own = rest.axleLoad(axle) / (rest.axleLoad(0) + rest.axleLoad(1));
    return own + (axle == 0 ? 1 : -1) * deceleration * rest.height / rest.car().wheelbase;
}

}  // namespace

Braking brakingAt(const AtRest& rest, double pedal) {
    const BrakeParams& brakes = rest.car().brakes;
    const double knee = brakes.rear_proportioning.knee / brakes.full_pedal_pressure;
    const double rear = pedal <= knee ? pedal : knee + brakes.rear_proportioning.slope * (pedal - knee);
    const double weight = rest.car().mass * kStandardGravity;
    Braking result{};
    result.force = {brakes.full_pedal_torque * brakes.front_share * pedal / rest.meanRadius(0) / weight,
                    brakes.full_pedal_torque * (1 - brakes.front_share) * rear / rest.meanRadius(1) / weight};
    result.deceleration = result.force.front + result.force.rear;
    for (std::size_t axle = 0; axle < kAxles; ++axle)
        result.use[axle] = result.force[axle] / idealForceShare(rest, axle, result.deceleration);
    return result;
}

double frontShare(const AtRest& rest) {
    const BrakeParams& brakes = rest.car().brakes;
    const double front = brakes.front_share / rest.meanRadius(0), rear = (1 - brakes.front_share) / rest.meanRadius(1);
    return front / (front + rear);
}

double idealFrontShare(const AtRest& rest, double deceleration) {
    return idealForceShare(rest, 0, deceleration);
}

double rearLocksFirstAbove(const AtRest& rest) {
    // Pedal by pedal, as a valve bends the curve; between two of them along the straight line.
    Braking before = brakingAt(rest, 1e-9);
    for (int i = 0; i <= kPedals; ++i) {
        const Braking now = i == 0 ? before : brakingAt(rest, static_cast<double>(i) / kPedals);
        const double lead = now.use.rear - now.use.front;
        if (idealForceShare(rest, 1, now.deceleration) <= 0) break;  // the rear wheels lift off
        if (lead > 0) {
            const double was = before.use.rear - before.use.front;
            if (i == 0 || was >= 0) return before.deceleration;
            return before.deceleration + (now.deceleration - before.deceleration) * was / (was - lead);
        }
        before = now;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace tread::sheet
