// What is read off a frequency response: values between its points, its peak, where it passes a level.
#pragma once

#include <vector>

#include "metrics/spectrum.h"

namespace tread {

using FrequencyCurve = std::vector<FrequencyPoint>;  // at least one, frequencies increasing, Hz

// Between the points; NaN outside.
double gainAt(const FrequencyCurve& curve, double frequency);
double phaseLagAt(const FrequencyCurve& curve, double frequency);  // rad, without jumps
double coherenceAt(const FrequencyCurve& curve, double frequency);

const FrequencyPoint& peakOf(const FrequencyCurve& curve);  // where the gain is largest

// First frequency at which the curve passes this gain, or this phase lag, rad; NaN when it does not.
double frequencyOfGain(const FrequencyCurve& curve, double gain);
double frequencyOfLag(const FrequencyCurve& curve, double lag);

}  // namespace tread
