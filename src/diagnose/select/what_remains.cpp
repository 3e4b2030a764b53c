#include "diagnose/select/what_remains.h"

#include <algorithm>
#include <cmath>

#include "diagnose/model/remainder.h"
#include "diagnose/select/closeness.h"
#include "diagnose/select/doubt.h"
#include "diagnose/select/visible_gap.h"
#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr int kSizeStepsOfRemainder = 8;
constexpr double kRemainderSettled = 0.05;

double logEvidenceWith(const Fit& fit, const Uncertainty& uncertainty, const Sizes& sizes) {
    Fit other = fit;
    other.sizes = sizes;
    const inference::QuadraticModel here = quadraticAt(other, uncertainty);
    return inference::logEvidence(here, inference::bestStep(here));
}

// Sizes of the largest evidence under a prior.
Sizes sizesUnder(const model::SizesPrior& prior, const Calibration& car, const Fit& fit, Sizes sizes) {
    for (int i = 0; i < kSizeStepsOfRemainder; ++i) {
        const Sizes last = sizes;
        sizes = model::improvedSizes(car.uncertainty, fit.products, last, car.problem.replays.threads, prior);
        if (model::changeOf(last, sizes) < kRemainderSettled) break;
    }
    return sizes;
}

// The ordinary remainder of the largest evidence.
struct Ordinary {
    double log_evidence = -kInfinity;
    Sizes sizes{};
};

// `wide`: sizes under the wide prior. The iteration is slow where little is known of a size, so that it has several
// starts.
Ordinary ordinaryBeside(const Calibration& car, const Fit& fit, const Sizes& wide) {
    Sizes usual;
    usual.fill(1);
    Ordinary best;
    for (const Sizes& sizes : {wide, sizesUnder(model::kOrdinaryPrior, car, fit, wide),
                               sizesUnder(model::kOrdinaryPrior, car, fit, usual)}) {
        const double evidence =
            logEvidenceWith(fit, car.uncertainty, sizes) + model::logPrior(sizes, model::kOrdinaryPrior);
        if (evidence > best.log_evidence) best = {evidence, sizes};
    }
    return best;
}

// What the freedom to be large costs: the density of the wide prior over that of the narrow one, as far as the data
// determine a size, and as probable as it is that the size is above the usual one. At most 0.
double costOfFreedom(const Sizes& sizes, const model::Left& left) {
    double nats = 0;
    for (const model::Disturbed kind : model::kAllDisturbed) {
        const std::size_t k = placeOf(kind);
        const double information = left.information(k);
        const auto width = [&](const model::SizesPrior& prior) {
            return std::sqrt(1 + information * std::pow(prior.spreadOf(kind), 2));
        };
        const double above = 0.5 * std::erfc(-std::log(sizes[k]) * std::sqrt(0.5 * information));
        nats += std::log1p(above * (width(model::kOrdinaryPrior) / width(model::kLargePrior) - 1));
    }
    return nats;
}

std::vector<Eigen::VectorXd> residuals(const Calibration& car, const Fit& fit) {
    std::vector<Eigen::VectorXd> all;
    for (std::size_t d = 0; d < fit.rows.size(); ++d)
        all.push_back(model::residual(car.drives(), car.uncertainty, fit.rows, d));
    return all;
}

// Whitened changes of the rows of each drive by forces of these sizes.
std::vector<Eigen::VectorXd> whitened(const Calibration& car, const std::vector<Eigen::MatrixXd>& changes,
                                      const Eigen::VectorXd& sizes) {
    std::vector<Eigen::VectorXd> all;
    for (std::size_t d = 0; d < changes.size(); ++d)
        all.emplace_back(car.uncertainty.noise[d].over(changes[d] * sizes));
    return all;
}

// Numbers that moved too far, in view of errors of the signatures, which look like what they change.
double strainOf(const Calibration& car, const Fit& fit, const model::ChannelSquares& squares) {
    double strain = 0;
    for (Eigen::Index i = 0; i < fit.numbers(); ++i) {
        const double nats = natsOfTail(fit.at(fit.free[i]));
        if (nats == 0) continue;
        std::vector<Eigen::VectorXd> changed;
        for (const Eigen::MatrixXd& columns : fit.columns) changed.emplace_back(columns.col(i));
        strain += nats / doubtAlong(car, squares, fit, changed);
    }
    return strain;
}

}  // namespace

double natsOfTail(double deviation) {
    const double half = 0.5 * deviation * deviation;
    return std::max(0.0, half - 2.5 * std::log1p(half));
}

bool Remains::visible() const {
    return by_chance < kSettings.false_alarm;
}

double Remains::nats() const {
    double seen = 0;
    if (visible()) seen = std::max(beyond_ordinary + of_law, rejected);
    else if (law_visible) seen = std::min(beyond_ordinary, 0.0) + of_law;
    return std::max({seen, strain, vibration.gain});
}

double Remains::probability() const {
    const double odds = kSettings.unknown_cause / (1 - kSettings.unknown_cause) * std::exp(nats());
    return std::isfinite(odds) ? odds / (1 + odds) : 1;
}

Remains whatRemains(const Calibration& car, const Candidate& model, const Closest& closest) {
    const Fit& fit = model.fit;
    const Sizes wide = sizesUnder(model::kLargePrior, car, fit, fit.sizes);
    const Ordinary ordinary = ordinaryBeside(car, fit, wide);
    const model::ChannelSquares squares(car.drives(), car.uncertainty, ordinary.sizes);
    const double ratio = std::log(model::birgeRatio(car.drives(), car.uncertainty, fit.rows, fit.sizes));
    Remains remains;
    remains.strain = strainOf(car, fit, squares);
    remains.by_chance = chanceOfGap(car, fit, closest.rows);
    const double of_ratio = 0.5 * ratio * (model::kOrdinaryPrior.pull(ratio) - model::kLargePrior.pull(ratio)) +
                            (ratio > 0 ? std::log(model::kOrdinaryPrior.spread / model::kLargePrior.spread) : 0);
    remains.beyond_ordinary =
        (logEvidenceWith(fit, car.uncertainty, wide) + model::logPrior(wide, model::kLargePrior) -
         ordinary.log_evidence + of_ratio +
         costOfFreedom(wide, model::leftBy(car.uncertainty, fit.products, wide, car.problem.replays.threads))) /
        doubtAlong(car, squares, fit, residuals(car, fit));
    if (model.law.told.gain > 0) {
        const std::vector<Eigen::MatrixXd> changes = changesBy(model.law, car);
        remains.of_law = model.law.told.gain / doubtAlong(car, squares, fit, whitened(car, changes, model.law.forces));
        remains.law_visible = !forcesCloseByChance(car, model.effects, closest, changes);
    }
    if ((remains.visible() || remains.law_visible) && remains.of_law > kSettings.clear) remains.law = model.law.told;
    return remains;
}

}  // namespace tread::diagnose::select
