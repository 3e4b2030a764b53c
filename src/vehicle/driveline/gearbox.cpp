#include "vehicle/driveline/gearbox.h"

#include <algorithm>

namespace tread {
namespace {

constexpr double kShiftPause = 1.0;   // s between shifts
constexpr double kClosing = 1.0 / 3;  // share of the shift time in which the clutch closes

}  // namespace

double totalRatio(const GearboxParams& gearbox, int gear) {
    return gearbox.ratios[static_cast<std::size_t>(gear - 1)] * gearbox.final_drive;
}

int gears(const GearboxParams& gearbox) {
    return static_cast<int>(gearbox.ratios.size());
}

double shiftPause(const GearboxParams& gearbox) {
    return std::max(kShiftPause, gearbox.shift_time);
}

void shift(DrivelineState& state, const GearboxParams& gearbox, double throttle, double dt) {
    state.since_shift += dt;
    if (state.since_shift < shiftPause(gearbox)) return;
    const double up = gearbox.shift_up_speed * gearbox.shift_up_share(throttle);
    const double down = gearbox.shift_down_speed * gearbox.shift_down_share(throttle);
    int gear = state.gear;
    if (state.gearbox_speed > up && gear < gears(gearbox)) ++gear;
    if (state.gearbox_speed < down && gear > 1) --gear;
    if (gear == state.gear) return;
    state.gearbox_speed *= totalRatio(gearbox, gear) / totalRatio(gearbox, state.gear);
    state.gear = gear;
    state.since_shift = 0;
}

double engagement(const DrivelineState& state, const GearboxParams& gearbox) {
    if (gearbox.shift_time == 0) return 1;
    const double done = state.since_shift / gearbox.shift_time;
    return std::clamp(1 - (1 - done) / kClosing, 0.0, 1.0);
}

}  // namespace tread
