#include "diagnose/select/unknown_cause.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "diagnose/settings.h"

namespace tread::diagnose::select {
namespace {

constexpr std::array<double, 6> kAllLarger{1.6, 2.5, 4, 8, 16, 50};  // factors on all sizes of disturbances at once
constexpr std::array<double, 3> kOneLarger{4, 15, 50};               // factors on the size of a single kind
constexpr double kLeastShare = 0.02;  // least share of the information in a drive that is used
// Nats that larger disturbances gain on top of a model (D33).
double gainOfLargerDisturbances(const Calibration& car, const Fit& fit) {
    const Sizes& usual = car.uncertainty.sizes;
    const double now = logEvidence(fit, car.uncertainty, usual);
    double best = -kInfinity;
    const auto look = [&](const Sizes& sizes) {
        best = std::max(best, logEvidence(fit, car.uncertainty, sizes) - now);
    };
    for (const double factor : kAllLarger) {
        Sizes sizes = usual;
        for (double& size : sizes) size *= factor;
        look(sizes);
    }
    for (std::size_t kind = 0; kind < usual.size(); ++kind) {
        for (const double factor : kOneLarger) {
            Sizes sizes = usual;
            sizes[kind] *= factor;
            look(sizes);
        }
    }
    return best;
}

// Normal equations of a fit whose knobs are replaced by one value per drive along `direction`: nuisances, values,
// residual.
Eigen::MatrixXd oneValuePerDrive(const Calibration& car, const Fit& fit, const Eigen::VectorXd& direction) {
    const Eigen::Index n = std::ssize(fit.free), nuisances = fit.nuisances(), drives = std::ssize(fit.products);
    const Eigen::Index last = nuisances + drives;
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(last + 1, last + 1);
    Eigen::MatrixXd pick = Eigen::MatrixXd::Zero(n + 1, nuisances + 2);
    pick.topLeftCorner(nuisances, nuisances).setIdentity();
    pick.block(0, nuisances, n, 1) = direction;
    pick(n, nuisances + 1) = 1;
    std::vector<Eigen::Index> places(nuisances + 2);
    std::iota(places.begin(), places.end(), 0);
    places.back() = last;
    for (Eigen::Index d = 0; d < drives; ++d) {
        const Eigen::MatrixXd one =
            model::normalEquations(car.uncertainty, d, fit.products[d], car.uncertainty.sizes).products;
        places[nuisances] = nuisances + d;
        products(places, places) += (pick.transpose() * one * pick).eval();
    }
    // The prior pulls the nuisances back and is part of the gradient.
    for (Eigen::Index i = 0; i < nuisances; ++i) {
        products(i, last) -= fit.at(fit.free[i]);
        products(last, i) = products(i, last);
    }
    return products;
}

}  // namespace

UnknownCause unknownCause(const Calibration& car, const Search& found) {
    const Candidate& best = found.best();
    // A law is allowed for like one more effect, since it too is known only approximately.
    const double allowance = kSettings.structureAllowance(2, best.log_evidence, car.problem.compared());
    answer::ForceLaw law = forceLaw(car, found.none().fit);
    law.gain -= best.log_evidence + allowance;
    const double larger = gainOfLargerDisturbances(car, best.fit), gain = std::max(law.gain, larger);
    if (law.gain <= kSettings.clear) {
        law = forceLaw(car, best.fit);
        law.gain -= allowance;
        law.generalised_force.clear();  // empty, because the law describes only what the effects leave
    }
    if (law.gain < std::max(larger, kSettings.clear)) law = {.gain = law.gain};
    return {.gain = gain, .law = std::move(law)};
}

inference::Heterogeneity heterogeneity(const Calibration& car, const Fit& fit) {
    const Eigen::Index knobs = std::ssize(fit.knobs), nuisances = fit.nuisances();
    if (knobs == 0) return {};
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(nuisances + knobs);
    direction.tail(knobs) = fit.at(fit.knobs).normalized();
    if (direction.isZero(0)) direction(nuisances) = 1;
    const Eigen::MatrixXd left =
        inference::withoutFirst({oneValuePerDrive(car, fit, direction), 0}, nuisances).products;
    const Eigen::Index drives = std::ssize(fit.products);
    return inference::heterogeneity(left.topLeftCorner(drives, drives), left.topRightCorner(drives, 1),
                                    fit.at(fit.knobs).squaredNorm(), kLeastShare);
}

double lookAlikeGain(const inference::Heterogeneity& same, bool compared) {
    return inference::logBayesFactorOfSpread(same, kSettings.varied,
                                             compared ? kSettings.structure : kSettings.signature_error);
}

}  // namespace tread::diagnose::select
