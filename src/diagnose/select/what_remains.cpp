#include "diagnose/select/what_remains.h"

#include <algorithm>
#include <cmath>

#include "diagnose/model/remainder.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr int kSizeSteps = 8;
constexpr double kSizesSettled = 0.05;

double logEvidenceWith(const Fit& fit, const Uncertainty& uncertainty, const Sizes& sizes) {
    Fit other = fit;
    other.sizes = sizes;
    const inference::QuadraticModel here = quadraticAt(other, uncertainty);
    return inference::logEvidence(here, inference::bestStep(here));
}

// Sizes of the largest evidence under a prior.
Sizes sizesUnder(const model::SizesPrior& prior, const Calibration& car, const Fit& fit, Sizes sizes) {
    for (int i = 0; i < kSizeSteps; ++i) {
        const Sizes last = sizes;
        sizes = model::improvedSizes(car.uncertainty, fit.products, last, car.problem.replays.threads, prior);
        if (model::changeOf(last, sizes) < kSizesSettled) break;
    }
    return sizes;
}

}  // namespace

bool Remains::seen() const {
    return beyond_ordinary > kSettings.clear;
}

double Remains::probability() const {
    const double odds = kSettings.unknown_cause / (1 - kSettings.unknown_cause) * std::exp(beyond_ordinary);
    return std::isfinite(odds) ? odds / (1 + odds) : 1;
}

Remains whatRemains(const Calibration& car, const Candidate& model) {
    const Fit& fit = model.fit;
    const Sizes wide = sizesUnder(model::kLargePrior, car, fit, fit.sizes);
    Sizes usual;
    usual.fill(1);
    // The iteration is slow where little is known of a size, so the narrow prior is given several starts.
    double ordinary = -kInfinity;
    for (const Sizes& sizes :
         {wide, sizesUnder(model::kOrdinaryPrior, car, fit, wide), sizesUnder(model::kOrdinaryPrior, car, fit, usual)})
        ordinary = std::max(
            ordinary, logEvidenceWith(fit, car.uncertainty, sizes) + model::logPrior(sizes, model::kOrdinaryPrior));
    const double ratio = std::log(model::birgeRatio(car.drives(), car.uncertainty, fit.rows, fit.sizes));
    Remains remains;
    remains.beyond_ordinary = logEvidenceWith(fit, car.uncertainty, wide) + model::logPrior(wide, model::kLargePrior) -
                              ordinary -
                              0.5 * ratio * (model::kLargePrior.pull(ratio) - model::kOrdinaryPrior.pull(ratio));
    answer::ForceLaw law = forceLaw(car, fit);
    if (law.gain > kSettings.clear) remains.law = std::move(law);
    return remains;
}

}  // namespace tread::diagnose::select
