// ISO 2631-1:1997, Mechanical vibration and shock - Evaluation of human exposure to whole-body vibration, annex A: band
// limits (A.1, A.2), acceleration-velocity transition (A.3), upward step (A.4). The weights are applied to the
// spectrum, as the standard allows.

#include "metrics/vibration_weighting.h"

#include <bit>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace tread {
namespace {

// Corner frequencies in Hz and resonant qualities; without a step its frequency is 0.
struct Filter {
    double f3, f4, q4, f5, q5, f6, q6;
};
constexpr double kBandFrom = 0.4;  // Hz, f1
constexpr double kBandTo = 100;    // Hz, f2
constexpr Filter kWk{12.5, 12.5, 0.63, 2.37, 0.91, 3.35, 0.91};
constexpr Filter kWd{2, 2, 0.63, 0, 1, 0, 1};

// |1 + p / (q w0) + (p / w0)^2| w0^2 q at p = j w.
double resonance(double f, double corner, double q) {
    const double f2 = f * f, c2 = corner * corner, q2 = q * q;
    return std::sqrt(f2 * f2 * q2 + f2 * c2 * (1 - 2 * q2) + c2 * c2 * q2);
}

}  // namespace

double vibrationWeight(VibrationWeighting weighting, double f) {
    const Filter& w = weighting == VibrationWeighting::Wk ? kWk : kWd;
    const double high_pass = 1 / std::sqrt(1 + std::pow(kBandFrom / f, 4));                                // (A.1)
    const double low_pass = 1 / std::sqrt(1 + std::pow(f / kBandTo, 4));                                   // (A.2)
    const double transition = std::hypot(1, f / w.f3) * w.f4 * w.f4 * w.q4 / resonance(f, w.f4, w.q4);     // (A.3)
    const double step = w.f5 > 0 ? w.q6 / w.q5 * resonance(f, w.f5, w.q5) / resonance(f, w.f6, w.q6) : 1;  // (A.4)
    return high_pass * low_pass * transition * step;
}

double weightedRms(const TimeSeries& acceleration, VibrationWeighting weighting) {
    const std::size_t count = acceleration.size();
    const double step = (acceleration.end() - acceleration.begin()) / static_cast<double>(count - 1);
    const double level = mean(acceleration, acceleration.begin(), acceleration.end());

    // Equal steps, then zeros up to a power of two: Parseval's sum stays.
    std::vector<double> samples(std::bit_ceil(count), 0.0);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = at(acceleration, acceleration.begin() + static_cast<double>(i) * step) - level;
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> fft;
    fft.fwd(spectrum, samples);

    const auto length = static_cast<double>(samples.size());
    double power = 0;
    for (std::size_t k = 1; k <= samples.size() / 2; ++k) {
        const double weight = vibrationWeight(weighting, static_cast<double>(k) / (length * step));
        const double sides = 2 * k == samples.size() ? 1 : 2;
        power += sides * weight * weight * std::norm(spectrum[k]);
    }
    return std::sqrt(power / length / static_cast<double>(count));
}

}  // namespace tread
