// Steering with a broad spectrum: gain, phase and coherence over frequency, after ISO 7401 (random, pulse) and its
// substitute, the sweep.

#include "metrics/frequency_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "metrics/channels.h"
#include "metrics/manoeuvres.h"
#include "metrics/metric_table.h"

namespace tread {
namespace {

constexpr double kSegment = 20;              // s, of Welch's method: eight periods of the lowest frequency that counts
constexpr double kLowestFrequency = 0.1;     // Hz
constexpr double kHighestFrequency = 4.0;    // Hz
constexpr double kSpacing = 0.05;            // Hz between the points
constexpr double kLeastPower = 0.01;         // of the largest: below, the steering asks nothing at that frequency
constexpr double kNarrow = 2.5;              // highest over lowest frequency: less is one sine
constexpr double kSmallestSteering = 0.005;  // rad at the steering wheel; less is a correction
constexpr double kRest = 0.02;               // of the largest deflection
constexpr double kRestTime = 0.5;            // s at both ends of a record that is taken as a whole
constexpr std::size_t kFewestRandomTurns = 6;                     // of random steering
constexpr std::array kFrequencies{0.2, 0.5, 1.0, 1.5, 2.0, 3.0};  // Hz, at which values are quoted
constexpr double kPhase = 45;                                     // deg

// Whether a channel is at rest at the beginning and, at the same level, at the end.
bool restsAtBothEnds(const TimeSeries& series) {
    const double level = mean(series, series.begin(), series.begin() + kRestTime);
    double largest = 0, at_ends = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const double away = std::abs(series.value[i] - level);
        largest = std::max(largest, away);
        if (series.time[i] < series.begin() + kRestTime || series.time[i] > series.end() - kRestTime)
            at_ends = std::max(at_ends, away);
    }
    return at_ends <= kRest * largest;
}

std::vector<double> raster() {
    std::vector<double> frequencies;
    for (int i = 0; kLowestFrequency + i * kSpacing <= kHighestFrequency + 1e-9; ++i)
        frequencies.push_back(kLowestFrequency + i * kSpacing);
    return frequencies;
}

MetricTable<SteeringResponse> answerTable(FrequencyCurve SteeringResponse::*answer, std::string_view what,
                                          std::string_view words, const std::string& unit) {
    MetricTable<SteeringResponse> lines;
    const auto name = [&](std::string_view metric) { return fmt::format("{}_{}", what, metric); };
    const bool is_said = answer == &SteeringResponse::yaw_rate;
    const auto lowest_gain = [answer](const SteeringResponse& r) { return std::abs((r.*answer).front().transfer); };
    lines.push_back({{name("lowest_gain"), titleOf(words, "gain at the lowest frequency"), unit,
                      fmt::format("{} over steering-wheel angle at the lowest frequency of the steering", words)},
                     lowest_gain});
    lines.push_back({{name("peak_ratio"), titleOf(words, "peak over the gain at the lowest frequency"), "-",
                      fmt::format("largest gain of the {} over that at the lowest frequency", words)},
                     [answer, lowest_gain](const SteeringResponse& r) {
                         return std::abs(peakOf(r.*answer).transfer) / lowest_gain(r);
                     }});
    lines.push_back(
        {{name("peak_frequency"), titleOf(words, "frequency of the peak"), "Hz",
          fmt::format("where the gain of the {} is largest", words), is_said ? Say{2, "largest at {} Hz", 2} : Say{}},
         [answer](const SteeringResponse& r) { return peakOf(r.*answer).frequency; }});
    lines.push_back(
        {{name("bandwidth"), titleOf(words, "bandwidth"), "Hz",
          fmt::format(
              "where the gain of the {} has fallen to 1/sqrt(2) of that at the lowest frequency; undefined when "
              "it does not",
              words)},
         [answer, lowest_gain](const SteeringResponse& r) {
             return frequencyOfGain(r.*answer, lowest_gain(r) / std::numbers::sqrt2);
         }});
    lines.push_back({{name("lag_frequency"), titleOf(words, fmt::format("frequency of {:.0f} deg lag", kPhase)), "Hz",
                      fmt::format("where the {} lags by {:.0f} deg; undefined when it does not", words, kPhase)},
                     [answer](const SteeringResponse& r) { return frequencyOfLag(r.*answer, kPhase / kDegrees); }});
    for (const double frequency : kFrequencies) {
        const auto at_frequency = [&](std::string_view metric) {
            return fmt::format("{}_{}_{:.1f}Hz", what, metric, frequency);
        };
        const auto title = [&](std::string_view metric) {
            return titleOf(words, fmt::format("{} at {:.1f} Hz", metric, frequency));
        };
        const std::string where =
            fmt::format("at {:.1f} Hz; undefined where the steering has less than {:.0f} % of its largest power",
                        frequency, 100 * kLeastPower);
        lines.push_back(
            {{at_frequency("gain"), title("gain"), unit, fmt::format("{} over steering-wheel angle {}", words, where),
              is_said && frequency == 0.5 ? Say{1, "yaw rate gain {} 1/s at 0.5 Hz", 3} : Say{}},
             [answer, frequency](const SteeringResponse& r) { return gainAt(r.*answer, frequency); }});
        lines.push_back(
            {{at_frequency("phase_lag"), title("phase lag"), "deg",
              fmt::format("by which the {} lags the steering-wheel angle {}", words, where),
              is_said && frequency == 1.0 ? Say{3, "lags by {} deg at 1 Hz", 0} : Say{}},
             [answer, frequency](const SteeringResponse& r) { return kDegrees * phaseLagAt(r.*answer, frequency); }});
        lines.push_back(
            {{at_frequency("coherence"), title("coherence"), "-",
              fmt::format("share of the {} that follows from the steering {}; or one estimate alone", words, where)},
             [answer, frequency](const SteeringResponse& r) { return coherenceAt(r.*answer, frequency); }});
    }
    return lines;
}

MetricTable<SteeringResponse> frequencyResponseTable() {
    MetricTable<SteeringResponse> lines;
    const auto add = [&](MetricTable<SteeringResponse> more) { lines.insert(lines.end(), more.begin(), more.end()); };
    add(answerTable(&SteeringResponse::yaw_rate, "yaw_rate", "yaw rate", "1/s"));
    add(answerTable(&SteeringResponse::ay, "ay", "lateral acceleration", "m/s2/rad"));
    add({
        {{"speed", "Speed", "m/s", "mean forward speed"}, [](const SteeringResponse& r) { return r.speed; }},
        {{"largest_ay", "Lateral acceleration, maximum", "m/s2", "largest magnitude of the lateral acceleration"},
         [](const SteeringResponse& r) { return r.largest_ay; }},
        {{"lowest_frequency", "Evaluated from", "Hz", "lowest frequency at which the steering has enough power"},
         [](const SteeringResponse& r) { return r.from; }},
        {{"highest_frequency", "Evaluated to", "Hz", "highest frequency at which the steering has enough power"},
         [](const SteeringResponse& r) { return r.to; }},
        {{"segments", "Segments", "-",
          fmt::format(
              "1: the whole record, which begins and ends at rest, a parabola of the transfer function fitted over "
              "+-{:.2f} Hz; more: Welch's method with a Hann window, half overlapping, H1 = Sxy / Sxx",
              SpectrumSettings{}.half_band)},
         [](const SteeringResponse& r) { return static_cast<double>(r.segments); }},
        {{"segment_length", "Length of a segment", "s",
          "length of a segment of Welch's method; undefined for the whole record"},
         [](const SteeringResponse& r) { return r.settings.segment > 0 ? r.settings.segment : kUndefined; }},
    });
    return lines;
}

}  // namespace

SteeringResponse steeringResponse(const Log& log) {
    const auto needed = channels(log, {"driver.steering_wheel_angle", "chassis.vx", "chassis.yaw_rate", "chassis.ay"});
    const TimeSeries& steering = needed[0];
    const double level = mean(steering, steering.begin(), steering.begin() + kRestTime);
    const double largest = largestSample(increments(steering, level));
    if (largest < kSmallestSteering) {
        notFound(fmt::format("the steering wheel moves by only {:.2g} deg, expected at least {:.2g} deg",
                             kDegrees * largest, kDegrees * kSmallestSteering));
    }
    const bool whole = restsAtBothEnds(steering);
    const std::size_t turns = turningPoints(steering, 0.5 * largest).size();
    if (whole && turns > 1 && turns < kFewestRandomTurns) {
        notFound(fmt::format(
            "the steering turns back {} times, expected a pulse (1), or a sweep or random steering (at least {})",
            turns, kFewestRandomTurns));
    }
    if (!whole) {
        if (turns < kFewestRandomTurns) {
            notFound(
                fmt::format("the steering turns back {} times and does not end where it began, expected a "
                            "pulse, a sweep or random steering",
                            turns));
        }
        if (steering.end() - steering.begin() < kSegment) {
            notFound(
                fmt::format("the log lasts {:.3g} s, expected at least {:.3g} s of steering that does not "
                            "begin and end at rest",
                            steering.end() - steering.begin(), kSegment));
        }
    }
    SteeringResponse found{};
    found.settings.segment = whole ? 0 : kSegment;
    found.segments = segments(steering, found.settings);
    found.speed = mean(needed[1], steering.begin(), steering.end());
    found.largest_ay = largestSample(needed[3]);

    // The band about its strongest frequency in which the steering has power.
    const auto all = frequencyResponses(steering, std::array{needed[2], needed[3]}, raster(), found.settings);
    const FrequencyCurve& power = all[0];
    const auto strongest =
        std::max_element(power.begin(), power.end(), [](const auto& a, const auto& b) { return a.input < b.input; });
    auto first = strongest, last = strongest;
    const double least = kLeastPower * strongest->input;
    while (first != power.begin() && (first - 1)->input >= least) --first;
    while (last + 1 != power.end() && (last + 1)->input >= least) ++last;
    found.from = first->frequency;
    found.to = last->frequency;
    if (found.to < kNarrow * found.from) {
        notFound(fmt::format("the steering has its power between {:.2g} and {:.2g} Hz, expected a broad band",
                             found.from, found.to));
    }
    found.yaw_rate.assign(first, last + 1);
    found.ay.assign(all[1].begin() + (first - power.begin()), all[1].begin() + (last - power.begin()) + 1);
    return found;
}

Manoeuvre frequencyResponse() {
    return {"frequency_response",
            "sweep, pulse or random steering: gain, phase and coherence over frequency (after ISO 7401)",
            [] { return definitions(frequencyResponseTable()); },
            [](const Log& log, const KnownCar&) { return values(frequencyResponseTable(), steeringResponse(log)); }};
}

}  // namespace tread
