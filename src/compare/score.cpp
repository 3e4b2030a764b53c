// ISO/TS 18571:2014, Road vehicles - Objective rating metric for non-ambiguous signals, as implemented by OpenVT.
#include "compare/score.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tread {
namespace {

using Curve1 = std::span<const double>;

constexpr std::size_t kSmoothed = 9;  // samples of the moving average over the slopes
constexpr double kFlat = 1e-20;       // variance over the squared mean that is rounding, not motion

double largestOf(Curve1 curve) {
    double peak = 0;
    for (const double value : curve) peak = std::max(peak, std::abs(value));
    return peak;
}

// 1 without error, 0 from `zero` on.
double falling(double error, double zero, double exponent) {
    return error < zero ? std::pow((zero - error) / zero, exponent) : 0;
}

// An error as a share of the reference; equal nothings have none.
double share(double error, double reference) {
    if (error == 0) return 0;
    return reference > 0 ? error / reference : kInfinity;
}

double corridorScore(Curve1 reference, Curve1 candidate, const ScoreParams& p) {
    const double peak = largestOf(reference);
    const double inner = p.corridor_inner * peak, outer = p.corridor_outer * peak;
    double sum = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        const double away = std::abs(reference[i] - candidate[i]);
        if (away <= inner) sum += 1;
        else if (away < outer) sum += std::pow((outer - away) / (outer - inner), p.corridor_exponent);
    }
    return sum / static_cast<double>(reference.size());
}

// Pearson's coefficient; -1 when one of the two is constant, so that no shift is found in it.
double correlationOrLeast(Curve1 a, Curve1 b) {
    const auto n = static_cast<double>(a.size());
    double mean_a = 0, mean_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        mean_a += a[i] / n;
        mean_b += b[i] / n;
    }
    double aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
        ab += (a[i] - mean_a) * (b[i] - mean_b);
    }
    const bool flat = aa <= kFlat * n * mean_a * mean_a || bb <= kFlat * n * mean_b * mean_b;
    return flat || !(aa * bb > 0) ? -1 : ab / std::sqrt(aa * bb);
}

struct Overlap {
    Curve1 reference, candidate;
};

// The samples that lie on each other when the candidate, `late` samples late, is moved back.
Overlap overlap(Curve1 reference, Curve1 candidate, int late) {
    const auto by = static_cast<std::size_t>(std::abs(late)), n = reference.size() - by;
    if (late >= 0) return {reference.first(n), candidate.subspan(by)};
    return {reference.subspan(by), candidate.first(n)};
}

// The shift with the highest correlation, the smallest of equals.
int bestShift(Curve1 reference, Curve1 candidate, int largest) {
    constexpr double kEqual = 1e-12;
    int best = 0;
    double highest = correlationOrLeast(reference, candidate);
    for (int by = 1; by <= largest; ++by) {
        for (const int late : {by, -by}) {
            const Overlap both = overlap(reference, candidate, late);
            const double found = correlationOrLeast(both.reference, both.candidate);
            if (found > highest + kEqual) {
                highest = found;
                best = late;
            }
        }
    }
    return best;
}

// Error of the curves along the path of least squared distance on which time may stretch (dynamic time warping within
// a band about the diagonal), as a share of the reference.
double warpedError(Curve1 reference, Curve1 candidate, double window) {
    const std::size_t n = reference.size();
    const std::size_t band = std::max<std::size_t>(1, static_cast<std::size_t>(window * static_cast<double>(n)));
    const std::size_t width = 2 * band + 1;
    enum Step : std::uint8_t { diagonal, reference_only, candidate_only };
    std::vector<std::uint8_t> steps(n * width);
    std::vector<double> above(width, kInfinity), row(width, kInfinity);
    const auto at = [&](std::size_t i, std::size_t j) { return j + band - i; };  // column of the band
    for (std::size_t i = 0; i < n; ++i) {
        std::fill(row.begin(), row.end(), kInfinity);
        const std::size_t first = i > band ? i - band : 0, last = std::min(n - 1, i + band);
        for (std::size_t j = first; j <= last; ++j) {
            const double distance = (reference[i] - candidate[j]) * (reference[i] - candidate[j]);
            const std::size_t k = at(i, j);
            double best = i > 0 && j > 0 ? above[k] : (i + j == 0 ? 0 : kInfinity);
            Step step = diagonal;
            if (i > 0 && k + 1 < width && above[k + 1] < best) {
                best = above[k + 1];
                step = reference_only;
            }
            if (j > first && row[k - 1] < best) {
                best = row[k - 1];
                step = candidate_only;
            }
            row[k] = best + distance;
            steps[i * width + k] = step;
        }
        std::swap(row, above);
    }
    double error = 0, size = 0;
    for (std::size_t i = n - 1, j = n - 1;;) {
        error += std::abs(reference[i] - candidate[j]);
        size += std::abs(reference[i]);
        if (i == 0 && j == 0) return share(error, size);
        const std::uint8_t step = steps[i * width + at(i, j)];
        if (step != candidate_only) --i;
        if (step != reference_only) --j;
    }
}

// Central differences, then a moving average.
std::vector<double> slopes(Curve1 curve) {
    const std::size_t n = curve.size();
    std::vector<double> raw(n), smooth(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t left = i == 0 ? 0 : i - 1, right = std::min(i + 1, n - 1);
        raw[i] = (curve[right] - curve[left]) / static_cast<double>(right - left);
    }
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t half = std::min({kSmoothed / 2, i, n - 1 - i});
        for (std::size_t k = i - half; k <= i + half; ++k) smooth[i] += raw[k] / static_cast<double>(2 * half + 1);
    }
    return smooth;
}

double slopeError(Curve1 reference, Curve1 candidate) {
    const std::vector<double> a = slopes(reference), b = slopes(candidate);
    double error = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        error += std::abs(b[i] - a[i]);
        size += std::abs(a[i]);
    }
    return share(error, size);
}

}  // namespace

Score score(std::span<const double> reference, std::span<const double> candidate, const ScoreParams& params) {
    Score result;
    const double largest = params.largest_shift * static_cast<double>(reference.size());
    result.corridor = corridorScore(reference, candidate, params);
    result.shift = bestShift(reference, candidate, static_cast<int>(largest));
    result.phase = falling(std::abs(result.shift), largest, params.phase_exponent);
    const Overlap both = overlap(reference, candidate, result.shift);
    result.magnitude = falling(warpedError(both.reference, both.candidate, params.warping_window),
                               params.magnitude_error, params.magnitude_exponent);
    result.slope = falling(slopeError(both.reference, both.candidate), params.slope_error, params.slope_exponent);
    result.total = params.corridor_weight * result.corridor + params.phase_weight * result.phase +
                   params.magnitude_weight * result.magnitude + params.slope_weight * result.slope;
    return result;
}

std::string_view gradeOf(double score) {
    return score > 0.94 ? "excellent" : score > 0.80 ? "good" : score > 0.58 ? "fair" : "poor";
}

}  // namespace tread
