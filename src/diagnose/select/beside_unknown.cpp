#include "diagnose/select/beside_unknown.h"

#include <algorithm>
#include <cmath>

#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr double kLargest = 100;  // ratio of the sizes of two causes: guess
constexpr double kFinest = 1 / (1 + kLargest);

double logRatio(double share) {
    return std::clamp(std::log(share / (1 - share)), -std::log(kLargest), std::log(kLargest));
}

}  // namespace

ClosedShare closedShare(double with, double without, double scatter) {
    if (without <= scatter) return {0, 1};
    const double closed = std::clamp(1 - with / without, kFinest, 1 - kFinest),
                 around = std::max(scatter / without, kFinest);
    return {std::max(0.0, closed - around), std::min(1.0, closed + around)};
}

double actsBesideUnknown(const ClosedShare& closed, std::size_t named) {
    const double alone = closed.most - closed.least,
                 both = (logRatio(closed.most) - logRatio(closed.least)) / (2 * std::log(kLargest));
    const double odds =
        alone / both * kSettings.prior(named - 1) / (kSettings.prior(named) * static_cast<double>(named));
    return 1 / (1 + odds);
}

}  // namespace tread::diagnose::select
