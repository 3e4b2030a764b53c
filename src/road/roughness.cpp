#include "road/roughness.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "base/random.h"
#include "road/fade.h"

namespace tread {
namespace {

constexpr double kPi = std::numbers::pi;

// ISO 8608: geometric mean of class A at the reference wave number.
constexpr double kReference = 0.1;  // cycles/m
constexpr double kClassA = 16e-6;   // m3

// A spline through points 0.05 m apart carries waves down to 0.2 m (a quarter of its sampling frequency) within 1 %.
constexpr std::size_t kNodes = 65536;
constexpr double kSpacing = 0.05;      // m
constexpr double kLowest = 1 / 128.0;  // cycles/m
constexpr double kHighest = 5;         // cycles/m
constexpr double kFarthest = 1e12;     // m, where a double still knows a node from the next
constexpr double kFade = 10;           // m, over which the roughness begins

double sinc(double x) {
    return x == 0 ? 1 : std::sin(kPi * x) / (kPi * x);
}

// Response of the cubic B-spline at its own nodes, to which the coefficients are matched.
double splineAtNodes(double wave_number) {
    return (2 + std::cos(2 * kPi * wave_number * kSpacing)) / 3;
}

std::size_t wrapped(long node) {
    static_assert((kNodes & (kNodes - 1)) == 0);
    return static_cast<std::size_t>(node) & (kNodes - 1);
}

}  // namespace

bool isRough(const RoughnessParams& params) {
    return displacementPsd(params, kReference) > 0;
}

double displacementPsd(const RoughnessParams& params, double wave_number) {
    if (!params.unevenness && params.road_class == RoadClass::none) return 0;
    const int steps = static_cast<int>(params.road_class) - static_cast<int>(RoadClass::A);
    const double level = params.unevenness.value_or(kClassA * std::pow(4, steps));
    return level * std::pow(wave_number / kReference, -params.waviness);
}

double wheelPathCoherence(const RoughnessParams& params, double wave_number) {
    if (params.coherence == Coherence::equal) return 1;
    if (params.coherence == Coherence::independent) return 0;
    const double order = 0.5 * params.waviness;
    const double x = 2 * kPi * wave_number * params.track;
    constexpr double kUnderflow = 500;  // K is 0 in double precision beyond
    if (x > kUnderflow) return 0;
    return 2 * std::pow(0.5 * x, order) * std::cyl_bessel_k(order, x) / std::tgamma(order);
}

Roughness::Roughness(const RoughnessParams& params, double contact_length)
    : wave_across_(kPi / params.track), begin_(params.begin), itself_(kNodes), averaged_(kNodes) {
    using Complex = std::complex<double>;
    constexpr std::size_t kProfiles = 3;
    const double step = 1 / (static_cast<double>(kNodes) * kSpacing);  // cycles/m
    std::array<std::vector<Complex>, kProfiles> spectra, averaged_spectra;
    for (auto* set : {&spectra, &averaged_spectra}) set->fill(std::vector<Complex>(kNodes));

    // Every third frequency belongs to one profile: their sums have the wanted PSD exactly, not only in the mean.
    Random random(static_cast<std::uint64_t>(params.seed));
    const double across = sinc(0.5 * contact_length / params.track);
    for (std::size_t k = 1; static_cast<double>(k) * step <= kHighest; ++k) {
        const double n = static_cast<double>(k) * step;
        const double phase = 2 * kPi * random.uniform();
        if (n < kLowest) continue;
        const std::size_t profile = k % kProfiles;
        const double sign = profile == 0 ? 1 : -1;
        const double psd = 0.5 * (1 + sign * wheelPathCoherence(params, n)) * displacementPsd(params, n);
        const double amplitude = std::sqrt(2 * psd * kProfiles * step) / splineAtNodes(n);
        spectra[profile][k] = std::polar(amplitude, phase);
        averaged_spectra[profile][k] = spectra[profile][k] * sinc(n * contact_length) * (profile == 0 ? 1 : across);
    }

    Eigen::FFT<double> fft;
    fft.SetFlag(Eigen::FFT<double>::Unscaled);
    const auto synthesise = [&](const auto& from, Profile& to) {
        std::vector<Complex> waves;
        for (std::size_t profile = 0; profile < kProfiles; ++profile) {
            fft.inv(waves, from[profile]);
            for (std::size_t i = 0; i < kNodes; ++i) to[i][profile] = waves[i].real();
        }
    };
    synthesise(spectra, itself_);
    synthesise(averaged_spectra, averaged_);
}

SurfacePoint Roughness::evaluate(const Profile& profile, double x, double y) const {
    if (!(x > begin_) || std::abs(x) > kFarthest) return {};

    // Cubic B-spline along x: values and slopes of the three profiles.
    const double u = x / kSpacing, whole = std::floor(u), t = u - whole, s = 1 - t;
    const std::array<double, 4> weight{s * s * s / 6, (4 + t * t * (3 * t - 6)) / 6, (4 + s * s * (3 * s - 6)) / 6,
                                       t * t * t / 6};
    const std::array<double, 4> slope_weight{-0.5 * s * s, t * (1.5 * t - 2), -s * (1.5 * s - 2), 0.5 * t * t};
    const long first = static_cast<long>(whole) - 1;
    std::array<double, 3> value{}, slope{};
    for (int k = 0; k < 4; ++k) {
        const Node& node = profile[wrapped(first + k)];
        for (std::size_t i = 0; i < 3; ++i) {
            value[i] += weight[k] * node[i];
            slope[i] += slope_weight[k] / kSpacing * node[i];
        }
    }

    // Across the road.
    const double cosine = std::cos(wave_across_ * y), sine = std::sin(wave_across_ * y);
    const SurfacePoint surface{value[0] + value[1] * cosine + value[2] * sine,
                               slope[0] + slope[1] * cosine + slope[2] * sine,
                               wave_across_ * (value[2] * cosine - value[1] * sine)};
    return fadedIn(surface, x - begin_, kFade);
}

}  // namespace tread
