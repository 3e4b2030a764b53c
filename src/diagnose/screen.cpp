#include "diagnose/screen.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnose/thresholds.h"
#include "identify/bounded_step.h"

namespace tread {
namespace {

constexpr double kAlike = 0.5;  // cosine: pairs below are hard to tell apart because one of them hardly shows
constexpr std::size_t kMostConfusable = 30;

// Linear evidence of knobs with these products, as far as their bounds let them.
double gain(const Study& study, const Eigen::MatrixXd& products, std::size_t effect,
            const std::vector<Eigen::Index>& places, const Deviation& at) {
    const Eigen::Index n = static_cast<Eigen::Index>(places.size()), last = products.cols() - 1;
    const Eigen::MatrixXd information = products(places, places);
    const Eigen::VectorXd gradient = products(places, last);
    const Eigen::LLT<Eigen::MatrixXd> factor(Eigen::MatrixXd::Identity(n, n) + information);
    Eigen::VectorXd lowest(n), highest(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index p = study.knobs[effect][static_cast<std::size_t>(i)];
        const Parameter& parameter = study.bench.parameters[static_cast<std::size_t>(p)];
        lowest(i) = parameter.lowest - at(p), highest(i) = parameter.highest - at(p);
    }
    const Eigen::VectorXd best = boundedStep(information, gradient, Eigen::VectorXd::Zero(n), 0, lowest, highest);
    const double explained = gradient.dot(best) - 0.5 * (best.dot(information * best) + best.squaredNorm());
    return explained - factor.matrixLLT().diagonal().array().log().sum();
}

Eigen::MatrixXd withoutNuisances(const Gram& gram, std::size_t nuisances) {
    std::vector<Eigen::Index> out(nuisances);
    std::iota(out.begin(), out.end(), 0);
    const auto left = gram.products.cols() - static_cast<Eigen::Index>(nuisances);
    return marginalised(gram, out).products.bottomRightCorner(left, left);
}

}  // namespace

std::vector<Eigen::Index> placesOf(const Study& study, std::size_t effect) {
    Eigen::Index first = 0;
    for (std::size_t e = 0; e < effect; ++e) first += static_cast<Eigen::Index>(study.knobs[e].size());
    std::vector<Eigen::Index> places(study.knobs[effect].size());
    std::iota(places.begin(), places.end(), first);
    return places;
}

Screen screen(const Study& study, const std::vector<DriveGram>& grams) {
    Screen result;
    const Gram gram = total(grams, study.uncertainty, study.uncertainty.sizes);
    result.products = withoutNuisances(gram, study.calibrated.nuisances.size());
    for (std::size_t e = 0; e < study.effects.size(); ++e) {
        const std::vector<Eigen::Index> places = placesOf(study, e);
        double most = 0;
        for (const Eigen::Index i : places) most = std::max(most, 0.5 * result.products(i, i));
        result.detectability.push_back(most);
    }
    result.gain = gainsOver(study, study.calibrated, study.calibration);
    return result;
}

void lookAgain(Study& study, const Fit& found, Screen& screen) {
    for (std::size_t e = 0; e < study.effects.size(); ++e) {
        if (screen.detectability[e] < kThresholds.shows) continue;
        Deviation with = found.at;
        bool one_sided = false;
        for (const Eigen::Index k : study.knobs[e]) {
            const Parameter& knob = study.bench.parameters[static_cast<std::size_t>(k)];
            one_sided = one_sided || knob.lowest == 0 || knob.highest == 0;
            with(k) = std::clamp(knob.highest > 0 ? 1.0 : -1.0, knob.lowest, knob.highest);
        }
        const bool is_there = std::any_of(study.knobs[e].begin(), study.knobs[e].end(), [&](Eigen::Index k) {
            return std::find(found.knobs.begin(), found.knobs.end(), k) != found.knobs.end();
        });
        if (!one_sided || is_there) continue;
        const std::optional<Rows> rows = rowsAt(study.bench, with);
        if (!rows) continue;
        std::vector<Eigen::MatrixXd> further(rows->size());
        for (std::size_t d = 0; d < rows->size(); ++d) {
            further[d].resize((*rows)[d].size(), 2);
            further[d] << study.uncertainty.noise[d].over((*rows)[d] - found.rows[d]),
                residual(study.bench, study.uncertainty, found.rows, d);
        }
        const double shown = 0.5 * productsBeside(study, found, further, study.uncertainty.sizes)(0, 0);
        screen.detectability[e] = std::min(screen.detectability[e], shown);
    }
}

Eigen::MatrixXd productsBeside(const Study& study, const Fit& fit, const std::vector<Eigen::MatrixXd>& further,
                               const std::array<double, kDisturbances>& sizes) {
    std::vector<DriveGram> grams;
    for (std::size_t d = 0; d < fit.rows.size(); ++d) {
        const DriveGram free = driveGram(fit.columns[d], study.uncertainty.directions[d]);
        grams.push_back(extended(free, fit.columns[d], study.uncertainty.directions[d], further[d]));
    }
    Gram gram = total(grams, study.uncertainty, sizes);
    // The prior pulls the fitted parameters back: that is a gradient, too.
    const auto free = static_cast<Eigen::Index>(fit.free.size());
    gram.products.topRightCorner(free, 1) -= fit.at(fit.free);
    gram.products.bottomLeftCorner(1, free) = gram.products.topRightCorner(free, 1).transpose();
    return withoutNuisances(gram, fit.free.size());
}

Eigen::MatrixXd productsOver(const Study& study, const Ground& ground, const Fit& fit,
                             const std::array<double, kDisturbances>& sizes) {
    std::vector<Eigen::MatrixXd> knobs;
    for (std::size_t d = 0; d < fit.rows.size(); ++d)
        knobs.push_back(knobsAndResidual(study, ground.about, fit.rows, d));
    return productsBeside(study, fit, knobs, sizes);
}

std::vector<double> gainsOver(const Study& study, const Ground& ground, const Fit& fit) {
    const Eigen::MatrixXd products = productsOver(study, ground, fit, study.uncertainty.sizes);
    std::vector<double> gains;
    for (std::size_t e = 0; e < study.effects.size(); ++e)
        gains.push_back(gain(study, products, e, placesOf(study, e), fit.at));
    return gains;
}

double cosine(const Study& study, const Eigen::MatrixXd& products, std::size_t a, std::size_t b) {
    double largest = 0;
    for (const Eigen::Index i : placesOf(study, a)) {
        for (const Eigen::Index j : placesOf(study, b)) {
            const double size = std::sqrt(products(i, i) * products(j, j));
            if (size > 0) largest = std::max(largest, std::abs(products(i, j)) / size);
        }
    }
    return largest;
}

std::vector<ConfusablePair> confusablePairs(const Study& study, const Screen& screen,
                                            const std::vector<DriveGram>& grams) {
    std::vector<ConfusablePair> pairs;
    for (std::size_t a = 0; a < study.effects.size(); ++a) {
        for (std::size_t b = a + 1; b < study.effects.size(); ++b) {
            const double least = std::min(screen.detectability[a], screen.detectability[b]);
            if (least < kThresholds.shows) continue;
            const double alike = cosine(study, screen.products, a, b), apart = least * (1 - alike * alike);
            if (apart >= kThresholds.separable || alike < kAlike) continue;
            // The recording with the largest part of what the first leaves of the second.
            std::string manoeuvre;
            double most = -1;
            const Eigen::Index i = placesOf(study, a).front(), j = placesOf(study, b).front();
            const double slope = screen.products(i, j) / screen.products(i, i);
            const auto offset = static_cast<Eigen::Index>(study.calibrated.nuisances.size());
            for (std::size_t d = 0; d < grams.size(); ++d) {
                const Gram one = whitened(grams[d], study.uncertainty.sizesOf(d, study.uncertainty.sizes));
                const auto at = [&](Eigen::Index r, Eigen::Index c) { return one.products(offset + r, offset + c); };
                const double energy = at(j, j) - 2 * slope * at(i, j) + slope * slope * at(i, i);
                if (energy > most) most = energy, manoeuvre = study.bench.drives[d].name;
            }
            pairs.push_back({study.effects[a].name, study.effects[b].name, alike, apart, manoeuvre});
        }
    }
    std::sort(pairs.begin(), pairs.end(), [](const auto& x, const auto& y) { return x.separation < y.separation; });
    if (pairs.size() > kMostConfusable) pairs.resize(kMostConfusable);
    return pairs;
}

}  // namespace tread
