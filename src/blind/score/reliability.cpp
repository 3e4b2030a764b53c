#include "blind/score/reliability.h"

#include <algorithm>
#include <cmath>

namespace tread::blind::score {
namespace {

constexpr double kNormal95 = 1.959963984540054;  // two-sided

// Mean distance of the number of right claims from its mean, if each is right with the stated probability.
double scatterOf(const std::vector<double>& stated) {
    std::vector<double> chance{1};  // of 0, 1, 2, ... right ones
    double mean = 0;
    for (const double p : stated) {
        mean += p;
        chance.push_back(0);
        for (std::size_t k = chance.size() - 1; k > 0; --k) chance[k] = chance[k] * (1 - p) + chance[k - 1] * p;
        chance[0] *= 1 - p;
    }
    double sum = 0;
    for (std::size_t k = 0; k < chance.size(); ++k) sum += chance[k] * std::abs(static_cast<double>(k) - mean);
    return sum;
}

int claimsIn(const std::vector<ReliabilityBin>& bins) {
    int claims = 0;
    for (const ReliabilityBin& bin : bins) claims += bin.claims;
    return claims;
}

}  // namespace

Interval wilson(int hits, int of) {
    if (of <= 0) return {};
    const double n = of, p = hits / n, z2 = kNormal95 * kNormal95;
    const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
    const double half = kNormal95 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
    return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

std::vector<ReliabilityBin> reliability(const std::vector<Claim>& claims, int bins) {
    std::vector<ReliabilityBin> table;
    for (int i = 0; i < bins; ++i)
        table.push_back({.from = static_cast<double>(i) / bins, .to = static_cast<double>(i + 1) / bins});
    std::vector<std::vector<double>> stated(table.size());
    for (const Claim& claim : claims) {
        const int at = std::clamp(static_cast<int>(claim.probability * bins), 0, bins - 1);
        ReliabilityBin& bin = table[static_cast<std::size_t>(at)];
        bin.claims += 1;
        bin.right += claim.right ? 1 : 0;
        bin.stated += (claim.probability - bin.stated) / bin.claims;
        stated[static_cast<std::size_t>(at)].push_back(claim.probability);
    }
    for (std::size_t i = 0; i < table.size(); ++i) table[i].scatter = scatterOf(stated[i]);
    return table;
}

double calibrationError(const std::vector<ReliabilityBin>& bins) {
    double sum = 0;
    for (const ReliabilityBin& bin : bins) sum += std::abs(bin.right - bin.claims * bin.stated);
    const int claims = claimsIn(bins);
    return claims > 0 ? sum / claims : 0;
}

double calibrationErrorByChance(const std::vector<ReliabilityBin>& bins) {
    double sum = 0;
    for (const ReliabilityBin& bin : bins) sum += bin.scatter;
    const int claims = claimsIn(bins);
    return claims > 0 ? sum / claims : 0;
}

}  // namespace tread::blind::score
