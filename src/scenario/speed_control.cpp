#include "scenario/speed_control.h"

#include <algorithm>

namespace tread {

void SpeedControl::begin(double speed, double throttle) {
    start_speed_ = speed;
    start_throttle_ = throttle;
    missing_way_ = 0;
}

double SpeedControl::wanted(const HoldSpeed& hold, double elapsed) const {
    if (!hold.profile.empty()) return hold.profile(elapsed);
    return hold.speed > 0 ? hold.speed : start_speed_;
}

void SpeedControl::look(const HoldSpeed& hold, double speed, double elapsed, double dt) {
    missing_way_ += dt * (wanted(hold, elapsed) - speed);
    // A pedal at its end asks for no more: what piled up there would have to be driven off again.
    if (hold.integral > 0) {
        const double lowest = hold.brake > 0 ? -1 / hold.brake : 0;
        missing_way_ =
            std::clamp(missing_way_, (lowest - start_throttle_) / hold.integral, (1 - start_throttle_) / hold.integral);
    }
}

double SpeedControl::wish(const FollowCourse& follow, double missing, double acceleration) const {
    return follow.proportional * missing + follow.integral * missing_way_ + follow.acceleration * acceleration;
}

// A pedal at its end, and the brake, teach nothing about the throttle that holds a speed.
void SpeedControl::look(const FollowCourse& follow, double missing, double acceleration, double dt) {
    const double now = wish(follow, missing, acceleration);
    if (now >= 0 && now <= 1) missing_way_ += dt * missing;
}

SpeedControl::Pedals SpeedControl::pedals(const FollowCourse& follow, double missing, double acceleration) const {
    const double now = wish(follow, missing, acceleration);
    return {std::clamp(now, 0.0, 1.0), std::clamp(-follow.brake * now, 0.0, 1.0)};
}

SpeedControl::Pedals SpeedControl::pedals(const HoldSpeed& hold, double speed, double elapsed) const {
    const double missing = wanted(hold, elapsed) - speed;
    const double wish = start_throttle_ + hold.proportional * missing + hold.integral * missing_way_;
    return {std::clamp(wish, 0.0, 1.0), std::clamp(-hold.brake * wish, 0.0, 1.0)};
}

}  // namespace tread
