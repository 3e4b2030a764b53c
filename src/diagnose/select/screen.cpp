#include "diagnose/select/screen.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads/parallel.h"
#include "diagnose/settings.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {
namespace {

// Least cosine of a pair that is named. Below it a pair is hard to tell apart only because one effect hardly shows.
constexpr double kAlike = 0.5;
constexpr std::size_t kMostConfusable = 30;  // pairs listed

// Evidence that an effect gains in the linear model with these products, its knobs within their bounds (D25).
double gain(const Problem& problem, const Eigen::MatrixXd& products, std::size_t effect, const Deviation& at) {
    const std::vector<Eigen::Index> places = placesOf(problem, effect);
    const Eigen::Index n = std::ssize(places), last = products.cols() - 1;
    const inference::QuadraticModel knobs{
        .information = products(places, places), .gradient = products(places, last), .at = Eigen::VectorXd::Zero(n)};
    const inference::Bounds bounds = model::boundsAbout(at, problem.replays.parameters, problem.knobs[effect]);
    return inference::logEvidence(knobs, inference::boundedStep(knobs, 0, bounds));
}

// The point with the knobs of an effect at their typical size; nothing unless at least one knob is bounded at its
// nominal value.
std::optional<Deviation> withOneSided(const Problem& problem, std::size_t effect, Deviation at) {
    bool one_sided = false;
    for (const Eigen::Index k : problem.knobs[effect]) {
        const Parameter& knob = problem.replays.parameters[k];
        one_sided = one_sided || knob.lowest == 0 || knob.highest == 0;
        at(k) = std::clamp(knob.highest > 0 ? 1.0 : -1.0, knob.lowest, knob.highest);
    }
    if (!one_sided) return std::nullopt;
    return at;
}

bool isFree(const Fit& fit, const std::vector<Eigen::Index>& knobs) {
    return std::find_first_of(fit.knobs.begin(), fit.knobs.end(), knobs.begin(), knobs.end()) != fit.knobs.end();
}

// Knobs of two effects whose signatures are most alike.
struct Alike {
    double cosine = 0;
    Eigen::Index one = 0, other = 0;  // places in the products
};

Alike mostAlike(const Problem& problem, const Eigen::MatrixXd& products, std::size_t a, std::size_t b) {
    Alike most;
    for (const Eigen::Index i : placesOf(problem, a)) {
        for (const Eigen::Index j : placesOf(problem, b)) {
            const double size = std::sqrt(products(i, i) * products(j, j));
            if (size > 0 && std::abs(products(i, j)) > most.cosine * size)
                most = {std::abs(products(i, j)) / size, i, j};
        }
    }
    return most;
}

// The recording with the largest part of the second effect's signature that the first cannot imitate. `equations`: of
// each drive.
std::string mostTelling(const Calibration& car, const Screen& screen,
                        const std::vector<model::NormalEquations>& equations, std::size_t a, std::size_t b) {
    const auto [alike, i, j] = mostAlike(car.problem, screen.products, a, b);
    const double slope = screen.products(i, j) / screen.products(i, i);
    const Eigen::Index offset = std::ssize(car.about.nuisances);
    std::string recording;
    double most = -1;
    for (std::size_t d = 0; d < equations.size(); ++d) {
        const auto at = [&](Eigen::Index r, Eigen::Index c) { return equations[d].products(offset + r, offset + c); };
        const double energy = at(j, j) - 2 * slope * at(i, j) + slope * slope * at(i, i);
        if (energy > most) most = energy, recording = car.drives()[d].name;
    }
    return recording;
}

}  // namespace

std::vector<Eigen::Index> placesOf(const Problem& problem, std::size_t effect) {
    Eigen::Index first = 0;
    for (std::size_t e = 0; e < effect; ++e) first += std::ssize(problem.knobs[e]);
    std::vector<Eigen::Index> places(problem.knobs[effect].size());
    std::iota(places.begin(), places.end(), first);
    return places;
}

Screen screen(const Calibration& car) {
    Screen result;
    const model::NormalEquations sum =
        model::normalEquations(car.uncertainty, car.products, car.uncertainty.sizes, car.problem.replays.threads);
    result.products = inference::withoutFirst(sum, std::ssize(car.about.nuisances)).products;
    for (std::size_t e = 0; e < car.problem.effects.size(); ++e) {
        double most = 0;
        for (const Eigen::Index i : placesOf(car.problem, e)) most = std::max(most, 0.5 * result.products(i, i));
        result.expected_evidence.push_back(most);
    }
    result.gain =
        gainsOver(car, car.about, withUsualImperfections(car.fit, car.problem.replays), car.uncertainty.sizes);
    result.least_gain = gainsOver(car, car.about, car.fit, car.fit.sizes);
    return result;
}

std::vector<double> expectedEvidenceAt(const Calibration& car, const Fit& found, const Screen& screen) {
    const Problem& problem = car.problem;
    std::vector<double> expected = screen.expected_evidence;
    std::vector<std::size_t> effects;
    std::vector<Deviation> points;
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        if (expected[e] < kSettings.clear || isFree(found, problem.knobs[e])) continue;
        if (std::optional<Deviation> with = withOneSided(problem, e, found.at))
            effects.push_back(e), points.push_back(std::move(*with));
    }
    if (effects.empty()) return expected;
    const std::vector<std::optional<Rows>> rows = model::rowsAt(problem.replays, problem.drives, points);
    std::vector<Eigen::MatrixXd> further(found.rows.size());
    for (std::size_t d = 0; d < further.size(); ++d) {
        Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(found.rows[d].size(), std::ssize(effects) + 1);
        for (std::size_t i = 0; i < effects.size(); ++i)
            if (rows[i]) changes.col(static_cast<Eigen::Index>(i)) = (*rows[i])[d] - found.rows[d];
        further[d] = car.uncertainty.noise[d].over(changes);
        further[d].rightCols(1) = model::residual(problem.drives, car.uncertainty, found.rows, d);
    }
    const Eigen::MatrixXd products = productsBeside(car, found, further, car.uncertainty.sizes);
    for (std::size_t i = 0; i < effects.size(); ++i) {
        const auto place = static_cast<Eigen::Index>(i);
        if (rows[i]) expected[effects[i]] = std::min(expected[effects[i]], 0.5 * products(place, place));
    }
    return expected;
}

Eigen::MatrixXd productsBeside(const Calibration& car, const Fit& fit, const std::vector<Eigen::MatrixXd>& further,
                               const Sizes& sizes) {
    std::vector<DriveProducts> products(fit.rows.size());
    inParallel(products.size(), car.problem.replays.threads,
               [&](std::size_t d) { products[d] = productsBeside(fit, car.uncertainty, d, further[d]); });
    model::NormalEquations sum = model::normalEquations(car.uncertainty, products, sizes, car.problem.replays.threads);
    // The prior pulls the fitted parameters back to their nominal values and is part of the gradient.
    const Eigen::Index free = std::ssize(fit.free);
    sum.products.topRightCorner(free, 1) -= fit.at(fit.free);
    sum.products.bottomLeftCorner(1, free) = sum.products.topRightCorner(free, 1).transpose();
    return inference::withoutFirst(sum, free).products;
}

Eigen::MatrixXd productsOfKnobs(const Calibration& car, const Linearisation& about, const Fit& fit,
                                const Sizes& sizes) {
    const std::vector<Eigen::Index> knobs = car.problem.allKnobs();
    std::vector<Eigen::MatrixXd> columns;
    for (std::size_t d = 0; d < fit.rows.size(); ++d)
        columns.push_back(model::columnsAndResidual(car.drives(), car.uncertainty, about.about, knobs, fit.rows, d));
    return productsBeside(car, fit, columns, sizes);
}

std::vector<double> gainsOver(const Calibration& car, const Linearisation& about, const Fit& fit, const Sizes& sizes) {
    const Eigen::MatrixXd products = productsOfKnobs(car, about, fit, sizes);
    std::vector<double> gains;
    for (std::size_t e = 0; e < car.problem.effects.size(); ++e)
        gains.push_back(gain(car.problem, products, e, fit.at));
    return gains;
}

double cosine(const Problem& problem, const Eigen::MatrixXd& products, std::size_t a, std::size_t b) {
    return mostAlike(problem, products, a, b).cosine;
}

std::vector<answer::ConfusablePair> confusablePairs(const Calibration& car, const Screen& screen,
                                                    const std::vector<double>& expected_evidence) {
    const Problem& problem = car.problem;
    const std::vector<model::NormalEquations> equations =
        model::equationsOfEach(car.uncertainty, car.products, car.uncertainty.sizes, problem.replays.threads);
    std::vector<answer::ConfusablePair> pairs;
    for (std::size_t a = 0; a < problem.effects.size(); ++a) {
        for (std::size_t b = a + 1; b < problem.effects.size(); ++b) {
            const double least = std::min(expected_evidence[a], expected_evidence[b]);
            if (least < kSettings.clear) continue;
            const double alike = cosine(problem, screen.products, a, b), apart = least * (1 - alike * alike);
            if (apart >= kSettings.clear || alike < kAlike) continue;
            pairs.push_back({problem.effects[a].name, problem.effects[b].name, alike, apart,
                             mostTelling(car, screen, equations, a, b)});
        }
    }
    std::sort(pairs.begin(), pairs.end(), [](const auto& x, const auto& y) { return x.separation < y.separation; });
    if (pairs.size() > kMostConfusable) pairs.resize(kMostConfusable);
    return pairs;
}

}  // namespace tread::diagnose::select
