// Sine steering, after ISO 7401: one period, or continuous.

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "metrics/channels.h"
#include "metrics/least_squares.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"
#include "metrics/smoothing.h"

namespace tread {
namespace {

constexpr double kSmallestSine = 0.02;           // rad at the steering wheel; less is a correction
constexpr double kActive = 0.1;                  // of the amplitude: beyond, the driver is steering
constexpr double kLargestMisfit = 0.15;          // rms of what is no sine over the rms of the sine
constexpr double kLargestUnevenness = 1.3;       // longest over shortest half-wave; more is a sweep
constexpr double kFrequencySearch = 0.15;        // the first estimate of the frequency is within this share
constexpr double kSinePeakHalfWidth = 0.1;       // of the period: a noisy peak keeps its height to 0.2 %
constexpr double kSineSteeringHalfWidth = 0.05;  // s

struct SineFit {
    std::complex<double> phasor;  // value(t) = real(phasor exp(i omega t))
    double misfit;                // rms of the rest over rms of the sine
};

// Least squares of a sine, a constant and a drift.
SineFit fitSine(const TimeSeries& series, double frequency) {
    const auto n = static_cast<Eigen::Index>(series.size());
    const double omega = 2 * std::numbers::pi * frequency;
    Eigen::MatrixXd terms(n, 4);
    Eigen::VectorXd target(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double t = series.time[static_cast<std::size_t>(i)];
        terms.row(i) << std::cos(omega * t), std::sin(omega * t), 1, t - series.begin();
        target[i] = series.value[static_cast<std::size_t>(i)];
    }
    const Eigen::VectorXd found = leastSquares(terms, target);
    const double rest = (terms * found - target).norm(), sine = (terms.leftCols<2>() * found.head<2>()).norm();
    return {{found[0], -found[1]}, rest / sine};
}

// The frequency near the estimate at which a sine fits best: golden-section search.
double bestFrequency(const TimeSeries& series, double estimate) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double low = estimate * (1 - kFrequencySearch), high = estimate * (1 + kFrequencySearch);
    while (high - low > 1e-7 * estimate) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        if (fitSine(series, left).misfit < fitSine(series, right).misfit) {
            high = right;
        } else {
            low = left;
        }
    }
    return 0.5 * (low + high);
}

struct Sine {
    bool one_period;
    double frequency;  // Hz
    double from, to;   // s: the whole period, or the last two
};

// First and last time at which the steering is away from its middle.
std::pair<double, double> activeTime(const TimeSeries& steering, double middle, double level) {
    std::size_t first = steering.size(), last = 0;
    for (std::size_t i = 0; i < steering.size(); ++i) {
        if (std::abs(steering.value[i] - middle) <= level) continue;
        first = std::min(first, i);
        last = i;
    }
    return {steering.time[first], steering.time[last]};
}

// Durations of the half-waves between the first and the last turning point.
std::vector<double> halfWaves(const TimeSeries& steering, const std::vector<Instant>& turns) {
    std::vector<double> crossings, durations;
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
        const double middle = 0.5 * (turns[i].value + turns[i + 1].value);
        if (const auto t = firstCrossing(steering, middle, turns[i].time, turns[i + 1].time)) crossings.push_back(*t);
    }
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) durations.push_back(crossings[i + 1] - crossings[i]);
    return durations;
}

Sine findSine(const TimeSeries& steering) {
    const double middle = steering.value.front();
    const double amplitude = 0.5 * range(steering).width();
    if (amplitude < kSmallestSine) {
        notFound(fmt::format("the steering wheel moves by only +-{:.2g} deg, expected at least {:.2g} deg",
                             kDegrees * amplitude, kDegrees * kSmallestSine));
    }
    const auto turns = turningPoints(steering, 0.5 * amplitude);
    if (turns.size() != 2 && turns.size() < 4) {
        notFound(
            fmt::format("the steering turns back {} times, expected one period (2) or at least two (4)", turns.size()));
    }
    const auto [begin, end] = activeTime(steering, middle, kActive * amplitude);
    Sine sine{turns.size() == 2, 0, begin, end};
    if (sine.one_period) {
        const double within =
            2 * std::asin(kActive) / (2 * std::numbers::pi);  // share of the period that is not active
        sine.frequency = (1 - within) / (end - begin);
    } else {
        const auto halves = halfWaves(steering, turns);
        if (halves.empty()) notFound("the steering does not swing about a constant mean");
        const auto [shortest, longest] = std::minmax_element(halves.begin(), halves.end());
        if (*longest > kLargestUnevenness * *shortest) {
            notFound(fmt::format("the half-waves of the steering last {:.2g} to {:.2g} s, expected one frequency",
                                 *shortest, *longest));
        }
        double sum = 0;
        for (double half : halves) sum += half;
        sine.frequency = static_cast<double>(halves.size()) / (2 * sum);
        sine.from = std::max(sine.to - 2 / sine.frequency, begin);
    }
    const TimeSeries window = part(steering, sine.from, sine.to);
    sine.frequency = bestFrequency(window, sine.frequency);
    const double misfit = fitSine(window, sine.frequency).misfit;
    if (misfit > kLargestMisfit) {
        notFound(
            fmt::format("the steering departs from a sine of {:.2g} Hz by {:.0f} %", sine.frequency, 100 * misfit));
    }
    return sine;
}

struct Answer {
    double gain;                     // SI over rad
    double phase_lag = kUndefined;   // deg
    double first_lag = kUndefined;   // s
    double second_lag = kUndefined;  // s
};

Answer answerToContinuous(const Sine& sine, const TimeSeries& steering, const TimeSeries& response) {
    const auto input = fitSine(part(steering, sine.from, sine.to), sine.frequency).phasor;
    const auto output = fitSine(part(response, sine.from, sine.to), sine.frequency).phasor;
    const std::complex<double> transfer = output / input;
    // A car lags by up to about 180 deg; the range is chosen so that no such lag wraps.
    double lag = -kDegrees * std::arg(transfer);
    if (lag < -90) lag += 360;
    return {.gain = std::abs(transfer), .phase_lag = lag};
}

// By its peaks, the first in the direction of the steering.
Answer answerToOnePeriod(const Sine& sine, const std::vector<Instant>& turns, const TimeSeries& response) {
    const bool up = turns[0].value > turns[1].value;
    const double period = 1 / sine.frequency, half = 0.5 * (turns[0].time + turns[1].time);
    const auto peak = [&](bool high, double from, double to) {
        return high ? highest(response, from, to) : lowest(response, from, to);
    };
    const Instant first = peak(up, sine.from, half + 0.5 * period);
    const Instant second = peak(!up, std::max(first.time, half), sine.to + period);
    return {.gain = (first.value - second.value) / (turns[0].value - turns[1].value),
            .first_lag = first.time - turns[0].time,
            .second_lag = second.time - turns[1].time};
}

struct SineSteer {
    Sine sine;
    double speed;      // m/s
    double amplitude;  // rad
    Answer yaw_rate, ay;
};

// How an answer to the steering is put into words.
struct AnswerWords {
    Say gain, phase_lag, first_lag;
};

MetricTable<SineSteer> answerTable(Answer SineSteer::*answer, std::string_view what, std::string_view words,
                                   std::string_view gain_unit, const AnswerWords& say) {
    const auto name = [&](std::string_view metric) { return fmt::format("{}_{}", what, metric); };
    return {
        {{name("gain"), titleOf(words, "gain"), std::string(gain_unit),
          fmt::format("amplitude of the {} over that of the steering-wheel angle: of least-squares sines over the last "
                      "two periods of a continuous sine, peak to peak of a single period",
                      words),
          say.gain},
         [answer](const SineSteer& s) { return (s.*answer).gain; }},
        {{name("phase_lag"), titleOf(words, "phase lag"), "deg",
          fmt::format("by which the {} lags the steering-wheel angle, same fits; undefined for a single period", words),
          say.phase_lag},
         [answer](const SineSteer& s) { return (s.*answer).phase_lag; }},
        {{name("first_peak_lag"), titleOf(words, "lag of the first peak"), "s",
          fmt::format("from the first peak of the steering to that of the {}; undefined for a continuous sine", words),
          say.first_lag},
         [answer](const SineSteer& s) { return (s.*answer).first_lag; }},
        {{name("second_peak_lag"), titleOf(words, "lag of the second peak"), "s",
          fmt::format("from the second peak of the steering to that of the {}; undefined for a continuous sine",
                      words)},
         [answer](const SineSteer& s) { return (s.*answer).second_lag; }},
    };
}

MetricTable<SineSteer> sineSteerTable() {
    MetricTable<SineSteer> lines = {
        {{"speed", "Speed, mean", "m/s", "mean forward speed over the evaluated time"},
         [](const SineSteer& s) { return s.speed; }},
        {{"periods", "Periods evaluated", "-",
          "1: a single period, evaluated by its peaks; 2: the last two of a continuous sine, evaluated by fits"},
         [](const SineSteer& s) { return s.sine.one_period ? 1.0 : 2.0; }},
        {{"frequency", "Steering frequency", "Hz", "of the steering, from the sine that fits best"},
         [](const SineSteer& s) { return s.sine.frequency; }},
        {{"steering_amplitude", "Steering-wheel amplitude", "deg", "amplitude of that sine"},
         [](const SineSteer& s) { return kDegrees * s.amplitude; }},
    };
    const auto add = [&](const MetricTable<SineSteer>& more) { lines.insert(lines.end(), more.begin(), more.end()); };
    add(answerTable(&SineSteer::yaw_rate, "yaw_rate", "yaw rate", "1/s",
                    {.gain = {1, "yaw rate gain {} 1/s", 3},
                     .phase_lag = {2, "yaw rate lags by {} deg", 1},
                     .first_lag = {3, "first yaw rate peak lags by {} ms", 0, 1000}}));
    add(answerTable(&SineSteer::ay, "ay", "lateral acceleration", "m/s2/rad",
                    {.gain = {},
                     .phase_lag = {4, "lateral acceleration by {} deg", 1},
                     .first_lag = {5, "that of the lateral acceleration by {} ms", 0, 1000}}));
    return lines;
}

SineSteer findSineSteer(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"});
    const TimeSeries steering = cleaned(needed[0], kSineSteeringHalfWidth);
    const Sine sine = findSine(steering);
    const double amplitude = std::abs(fitSine(part(steering, sine.from, sine.to), sine.frequency).phasor);
    const auto answer = [&](const TimeSeries& response) {
        if (!sine.one_period) return answerToContinuous(sine, needed[0], response);
        return answerToOnePeriod(sine, turningPoints(steering, 0.5 * amplitude),
                                 cleaned(response, kSinePeakHalfWidth / sine.frequency));
    };
    return {.sine = sine,
            .speed = mean(needed[1], sine.from, sine.to),
            .amplitude = amplitude,
            .yaw_rate = answer(needed[2]),
            .ay = answer(needed[3])};
}

}  // namespace

Manoeuvre sineSteer() {
    return {"sine_steer", "sine steering: gain and phase, or lags of the peaks (after ISO 7401)",
            [] { return definitions(sineSteerTable()); },
            [](const Log& log, const KnownCar&) { return values(sineSteerTable(), findSineSteer(log)); }};
}

}  // namespace tread
