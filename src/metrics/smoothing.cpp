#include "metrics/smoothing.h"

#include <algorithm>
#include <cmath>

namespace tread {
namespace {

// Noise below this share of the signal's range moves no metric by more than that.
constexpr double kNegligibleNoise = 1e-3;
constexpr std::size_t kFewestForParabola = 5;

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
    return noise(series) > kNegligibleNoise * range(series).width();
}

TimeSeries cleaned(const TimeSeries& series, double half_width) {
    return isNoisy(series) ? smoothed(series, half_width) : series;
}

TimeSeries cleanDerivative(const TimeSeries& series, double half_width) {
    return derivative(series, isNoisy(series) ? half_width : 0);
}

}  // namespace tread
