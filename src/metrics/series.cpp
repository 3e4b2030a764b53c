#include "metrics/series.h"

#include <algorithm>
#include <cmath>

#include "log/resample.h"

namespace tread {
namespace {

std::size_t firstAtOrAfter(const TimeSeries& series, double t) {
    return static_cast<std::size_t>(std::lower_bound(series.time.begin(), series.time.end(), t) - series.time.begin());
}

// Vertex of the parabola through sample i and its neighbours, when that is where the sample's peak is.
Instant vertex(const TimeSeries& series, std::size_t i) {
    const Instant sample{series.time[i], series.value[i]};
    if (i == 0 || i + 1 == series.size()) return sample;
    const double hl = series.time[i] - series.time[i - 1], hr = series.time[i + 1] - series.time[i];
    const double sl = (series.value[i] - series.value[i - 1]) / hl, sr = (series.value[i + 1] - series.value[i]) / hr;
    const double curvature = 2 * (sr - sl) / (hl + hr);
    if (curvature == 0) return sample;
    const double slope = (sl * hr + sr * hl) / (hl + hr);
    const double to = std::clamp(-slope / curvature, -hl, hr);
    return {sample.time + to, sample.value + slope * to + 0.5 * curvature * to * to};
}

Instant extreme(const TimeSeries& series, double from, double to, double sign) {
    std::size_t best = std::min(firstAtOrAfter(series, from), series.size() - 1);
    for (std::size_t i = best; i < series.size() && series.time[i] <= to; ++i) {
        if (sign * series.value[i] > sign * series.value[best]) best = i;
    }
    return vertex(series, best);
}

}  // namespace

double at(const TimeSeries& series, double t) {
    if (t <= series.begin()) return series.value.front();
    if (t >= series.end()) return series.value.back();
    return valueAt(series.time, series.value, t);
}

double integral(const TimeSeries& series, double from, double to) {
    double sum = 0, time = from, value = at(series, from);
    for (std::size_t i = firstAtOrAfter(series, from); i < series.size() && series.time[i] < to; ++i) {
        sum += 0.5 * (value + series.value[i]) * (series.time[i] - time);
        time = series.time[i];
        value = series.value[i];
    }
    return sum + 0.5 * (value + at(series, to)) * (to - time);
}

double mean(const TimeSeries& series, double from, double to) {
    from = std::max(from, series.begin());
    to = std::min(to, series.end());
    return to > from ? integral(series, from, to) / (to - from) : at(series, from);
}

TimeSeries part(const TimeSeries& series, double from, double to) {
    from = std::max(from, series.begin());
    to = std::min(to, series.end());
    TimeSeries out{{from}, {at(series, from)}};
    for (std::size_t i = firstAtOrAfter(series, from); i < series.size() && series.time[i] < to; ++i) {
        if (series.time[i] == from) continue;
        out.time.push_back(series.time[i]);
        out.value.push_back(series.value[i]);
    }
    if (to > from) {
        out.time.push_back(to);
        out.value.push_back(at(series, to));
    }
    return out;
}

TimeSeries increments(const TimeSeries& series, double level, double factor) {
    TimeSeries out = series;
    for (double& value : out.value) value = factor * (value - level);
    return out;
}

std::optional<double> firstCrossing(const TimeSeries& series, double level, double from, double to) {
    from = std::max(from, series.begin());
    double time = from, value = at(series, from) - level;
    if (value == 0) return from;
    for (std::size_t i = firstAtOrAfter(series, from); i < series.size() && time < to; ++i) {
        const double next = series.value[i] - level;
        if (series.time[i] > time && (next == 0 || std::signbit(next) != std::signbit(value))) {
            const double crossing = time + value / (value - next) * (series.time[i] - time);
            if (crossing > to) return {};
            return crossing;
        }
        time = series.time[i];
        value = next;
    }
    return {};
}

std::optional<double> lastCrossing(const TimeSeries& series, double level, double from, double to) {
    std::optional<double> last;
    for (double t = from; t <= to;) {
        const auto next = firstCrossing(series, level, t, to);
        if (!next) break;
        last = next;
        // On to the next sample: there is no second crossing before it.
        const auto behind = std::upper_bound(series.time.begin(), series.time.end(), *next);
        if (behind == series.time.end()) break;
        t = *behind;
    }
    return last;
}

Instant highest(const TimeSeries& series, double from, double to) {
    return extreme(series, from, to, 1);
}
Instant lowest(const TimeSeries& series, double from, double to) {
    return extreme(series, from, to, -1);
}

double largestSample(const TimeSeries& series) {
    double largest = 0;
    for (double value : series.value) largest = std::max(largest, std::abs(value));
    return largest;
}

Range range(const TimeSeries& series) {
    const auto [least, most] = std::minmax_element(series.value.begin(), series.value.end());
    return {*least, *most};
}

std::vector<Instant> turningPoints(const TimeSeries& series, double swing) {
    std::vector<Instant> points;
    const std::vector<double>& v = series.value;
    std::size_t low = 0, high = 0;
    int direction = 0;  // +1 rising, -1 falling, 0 not yet known
    for (std::size_t i = 1; i < v.size(); ++i) {
        if (v[i] > v[high]) high = i;
        if (v[i] < v[low]) low = i;
        if (direction >= 0 && v[i] <= v[high] - swing) {
            if (direction > 0) points.push_back(vertex(series, high));
            direction = -1;
            low = i;
        } else if (direction <= 0 && v[i] >= v[low] + swing) {
            if (direction < 0) points.push_back(vertex(series, low));
            direction = 1;
            high = i;
        }
    }
    return points;
}

Line fitLine(std::span<const double> x, std::span<const double> y) {
    const auto n = static_cast<double>(x.size());
    double mx = 0, my = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mx += x[i] / n;
        my += y[i] / n;
    }
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mx) * (x[i] - mx);
        xy += (x[i] - mx) * (y[i] - my);
    }
    const double slope = xx > 0 ? xy / xx : 0;
    return {my - slope * mx, slope};
}

}  // namespace tread
