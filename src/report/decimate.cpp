#include "report/decimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tread {
namespace {

// Adds the smallest and the largest finite sample of one curve in [begin, end), and one that is not finite, so that a
// gap in the data stays a gap in the chart.
void addExtremes(std::span<const double> curve, std::size_t begin, std::size_t end, std::vector<std::size_t>& kept) {
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::size_t lowest = kNone, highest = kNone, gap = kNone;
    for (std::size_t i = begin; i < end; ++i) {
        if (!std::isfinite(curve[i])) {
            gap = i;
        } else {
            if (lowest == kNone || curve[i] < curve[lowest]) lowest = i;
            if (highest == kNone || curve[i] > curve[highest]) highest = i;
        }
    }
    for (const std::size_t index : {lowest, highest, gap}) {
        if (index != kNone) kept.push_back(index);
    }
}

}  // namespace

std::vector<std::size_t> keepExtremes(std::span<const std::span<const double>> curves, std::size_t most) {
    if (curves.empty()) return {};
    std::size_t samples = curves.front().size();
    for (const auto& curve : curves) samples = std::min(samples, curve.size());

    std::vector<std::size_t> kept;
    if (samples <= most) {
        kept.resize(samples);
        std::iota(kept.begin(), kept.end(), std::size_t{0});
        return kept;
    }
    const std::size_t per_bucket = 2 * curves.size();
    const std::size_t buckets = std::max<std::size_t>(1, most / per_bucket);
    kept.push_back(0);
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        const std::size_t begin = bucket * samples / buckets;
        const std::size_t end = (bucket + 1) * samples / buckets;
        for (const auto& curve : curves) addExtremes(curve, begin, end, kept);
    }
    kept.push_back(samples - 1);
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    return kept;
}

}  // namespace tread
