// Noise of an instrument's readings, and the covariance that it has in means over blocks of 50 ms.
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <span>
#include <vector>

#include "log/log.h"

namespace tread {

inline constexpr double kShownBlock = 0.05;  // s

// Block means of readings that were taken at these times (s); a block without a reading has none.
Eigen::VectorXd shownBlocks(std::span<const double> times, std::span<const double> readings);

struct ReadingNoise {
    double level = 0;       // standard deviation of one reading, in the unit of the channel
    double kept = 0;        // of a reading's error, in the next one (first-order autoregression)
    double resolution = 0;  // smallest step of a reading
    double jitter = 0;      // s, standard deviation of the instant at which a reading is taken

    // What shakes the instrument, as sines of an unknown phase: amplitudes, in the unit of the channel.
    double shaking = 0;         // of the road, at about this frequency
    double frequency = 8;       // 1/s
    double frequency_band = 0;  // 1/s, half the width of the range of the frequency
    double engine = 0;          // of an order of the engine
    double engine_scatter = 0;  // standard deviation of the engine's speed as a share of what its phase is told with

    double spikes = 0;        // probability that a reading is one; not part of the covariance: they are plain to see
    double spike_height = 0;  // standard deviation
};

// `readings`: as they would be without noise, at these times, equally spaced. `engine_phase`: rad, of the engine's
// order at these times; empty: it does not shake.
Eigen::MatrixXd blockCovariance(const ReadingNoise& noise, std::span<const double> times,
                                std::span<const double> readings, std::span<const double> engine_phase = {});

}  // namespace tread
