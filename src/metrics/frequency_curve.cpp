#include "metrics/frequency_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "metrics/channels.h"

namespace tread {
namespace {

// What lies between, along the points: the value of `quantity` at a frequency.
double between(const FrequencyCurve& curve, double frequency, auto&& quantity) {
    constexpr double kRounding = 1e-9;  // Hz
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const double left = curve[i].frequency, right = curve[i + 1].frequency;
        if (frequency < left - kRounding || frequency > right + kRounding) continue;
        const double share = (frequency - left) / (right - left);
        return (1 - share) * quantity(i) + share * quantity(i + 1);
    }
    return kUndefined;
}

// First frequency at which a quantity of the points passes a level; NaN when it does not.
double firstPassage(const FrequencyCurve& curve, double level, auto&& quantity) {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const double left = quantity(i) - level, right = quantity(i + 1) - level;
        if (left == right || (left > 0) == (right > 0)) continue;
        return curve[i].frequency + left / (left - right) * (curve[i + 1].frequency - curve[i].frequency);
    }
    return kUndefined;
}

auto gainOf(const FrequencyCurve& curve) {
    return [&curve](std::size_t i) { return std::abs(curve[i].transfer); };
}

// Phase lags without jumps, rad.
auto lagOf(const FrequencyCurve& curve) {
    std::vector<double> lags;
    for (const FrequencyPoint& point : curve) {
        double lag = -std::arg(point.transfer);
        const double near = lags.empty() ? 0 : lags.back();
        lag -= 2 * std::numbers::pi * std::round((lag - near) / (2 * std::numbers::pi));
        lags.push_back(lag);
    }
    return [lags = std::move(lags)](std::size_t i) { return lags[i]; };
}

}  // namespace

double gainAt(const FrequencyCurve& curve, double frequency) {
    return between(curve, frequency, gainOf(curve));
}
double phaseLagAt(const FrequencyCurve& curve, double frequency) {
    return between(curve, frequency, lagOf(curve));
}
double coherenceAt(const FrequencyCurve& curve, double frequency) {
    return between(curve, frequency, [&](std::size_t i) { return curve[i].coherence; });
}

const FrequencyPoint& peakOf(const FrequencyCurve& curve) {
    return *std::max_element(curve.begin(), curve.end(), [](const FrequencyPoint& a, const FrequencyPoint& b) {
        return std::abs(a.transfer) < std::abs(b.transfer);
    });
}

double frequencyOfGain(const FrequencyCurve& curve, double gain) {
    return firstPassage(curve, gain, gainOf(curve));
}
double frequencyOfLag(const FrequencyCurve& curve, double lag) {
    return firstPassage(curve, lag, lagOf(curve));
}

}  // namespace tread
