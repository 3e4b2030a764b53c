#include "metrics/series.h"

#include <algorithm>
#include <cmath>

#include "log/resample.h"

namespace tread {
namespace {

// Noise below this share of the signal's range moves no metric by more than that.
constexpr double kNegligibleNoise = 1e-3;
constexpr std::size_t kFewestForParabola = 5;

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

struct LocalFit {
    double value;
    double slope;
};

// Least-squares parabola through the samples [first, last) around time t, which is at index `here`.
LocalFit localFit(const TimeSeries& series, std::size_t first, std::size_t last, std::size_t here) {
    double s0 = 0, s1 = 0, s2 = 0, s3 = 0, s4 = 0, y0 = 0, y1 = 0, y2 = 0;
    const double scale = series.time[last - 1] - series.time[first];
    for (std::size_t i = first; i < last; ++i) {
        const double x = (series.time[i] - series.time[here]) / scale, y = series.value[i] - series.value[here];
        s0 += 1;
        s1 += x;
        s2 += x * x;
        s3 += x * x * x;
        s4 += x * x * x * x;
        y0 += y;
        y1 += x * y;
        y2 += x * x * y;
    }
    // Cramer's rule for [s0 s1 s2; s1 s2 s3; s2 s3 s4] [value; slope; bend] = [y0; y1; y2].
    const double c0 = s2 * s4 - s3 * s3, c1 = s2 * s3 - s1 * s4, c2 = s1 * s3 - s2 * s2;
    const double d1 = s0 * s4 - s2 * s2, d2 = s1 * s2 - s0 * s3;
    const double determinant = s0 * c0 + s1 * c1 + s2 * c2;
    return {series.value[here] + (y0 * c0 + y1 * c1 + y2 * c2) / determinant,
            (y0 * c1 + y1 * d1 + y2 * d2) / determinant / scale};
}

double plainSlope(const TimeSeries& series, std::size_t i) {
    const std::size_t left = i == 0 ? 0 : i - 1, right = std::min(i + 1, series.size() - 1);
    if (left == right) return 0;
    return (series.value[right] - series.value[left]) / (series.time[right] - series.time[left]);
}

TimeSeries local(const TimeSeries& series, double half_width, double LocalFit::*what) {
    TimeSeries out{series.time, {}};
    out.value.reserve(series.size());
    std::size_t first = 0, last = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        // A hair more than the half width, so that rounding in the time column does not change the window.
        const double reach = half_width * (1 + 1e-9);
        while (series.time[first] < series.time[i] - reach) ++first;
        while (last < series.size() && series.time[last] <= series.time[i] + reach) ++last;
        const LocalFit fit = last - first < kFewestForParabola ? LocalFit{series.value[i], plainSlope(series, i)}
                                                               : localFit(series, first, last, i);
        out.value.push_back(fit.*what);
    }
    return out;
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

double noise(const TimeSeries& series) {
    std::vector<double> differences;
    const std::vector<double>& v = series.value;
    for (std::size_t i = 4; i < v.size(); ++i) {
        differences.push_back(std::abs(v[i] - 4 * v[i - 1] + 6 * v[i - 2] - 4 * v[i - 3] + v[i - 4]));
    }
    if (differences.empty()) return 0;
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    // Median to standard deviation of a normal distribution; sum of the squared weights 1, 4, 6, 4, 1.
    return 1.4826 * *middle / std::sqrt(70.0);
}

TimeSeries smoothed(const TimeSeries& series, double half_width) {
    return local(series, half_width, &LocalFit::value);
}
TimeSeries derivative(const TimeSeries& series, double half_width) {
    return local(series, half_width, &LocalFit::slope);
}

TimeSeries averaged(const TimeSeries& series, double half_width) {
    TimeSeries out = series;
    for (std::size_t i = 0; i < series.size(); ++i) {
        out.value[i] = mean(series, series.time[i] - half_width, series.time[i] + half_width);
    }
    return out;
}

bool isNoisy(const TimeSeries& series) {
    const auto [low, high] = std::minmax_element(series.value.begin(), series.value.end());
    return noise(series) > kNegligibleNoise * (*high - *low);
}

TimeSeries cleaned(const TimeSeries& series, double half_width) {
    return isNoisy(series) ? smoothed(series, half_width) : series;
}

TimeSeries cleanDerivative(const TimeSeries& series, double half_width) {
    return derivative(series, isNoisy(series) ? half_width : 0);
}

}  // namespace tread
