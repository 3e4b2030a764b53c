// How people feel vibration: the frequency weightings of ISO 2631-1.
#pragma once

#include "metrics/series.h"

namespace tread {

// On the floor or seat of a seated person: vertical (Wk), and fore-and-aft or sideways (Wd).
enum class VibrationWeighting { Wk, Wd };

// Weight of an acceleration of that frequency, from 0 to about 1.
double vibrationWeight(VibrationWeighting weighting, double frequency);

// Weighted root mean square of an acceleration about its mean, over the whole series.
double weightedRms(const TimeSeries& acceleration, VibrationWeighting weighting);

}  // namespace tread
