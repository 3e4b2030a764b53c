#include "metrics/spectrum.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "metrics/least_squares.h"

namespace tread {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kLevelTime = 0.5;  // s at the beginning of a record that is at rest there

struct Spectra {
    double xx = 0, yy = 0;
    std::complex<double> xy;  // conj(X) Y
    std::size_t estimates = 0;

    void add(std::complex<double> x, std::complex<double> y) {
        xx += std::norm(x);
        yy += std::norm(y);
        xy += std::conj(x) * y;
        ++estimates;
    }
    FrequencyPoint point(double frequency) const {
        const double coherence = estimates > 1 ? std::norm(xy) / (xx * yy) : std::numeric_limits<double>::quiet_NaN();
        return {frequency, xy / xx, coherence, xx / static_cast<double>(estimates)};
    }
};

// exp(-i 2 pi f t) over times that are mostly evenly spaced: turned from sample to sample, set afresh now and then.
class Rotor {
public:
    explicit Rotor(double frequency) : omega_(kTurn * frequency) {}
    std::complex<double> at(double time) {
        constexpr int kAfresh = 256;    // samples, over which rounding grows to 1e-13
        constexpr double kSame = 1e-9;  // s
        const double step = time - time_;
        if (++count_ % kAfresh == 1) {
            value_ = std::polar(1.0, -omega_ * time);
        } else {
            if (std::abs(step - step_) > kSame) {
                step_ = step;
                turn_ = std::polar(1.0, -omega_ * step);
            }
            value_ *= turn_;
        }
        time_ = time;
        return value_;
    }

private:
    double omega_;
    double time_ = 0, step_ = 0;
    std::complex<double> value_ = 1, turn_ = 1;
    int count_ = 0;
};

// Fourier integrals of several series over the same times, by the trapezoidal rule.
std::vector<std::complex<double>> transforms(std::span<const TimeSeries> series, double frequency) {
    std::vector<std::complex<double>> sums(series.size());
    const std::vector<double>& time = series.front().time;
    Rotor rotor(frequency);
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double before = i > 0 ? time[i] - time[i - 1] : 0;
        const double after = i + 1 < time.size() ? time[i + 1] - time[i] : 0;
        const std::complex<double> weight = 0.5 * (before + after) * rotor.at(time[i]);
        for (std::size_t k = 0; k < series.size(); ++k) sums[k] += weight * series[k].value[i];
    }
    return sums;
}

// A segment without its mean, faded in and out.
TimeSeries windowed(const TimeSeries& series, double from, double length) {
    TimeSeries out = part(series, from, from + length);
    const double level = mean(out, out.begin(), out.end());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double hann = 0.5 - 0.5 * std::cos(kTurn * (out.time[i] - from) / length);
        out.value[i] = (out.value[i] - level) * hann;
    }
    return out;
}

// Transforms of input and output at neighbouring frequencies.
struct Band {
    std::vector<double> aside;  // of the half width, -1 to 1
    std::vector<std::complex<double>> x, y;

    // Y = (h + h' aside + h'' aside^2) X in the sense of least squares: the transfer function at the middle. Averaged
    // spectra would give that of a neighbour with more power. Too few for a fit: one estimate alone.
    FrequencyPoint point(double frequency) const {
        constexpr std::size_t kTerms = 3, kFewest = 5;
        const std::size_t middle = x.size() / 2;
        double xx = 0, yy = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            xx += std::norm(x[i]) / static_cast<double>(x.size());
            yy += std::norm(y[i]) / static_cast<double>(x.size());
        }
        if (x.size() < kFewest) {
            return {frequency, y[middle] / x[middle], std::numeric_limits<double>::quiet_NaN(), std::norm(x[middle])};
        }
        // Each complex number as its real and its imaginary part.
        const auto n = static_cast<Eigen::Index>(x.size()), m = static_cast<Eigen::Index>(kTerms);
        Eigen::MatrixXd terms(2 * n, 2 * m);
        Eigen::VectorXd target(2 * n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            std::complex<double> term = x[at];
            for (Eigen::Index k = 0; k < m; ++k, term *= aside[at])
                terms.block<2, 2>(2 * i, 2 * k) << term.real(), -term.imag(), term.imag(), term.real();
            target.segment<2>(2 * i) << y[at].real(), y[at].imag();
        }
        const Eigen::VectorXd found = leastSquares(terms, target);
        const double rest = (terms * found - target).squaredNorm() / static_cast<double>(x.size() - kTerms);
        return {frequency, {found[0], found[1]}, std::max(0.0, 1 - rest / yy), xx};
    }
};

TimeSeries withoutLevel(const TimeSeries& series) {
    return increments(series, mean(series, series.begin(), series.begin() + kLevelTime));
}

}  // namespace

std::vector<double> powerSpectralDensity(const TimeSeries& series, std::span<const double> frequencies,
                                         double segment) {
    constexpr double kHannPower = 3.0 / 8;  // mean square of a Hann window
    const auto points = frequencyResponses(series, std::span(&series, 1), frequencies, {.segment = segment});
    std::vector<double> density;
    for (const FrequencyPoint& point : points.front())
        density.push_back(2 * point.input / (kHannPower * segment));  // 2: both sides of the spectrum
    return density;
}

std::size_t segments(const TimeSeries& series, const SpectrumSettings& settings) {
    const double length = series.end() - series.begin();
    if (settings.segment <= 0 || settings.segment >= length) return 1;
    constexpr double kRounding = 1e-6;  // of a segment
    return 1 + static_cast<std::size_t>(2 * (length / settings.segment - 1) + kRounding);
}

std::vector<std::vector<FrequencyPoint>> frequencyResponses(const TimeSeries& input,
                                                            std::span<const TimeSeries> outputs,
                                                            std::span<const double> frequencies,
                                                            const SpectrumSettings& settings) {
    // The input goes first through all that is done to the outputs.
    std::vector<TimeSeries> all;
    const auto prepare = [&](const auto& how) {
        all.clear();
        all.push_back(how(input));
        for (const TimeSeries& output : outputs) all.push_back(how(output));
    };
    std::vector<std::vector<FrequencyPoint>> points(outputs.size());
    const double record = input.end() - input.begin();
    if (settings.segment <= 0) {
        prepare(withoutLevel);
        // Estimates closer than the inverse of the record's length are not independent.
        const int aside = static_cast<int>(settings.half_band * record);
        for (const double frequency : frequencies) {
            std::vector<Band> bands(outputs.size());
            for (int k = -aside; k <= aside; ++k) {
                const auto found = transforms(all, frequency + k / record);
                for (std::size_t o = 0; o < outputs.size(); ++o) {
                    bands[o].aside.push_back(k / record / settings.half_band);
                    bands[o].x.push_back(found[0]);
                    bands[o].y.push_back(found[o + 1]);
                }
            }
            for (std::size_t o = 0; o < outputs.size(); ++o) points[o].push_back(bands[o].point(frequency));
        }
        return points;
    }
    std::vector<std::vector<Spectra>> spectra(outputs.size(), std::vector<Spectra>(frequencies.size()));
    const double length = std::min(settings.segment, record);
    for (std::size_t k = 0; k < segments(input, settings); ++k) {
        const double from = input.begin() + 0.5 * length * static_cast<double>(k);
        prepare([&](const TimeSeries& series) { return windowed(series, from, length); });
        for (std::size_t i = 0; i < frequencies.size(); ++i) {
            const auto found = transforms(all, frequencies[i]);
            for (std::size_t o = 0; o < outputs.size(); ++o) spectra[o][i].add(found[0], found[o + 1]);
        }
    }
    for (std::size_t o = 0; o < outputs.size(); ++o) {
        for (std::size_t i = 0; i < frequencies.size(); ++i) points[o].push_back(spectra[o][i].point(frequencies[i]));
    }
    return points;
}

}  // namespace tread
