// Noise of the readings of an instrument, and its covariance in means over blocks of 50 ms.
#pragma once

#include <Eigen/Dense>
#include <limits>
#include <span>
#include <vector>

#include "log/log.h"

namespace tread::blind::world {

inline constexpr double kBlock = 0.05;  // s

// Means of the readings in each block; `times` in s. Blocks without a reading are skipped.
Eigen::VectorXd blockMeans(std::span<const double> times, std::span<const double> readings);

struct ReadingNoise {
    double level = 0;        // standard deviation of one reading, in the unit of the channel
    double correlation = 0;  // of successive errors (first-order autoregression)
    double resolution = 0;   // quantisation step
    double jitter = 0;       // s, standard deviation of the sampling instant

    // Vibration: sines of random phase; amplitudes in the unit of the channel.
    double shaking = 0;         // excited by the road
    double frequency = 8;       // Hz, of the road's vibration; uniform within +-frequency_band
    double frequency_band = 0;  // Hz
    double engine = 0;          // at an order of the engine
    double engine_scatter = 0;  // relative standard deviation of the engine speed from which its phase is computed

    double spikes = 0;        // probability per reading; not in the covariance, since spikes are easily recognised
    double spike_height = 0;  // standard deviation
};

// Covariance of the block means. `readings`: noise-free, at equally spaced `times` (s). `engine_phase`: rad, of the
// engine order at these times; empty: no vibration by the engine.
Eigen::MatrixXd blockCovariance(const ReadingNoise& noise, std::span<const double> times,
                                std::span<const double> readings, std::span<const double> engine_phase = {});

}  // namespace tread::blind::world
