// The random road against ISO 8608, by Welch's method, and its coherence against an integral over a surface that looks
// the same in every direction.

#include "road/roughness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace tread::roughness_test {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;
constexpr double kStep = 0.04;                          // m, not that of the road's own points
constexpr std::size_t kSamples = 81920;                 // 3276.8 m
constexpr std::size_t kSegment = 16384;                 // 655 m
constexpr double kResolution = 1 / (kSegment * kStep);  // cycles/m

std::vector<double> path(const Roughness& road, double y) {
    std::vector<double> z(kSamples);
    for (std::size_t i = 0; i < kSamples; ++i) z[i] = road.at(static_cast<double>(i) * kStep, y).height;
    return z;
}

// One-sided cross-spectrum in m3: Hann windows, half overlapping, around the road that closes on itself.
std::vector<Complex> crossSpectrum(const std::vector<double>& a, const std::vector<double>& b) {
    Eigen::FFT<double> fft;
    std::vector<Complex> mean(kSegment / 2), wave_a, wave_b;
    double segments = 0;
    for (std::size_t start = 0; start < kSamples; start += kSegment / 2, ++segments) {
        std::vector<double> window_a(kSegment), window_b(kSegment);
        for (std::size_t i = 0; i < kSegment; ++i) {
            const double hann = 0.5 - 0.5 * std::cos(2 * kPi * static_cast<double>(i) / kSegment);
            window_a[i] = hann * a[(start + i) % kSamples];
            window_b[i] = hann * b[(start + i) % kSamples];
        }
        fft.fwd(wave_a, window_a);
        fft.fwd(wave_b, window_b);
        for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += std::conj(wave_a[k]) * wave_b[k];
    }
    constexpr double kHannPower = 0.375;
    for (Complex& value : mean) value *= 2 * kStep / (kHannPower * kSegment * segments);
    return mean;
}

// The bands over which ISO 8608 averages: octaves, thirds, twelfths, by their upper edges.
std::vector<std::pair<double, double>> isoBands() {
    std::vector<std::pair<double, double>> bands;
    const auto add = [&](double from, double to, double ratio) {
        for (double edge = from; edge * ratio < to * 1.001; edge *= ratio) bands.emplace_back(edge, edge * ratio);
    };
    add(0.011, 0.0442, 2);
    add(0.0442, 0.2726, std::cbrt(2.0));
    add(0.2726, 4, std::pow(2, 1 / 12.0));
    return bands;
}

double meanOver(const std::pair<double, double>& band, auto&& function) {
    double sum = 0, count = 0;
    for (auto k = static_cast<std::size_t>(std::ceil(band.first / kResolution));
         static_cast<double>(k) * kResolution < band.second; ++k, ++count)
        sum += function(k);
    return sum / count;
}

TEST(Iso8608, EveryPathHasThePsdOfItsClassWithinOneDecibel) {
    double largest = 0;
    for (const RoadClass road_class : {RoadClass::A, RoadClass::C, RoadClass::H}) {
        for (const int seed : {1, 2, 3}) {
            RoughnessParams params;
            params.road_class = road_class;
            params.seed = seed;
            const Roughness road(params, 0);
            for (const double y : {-0.75, 0.0, 0.3, 0.75, 5.0}) {
                const std::vector<double> z = path(road, y);
                const std::vector<Complex> psd = crossSpectrum(z, z);
                // Middle of class A: 16e-6 m3 at 0.1 cycles/m, four times as much for each further class.
                const double level = 16e-6 * std::pow(4, static_cast<int>(road_class) - 1);
                for (const auto& band : isoBands()) {
                    const double found = meanOver(band, [&](std::size_t k) { return psd[k].real(); });
                    const double wanted = meanOver(band, [&](std::size_t k) {
                        return level * std::pow(static_cast<double>(k) * kResolution / 0.1, -2);
                    });
                    const double decibel = 10 * std::log10(found / wanted);
                    largest = std::max(largest, std::abs(decibel));
                    EXPECT_LT(std::abs(decibel), 1)
                        << band.first << " to " << band.second << " cycles/m, y = " << y << ", seed " << seed;
                }
            }
        }
    }
    std::printf("ISO 8608, PSD of classes A, C, H, 3 seeds, 5 paths, 0.011-4 cycles/m: largest difference %.2f dB\n",
                largest);
}

TEST(Iso8608, WavinessAndLevelAreFreeToChoose) {
    RoughnessParams params;
    params.road_class = RoadClass::A;
    params.unevenness = 100e-6;
    params.waviness = 2.6;
    const std::vector<double> z = path(Roughness(params, 0), 0.75);
    const std::vector<Complex> psd = crossSpectrum(z, z);
    for (const auto& band : isoBands()) {
        const double found = meanOver(band, [&](std::size_t k) { return psd[k].real(); });
        const double wanted = meanOver(
            band, [&](std::size_t k) { return 100e-6 * std::pow(static_cast<double>(k) * kResolution / 0.1, -2.6); });
        EXPECT_LT(std::abs(10 * std::log10(found / wanted)), 1) << band.first;
    }
}

// Correlation of waves of one longitudinal wave number n at the lateral distance w on a surface whose spectrum depends
// on sqrt(n^2 + m^2) alone, by Simpson's rule over m = n sinh(u).
double isotropicCoherence(double n, double w, double waviness) {
    constexpr int kSteps = 20000;
    constexpr double kEnd = 12;
    double with = 0, without = 0;
    for (int i = 0; i <= kSteps; ++i) {
        const double u = kEnd * i / kSteps;
        const double weight = (i == 0 || i == kSteps ? 1 : i % 2 == 1 ? 4 : 2) * std::pow(std::cosh(u), -waviness);
        without += weight;
        with += weight * std::cos(2 * kPi * n * std::sinh(u) * w);
    }
    return with / without;
}

TEST(WheelPathCoherence, IsThatOfAnIsotropicSurface) {
    for (const double waviness : {1.6, 2.0, 2.7}) {
        for (const double n : {0.001, 0.02, 0.1, 0.3, 0.8}) {
            RoughnessParams params;
            params.waviness = waviness;
            EXPECT_NEAR(wheelPathCoherence(params, n), isotropicCoherence(n, params.track, waviness), 2e-4)
                << n << " cycles/m, waviness " << waviness;
        }
    }
}

TEST(WheelPathCoherence, IsFoundBetweenTheGeneratedPaths) {
    for (const Coherence kind : {Coherence::isotropic, Coherence::equal, Coherence::independent}) {
        RoughnessParams params;
        params.road_class = RoadClass::C;
        params.coherence = kind;
        params.track = 1.6;
        const Roughness road(params, 0);
        const std::vector<double> left = path(road, 0.8), right = path(road, -0.8);
        const auto both = crossSpectrum(left, right), on_left = crossSpectrum(left, left),
                   on_right = crossSpectrum(right, right);
        double largest = 0;
        for (const auto& band : isoBands()) {
            const double cross = meanOver(band, [&](std::size_t k) { return both[k].real(); });
            const double power = std::sqrt(meanOver(band, [&](std::size_t k) { return on_left[k].real(); }) *
                                           meanOver(band, [&](std::size_t k) { return on_right[k].real(); }));
            const double middle = std::sqrt(band.first * band.second);
            const double wanted = kind == Coherence::equal         ? 1
                                  : kind == Coherence::independent ? 0
                                                                   : isotropicCoherence(middle, 1.6, 2);
            largest = std::max(largest, std::abs(cross / power - wanted));
        }
        std::printf("coherence of the wheel paths, kind %d: largest difference %.3f\n", static_cast<int>(kind),
                    largest);
        EXPECT_LT(largest, 0.05) << static_cast<int>(kind);
    }
}

TEST(Roughness, SeedReproducesTheRoadAndAnotherGivesAnother) {
    RoughnessParams params;
    params.road_class = RoadClass::C;
    const std::vector<double> first = path(Roughness(params, 0.15), 0.75);
    EXPECT_EQ(first, path(Roughness(params, 0.15), 0.75));
    params.seed = 2;
    const std::vector<double> second = path(Roughness(params, 0.15), 0.75);
    double product = 0, power = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
        product += first[i] * second[i];
        power += first[i] * first[i];
    }
    EXPECT_LT(std::abs(product / power), 0.5) << "the roads are alike";
}

// The tyre's mean over its contact, against numerical integration of the surface.
TEST(Roughness, AverageIsTheMeanOverTheContact) {
    RoughnessParams params;
    params.road_class = RoadClass::E;
    constexpr double kSide = 0.2;
    const Roughness road(params, kSide);
    for (const double x : {-77.7, 3.0, 1234.567}) {
        for (const double y : {-0.9, 0.2}) {
            double sum = 0;
            constexpr int kPoints = 100;
            for (int i = 0; i < kPoints; ++i) {
                for (int j = 0; j < kPoints; ++j)
                    sum += road.at(x + kSide * ((i + 0.5) / kPoints - 0.5), y + kSide * ((j + 0.5) / kPoints - 0.5))
                               .height;
            }
            const double rms = 0.04;  // m, of a class E road
            EXPECT_NEAR(road.averaged(x, y).height, sum / kPoints / kPoints, 1e-3 * rms);
        }
    }
}

TEST(Roughness, BeginsWhereItIsToldWithoutAStep) {
    RoughnessParams params;
    params.road_class = RoadClass::C;
    const Roughness everywhere(params, 0);
    params.begin = 20;
    const Roughness later(params, 0);
    EXPECT_EQ(later.at(19.9, 0.7).height, 0);
    EXPECT_NEAR(later.at(20.001, 0.7).height, 0, 1e-8);
    EXPECT_NEAR(later.at(25, 0.7).height, 0.5 * everywhere.at(25, 0.7).height, 1e-12);
    EXPECT_EQ(later.at(30, 0.7).height, everywhere.at(30, 0.7).height);
}

}  // namespace
}  // namespace tread::roughness_test
