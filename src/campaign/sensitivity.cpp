#include "campaign/sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/math/random.h"
#include "metrics/channels.h"

namespace tread::campaign {
namespace {

constexpr std::size_t kResamples = 200;
constexpr std::size_t kMostResampled = 20'000;  // of more samples, the interval of so many is scaled
constexpr std::size_t kMostClasses = 20;
constexpr std::uint64_t kSeed = 20100215;
constexpr double kTail = 0.025;  // on each side of the interval

// Around the estimate, from what resampling gives.
Share around(double value, std::vector<double> resampled, double scale) {
    std::erase_if(resampled, [](double v) { return !std::isfinite(v); });
    if (!std::isfinite(value) || resampled.size() < 10) return {value, kUndefined, kUndefined};
    std::sort(resampled.begin(), resampled.end());
    const auto at = [&](double share) {
        return resampled[static_cast<std::size_t>(std::lround(share * static_cast<double>(resampled.size() - 1)))];
    };
    const double middle = at(0.5);
    return {value, value + scale * (at(kTail) - middle), value + scale * (at(1 - kTail) - middle)};
}

struct Estimates {
    std::vector<double> first, total;
};

// From the blocks with these numbers.
Estimates estimates(std::span<const double> values, std::size_t factors, std::span<const std::size_t> blocks) {
    const std::size_t width = factors + 2;
    const auto n = static_cast<double>(blocks.size());
    double sum = 0, squares = 0, centre = values[blocks.front() * width];
    for (const std::size_t block : blocks) {
        for (std::size_t row = 0; row < 2; ++row) {
            const double v = values[block * width + row] - centre;
            sum += v;
            squares += v * v;
        }
    }
    const double mean = sum / (2 * n), variance = squares / (2 * n) - mean * mean;
    Estimates found{std::vector<double>(factors, kUndefined), std::vector<double>(factors, kUndefined)};
    // A metric that does not vary has no shares of variance.
    if (!(variance > 1e-24 * (centre * centre + squares / (2 * n)))) return found;
    for (std::size_t i = 0; i < factors; ++i) {
        double first = 0, total = 0;
        for (const std::size_t block : blocks) {
            const double a = values[block * width] - centre, b = values[block * width + 1] - centre;
            const double ab = values[block * width + 2 + i] - centre;
            first += (b - mean) * (ab - a);
            total += (a - ab) * (a - ab);
        }
        found.first[i] = first / n / variance;
        found.total[i] = total / (2 * n) / variance;
    }
    return found;
}

// Classes of the factor: one number for each sample. Equal values are of one class.
std::vector<std::size_t> classesOf(std::span<const double> factor, Values values, std::size_t& classes) {
    std::vector<double> different(factor.begin(), factor.end());
    std::sort(different.begin(), different.end());
    different.erase(std::unique(different.begin(), different.end()), different.end());
    const std::size_t n = different.size();
    constexpr std::size_t kInClass = 5;
    const std::size_t most = std::min(n, kMostClasses);
    classes = values == Values::listed ? most : std::min(most, std::max<std::size_t>(2, n / kInClass));
    std::vector<std::size_t> of;
    of.reserve(factor.size());
    for (const double value : factor) {
        const auto rank = std::lower_bound(different.begin(), different.end(), value) - different.begin();
        of.push_back(static_cast<std::size_t>(rank) * classes / n);
    }
    return of;
}

double effect(std::span<const double> metric, std::span<const std::size_t> classes, std::size_t count,
              std::span<const std::size_t> samples) {
    std::vector<double> sum(count), size(count);
    double total = 0, squares = 0;
    const double centre = metric[samples.front()];
    for (const std::size_t i : samples) {
        const double v = metric[i] - centre;
        sum[classes[i]] += v;
        size[classes[i]] += 1;
        total += v;
        squares += v * v;
    }
    const auto n = static_cast<double>(samples.size());
    const double all = squares - total * total / n;
    double between = -total * total / n, filled = 0;
    for (std::size_t c = 0; c < count; ++c) {
        if (size[c] == 0) continue;
        between += sum[c] * sum[c] / size[c];
        filled += 1;
    }
    if (!(all > 1e-24 * n * (centre * centre + squares / n)) || n <= filled) return kUndefined;
    const double within = (all - between) / (n - filled);
    return (between - (filled - 1) * within) / all;
}

struct Pairs {
    std::vector<double> factor, metric;
};
Pairs finite(std::span<const double> factor, std::span<const double> metric) {
    Pairs pairs;
    for (std::size_t i = 0; i < factor.size(); ++i) {
        if (!std::isfinite(factor[i]) || !std::isfinite(metric[i])) continue;
        pairs.factor.push_back(factor[i]);
        pairs.metric.push_back(metric[i]);
    }
    return pairs;
}

std::vector<std::size_t> drawn(Random& random, std::size_t size, std::size_t of) {
    std::vector<std::size_t> picks(size);
    for (std::size_t& pick : picks) pick = static_cast<std::size_t>(random.uniform() * static_cast<double>(of));
    return picks;
}

}  // namespace

std::vector<SobolIndices> sobolIndices(std::span<const double> values, std::size_t factors) {
    const std::size_t width = factors + 2;
    std::vector<std::size_t> whole;
    for (std::size_t block = 0; block < values.size() / width; ++block) {
        const auto row = values.subspan(block * width, width);
        if (std::all_of(row.begin(), row.end(), [](double v) { return std::isfinite(v); })) whole.push_back(block);
    }
    std::vector<SobolIndices> found(factors,
                                    {{kUndefined, kUndefined, kUndefined}, {kUndefined, kUndefined, kUndefined}});
    if (whole.size() < 2) return found;
    const Estimates all = estimates(values, factors, whole);
    const std::size_t size = std::min(whole.size(), kMostResampled);
    const double scale = std::sqrt(static_cast<double>(size) / static_cast<double>(whole.size()));
    std::vector<std::vector<double>> first(factors), total(factors);
    Random random(kSeed);
    for (std::size_t i = 0; i < kResamples; ++i) {
        std::vector<std::size_t> picks = drawn(random, size, whole.size());
        for (std::size_t& pick : picks) pick = whole[pick];
        const Estimates one = estimates(values, factors, picks);
        for (std::size_t f = 0; f < factors; ++f) {
            first[f].push_back(one.first[f]);
            total[f].push_back(one.total[f]);
        }
    }
    for (std::size_t f = 0; f < factors; ++f)
        found[f] = {around(all.first[f], std::move(first[f]), scale), around(all.total[f], std::move(total[f]), scale)};
    return found;
}

Share mainEffect(std::span<const double> factor, std::span<const double> metric, Values values) {
    const Pairs pairs = finite(factor, metric);
    if (pairs.metric.size() < 3) return {kUndefined, kUndefined, kUndefined};
    std::size_t count = 0;
    const std::vector<std::size_t> classes = classesOf(pairs.factor, values, count);
    std::vector<std::size_t> samples(pairs.metric.size());
    std::iota(samples.begin(), samples.end(), 0u);
    const double value = effect(pairs.metric, classes, count, samples);
    const std::size_t size = std::min(samples.size(), kMostResampled);
    const double scale = std::sqrt(static_cast<double>(size) / static_cast<double>(samples.size()));
    std::vector<double> resampled;
    Random random(kSeed);
    for (std::size_t i = 0; i < kResamples; ++i)
        resampled.push_back(effect(pairs.metric, classes, count, drawn(random, size, samples.size())));
    return around(value, std::move(resampled), scale);
}

ClassMeans classMeans(std::span<const double> factor, std::span<const double> metric, Values values) {
    const Pairs pairs = finite(factor, metric);
    ClassMeans means;
    if (pairs.metric.empty()) return means;
    std::size_t count = 0;
    const std::vector<std::size_t> classes = classesOf(pairs.factor, values, count);
    std::vector<double> size(count);
    means.factor.assign(count, 0);
    means.metric.assign(count, 0);
    for (std::size_t i = 0; i < classes.size(); ++i) {
        means.factor[classes[i]] += pairs.factor[i];
        means.metric[classes[i]] += pairs.metric[i];
        size[classes[i]] += 1;
    }
    for (std::size_t c = 0; c < count; ++c) {
        means.factor[c] /= size[c];
        means.metric[c] /= size[c];
    }
    return means;
}

}  // namespace tread::campaign
