#include "diagnose/select/baselines.h"

#include <algorithm>
#include <cmath>

#include "diagnose/select/screen.h"

namespace tread::diagnose::select {
namespace {

// The part of each effect in the products of all knobs and the residual. `at`: point of the linearisation.
std::vector<LinearEffect> effectsOf(const Problem& problem, const Eigen::MatrixXd& products, const Deviation& at) {
    std::vector<LinearEffect> effects;
    const Eigen::Index last = products.cols() - 1;
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        std::vector<Eigen::Index> places = placesOf(problem, e);
        LinearEffect one{
            problem.effects[e].name, {}, model::boundsAbout(at, problem.replays.parameters, problem.knobs[e])};
        places.push_back(last);
        one.products = products(places, places);
        effects.push_back(std::move(one));
    }
    return effects;
}

// Products of the knobs' columns and the nominal car's residual, with nothing marginalised.
Eigen::MatrixXd plainProducts(const Calibration& car) {
    const std::vector<Eigen::Index> knobs = car.problem.allKnobs();
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(std::ssize(knobs) + 1, std::ssize(knobs) + 1);
    for (std::size_t d = 0; d < car.nominal.size(); ++d) {
        const Eigen::MatrixXd columns =
            model::columnsAndResidual(car.drives(), car.uncertainty, car.about.about, knobs, car.nominal, d);
        products += inference::squareOf(columns);
    }
    return products;
}

}  // namespace

double reduction(const LinearEffect& effect) {
    const Eigen::Index n = effect.bounds.lowest.size();
    const Eigen::MatrixXd information = effect.products.topLeftCorner(n, n);
    const Eigen::VectorXd gradient = effect.products.topRightCorner(n, 1);
    if (!(information.diagonal().maxCoeff() > 0)) return 0;
    Eigen::VectorXd best = information.completeOrthogonalDecomposition().solve(gradient);
    best = best.cwiseMax(effect.bounds.lowest).cwiseMin(effect.bounds.highest);
    return 2 * gradient.dot(best) - best.dot(information * best);
}

std::string largestReduction(const std::vector<LinearEffect>& effects) {
    std::string best = "none";
    double most = 0;
    for (const LinearEffect& effect : effects) {
        const double gained = reduction(effect);
        if (gained <= most || gained <= static_cast<double>(effect.bounds.lowest.size())) continue;
        most = gained;
        best = effect.name;
    }
    return best;
}

std::string leastBic(const std::vector<LinearEffect>& effects, double rows) {
    std::string best = "none";
    double least = 0;  // criterion relative to that of no effect
    for (const LinearEffect& effect : effects) {
        const double bic = static_cast<double>(effect.bounds.lowest.size()) * std::log(rows) - reduction(effect);
        if (bic >= least) continue;
        least = bic;
        best = effect.name;
    }
    return best;
}

answer::Baselines baselines(const Calibration& car) {
    double rows = 0;
    for (const Eigen::VectorXd& of_drive : car.nominal) rows += static_cast<double>(of_drive.size());
    const Deviation origin = car.problem.replays.origin();
    const Eigen::MatrixXd free = productsOfKnobs(car, car.about, car.fit, {});
    return {.largest_reduction = largestReduction(effectsOf(car.problem, plainProducts(car), origin)),
            .bic = leastBic(effectsOf(car.problem, free, car.fit.at), rows)};
}

}  // namespace tread::diagnose::select
