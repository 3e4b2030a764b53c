#include "compare/time_shift.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/math/median.h"
#include "log/resample.h"

namespace tread {
namespace {

constexpr std::size_t kFewestSamples = 16;  // a correlation over less says nothing
constexpr double kLowestCorrelation = 0.5;  // below, the channels do not show the same thing

// Pearson's correlation coefficient; NaN when one of the two is constant.
double correlation(std::span<const double> a, std::span<const double> b) {
    const auto n = static_cast<double>(a.size());
    double sum_a = 0, sum_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum_a += a[i];
        sum_b += b[i];
    }
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double da = a[i] - sum_a / n, db = b[i] - sum_b / n;
        aa += da * da;
        bb += db * db;
        ab += da * db;
    }
    return ab / std::sqrt(aa * bb);
}

std::vector<double> uniform(double from, double step, std::size_t count) {
    std::vector<double> times(count);
    for (std::size_t i = 0; i < count; ++i) times[i] = from + static_cast<double>(i) * step;
    return times;
}

}  // namespace

std::optional<double> estimateTimeShift(const Log& reference, const Log& candidate, std::string_view channel,
                                        double largest) {
    const Channel* a = reference.find(channel);
    const Channel* b = candidate.find(channel);
    if (!a || !b) return {};

    // Both on one uniform time base; the reference without the margin that the candidate may be shifted by.
    const std::span<const double> time_a = reference.channels.front().values,
                                  time_b = candidate.channels.front().values;
    const double step = std::min(medianStep(time_a), medianStep(time_b));
    if (!(step > 0)) return {};
    const double from = std::max(time_a.front(), time_b.front()), to = std::min(time_a.back(), time_b.back());
    const auto lags = static_cast<std::size_t>(std::floor(largest / step));
    const double inner = to - from - 2 * static_cast<double>(lags) * step;
    if (lags == 0 || !(inner >= static_cast<double>(kFewestSamples) * step)) return {};
    const auto count = static_cast<std::size_t>(inner / step);
    const auto values_a = resample(time_a, a->values, uniform(from + static_cast<double>(lags) * step, step, count));
    const auto values_b = resample(time_b, b->values, uniform(from, step, count + 2 * lags));

    std::vector<double> found;
    for (std::size_t lag = 0; lag <= 2 * lags; ++lag) {
        found.push_back(correlation(values_a, std::span(values_b).subspan(lag, count)));
        if (std::isnan(found.back())) return {};
    }
    const auto best = static_cast<std::size_t>(std::max_element(found.begin(), found.end()) - found.begin());
    if (best == 0 || best == 2 * lags || found[best] < kLowestCorrelation) return {};

    // The peak between the samples: the parabola through the three highest points.
    const double left = found[best - 1], middle = found[best], right = found[best + 1];
    const double curvature = left - 2 * middle + right;
    const double fraction = curvature < 0 ? 0.5 * (left - right) / curvature : 0;
    return (static_cast<double>(best) - static_cast<double>(lags) + fraction) * step;
}

}  // namespace tread
