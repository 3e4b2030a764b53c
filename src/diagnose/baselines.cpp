#include "diagnose/baselines.h"

#include <algorithm>
#include <cmath>

#include "diagnose/screen.h"

namespace tread {
namespace {

// Each effect's part of the products of all knobs and the residual; `at`: where the columns are taken.
std::vector<LinearEffect> effectsOf(const Study& study, const Eigen::MatrixXd& products, const Deviation& at) {
    std::vector<LinearEffect> effects;
    const Eigen::Index last = products.cols() - 1;
    for (std::size_t e = 0; e < study.effects.size(); ++e) {
        std::vector<Eigen::Index> places = placesOf(study, e);
        LinearEffect one{study.effects[e].name, {}, {}, {}};
        one.lowest.resize(static_cast<Eigen::Index>(places.size()));
        one.highest.resize(one.lowest.size());
        for (Eigen::Index i = 0; i < one.lowest.size(); ++i) {
            const Eigen::Index p = study.knobs[e][static_cast<std::size_t>(i)];
            const Parameter& parameter = study.bench.parameters[static_cast<std::size_t>(p)];
            one.lowest(i) = parameter.lowest - at(p);
            one.highest(i) = parameter.highest - at(p);
        }
        places.push_back(last);
        one.products = products(places, places);
        effects.push_back(std::move(one));
    }
    return effects;
}

// Products of the knobs' columns and the nominal car's residual, row by row.
Eigen::MatrixXd plainProducts(const Study& study) {
    const auto all = static_cast<Eigen::Index>(study.allKnobs().size()) + 1;
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(all, all);
    for (std::size_t d = 0; d < study.nominal.size(); ++d) {
        const Eigen::MatrixXd columns = knobsAndResidual(study, study.calibrated.about, study.nominal, d);
        products += columns.transpose() * columns;
    }
    return products;
}

}  // namespace

double reduction(const LinearEffect& effect) {
    const Eigen::Index n = effect.lowest.size();
    const Eigen::MatrixXd information = effect.products.topLeftCorner(n, n);
    const Eigen::VectorXd gradient = effect.products.topRightCorner(n, 1);
    if (!(information.diagonal().maxCoeff() > 0)) return 0;
    Eigen::VectorXd best = information.completeOrthogonalDecomposition().solve(gradient);
    best = best.cwiseMax(effect.lowest).cwiseMin(effect.highest);
    return 2 * gradient.dot(best) - best.dot(information * best);
}

std::string largestReduction(const std::vector<LinearEffect>& effects) {
    std::string best = "none";
    double most = 0;
    for (const LinearEffect& effect : effects) {
        const double gained = reduction(effect);
        if (gained <= most || gained <= static_cast<double>(effect.lowest.size())) continue;
        most = gained;
        best = effect.name;
    }
    return best;
}

std::string leastBic(const std::vector<LinearEffect>& effects, double rows) {
    std::string best = "none";
    double least = 0;  // that of no effect, from which all are counted
    for (const LinearEffect& effect : effects) {
        const double bic = static_cast<double>(effect.lowest.size()) * std::log(rows) - reduction(effect);
        if (bic >= least) continue;
        least = bic;
        best = effect.name;
    }
    return best;
}

Baselines baselines(const Study& study) {
    double rows = 0;
    for (const Eigen::VectorXd& of_drive : study.nominal) rows += static_cast<double>(of_drive.size());
    const Eigen::MatrixXd free = productsOver(study, study.calibrated, study.calibration, {});
    return {.largest_reduction =
                largestReduction(effectsOf(study, plainProducts(study), Deviation::Zero(study.calibration.at.size()))),
            .bic = leastBic(effectsOf(study, free, study.calibration.at), rows)};
}

}  // namespace tread
