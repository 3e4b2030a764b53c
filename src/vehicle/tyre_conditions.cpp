#include "vehicle/tyre_conditions.h"

namespace tread {

void shiftMotions(PerWheel<TyreMotion>& begin, PerWheel<TyreMotion>& end, const Vehicle& vehicle) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const TyreShift& shift = vehicle.corners[i].tyre_shift;
        begin[i] = shifted(begin[i], shift);
        end[i] = shifted(end[i], shift);
    }
}

void applyWarmth(PerWheel<TyreFactors>& factors, const PerWheel<WheelState>& wheels, const Vehicle& vehicle) {
    for (std::size_t i = 0; i < kWheels; ++i) {
        const TyreWarmth now = warmth(vehicle.corners[i].temperature, wheels[i].warming);
        factors[i].friction *= now.friction;
        factors[i].stiffness *= now.stiffness;
    }
}

}  // namespace tread
