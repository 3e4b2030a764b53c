#include "rate_slider.h"

#include <algorithm>
#include <cmath>

namespace tread::demo {

float RateSlider::placeOf(double rate) const {
    const double share = std::log(std::clamp(rate, kLowest, kHighest) / kLowest) / std::log(kHighest / kLowest);
    return left() + static_cast<float>(share) * (right() - left());
}

double RateSlider::rateAt(double x) const {
    const double from = static_cast<double>(left()), to = static_cast<double>(right());
    const double share = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return std::round(kLowest * std::pow(kHighest / kLowest, share));
}

bool RateSlider::holds(double x, double y) const {
    constexpr double kBeside = 12;
    return x > static_cast<double>(left()) - kBeside && x < static_cast<double>(right()) + kBeside &&
           std::abs(y - static_cast<double>(kMiddle)) < kBeside + static_cast<double>(kHalfHeight);
}

}  // namespace tread::demo
