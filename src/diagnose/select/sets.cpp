#include "diagnose/select/sets.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/threads/parallel.h"
#include "diagnose/select/posterior.h"
#include "diagnose/select/screen.h"
#include "inference/bounded_step.h"

namespace tread::diagnose::select {
namespace {

constexpr std::size_t kExtended = 20;       // best pairs to which a third effect is added
constexpr std::size_t kMostPromising = 40;  // sets returned

using Effects = std::vector<std::size_t>;

// The fit as one of a model without its effects, which stays at the point of the fit.
Fit withoutKnobs(Fit fit) {
    std::vector<Eigen::Index> kept(fit.nuisances() + 1);
    std::iota(kept.begin(), kept.end(), 0);
    kept.back() = std::ssize(fit.free);  // the residual
    fit.free.resize(fit.nuisances());
    for (std::size_t d = 0; d < fit.columns.size(); ++d) {
        fit.columns[d].conservativeResize(Eigen::NoChange, std::ssize(fit.free));
        fit.products[d] = inference::selected(fit.products[d], kept, Eigen::VectorXd::Ones(std::ssize(kept)));
    }
    fit.knobs.clear();
    return fit;
}

// Quadratic model of the log posterior in the knobs of all effects about a fit, with its nuisances marginalised.
class ModelOfAllKnobs {
public:
    ModelOfAllKnobs(const Calibration& car, const Linearisation& here, const Fit& fit)
        : problem_(car.problem), bounds_(model::boundsOf(problem_.replays.parameters, problem_.allKnobs())) {
        const std::vector<Eigen::Index> knobs = problem_.allKnobs();
        std::vector<Eigen::MatrixXd> further;
        for (std::size_t d = 0; d < fit.rows.size(); ++d) {
            further.push_back(model::columnsAndResidual(car.drives(), car.uncertainty, here.about, knobs, fit.rows, d));
            for (Eigen::Index i = 0; i < std::ssize(fit.knobs); ++i) {
                const auto place = std::find(knobs.begin(), knobs.end(), fit.knobs[i]) - knobs.begin();
                further[d].col(place) = fit.columns[d].col(fit.nuisances() + i);
            }
        }
        const Fit others = withUsualImperfections(withoutKnobs(fit), problem_.replays);
        const Eigen::MatrixXd products = productsBeside(car, others, further, car.uncertainty.sizes);
        const Eigen::Index n = std::ssize(knobs);
        all_ = {.information = products.topLeftCorner(n, n), .gradient = products.col(n).head(n), .at = fit.at(knobs)};
        for (std::size_t e = 0; e < problem_.effects.size(); ++e) places_.push_back(placesOf(problem_, e));
    }

    // Evidence and prior of a set, up to a constant.
    double operator()(const Effects& effects) const {
        std::vector<Eigen::Index> in;
        for (const std::size_t e : effects) in.insert(in.end(), places_[e].begin(), places_[e].end());
        // Effects of the fit that are not in the set leave what they explained.
        Eigen::VectorXd out = all_.at;
        for (const Eigen::Index place : in) out(place) = 0;
        const Eigen::VectorXd back = all_.information * out;
        const inference::QuadraticModel knobs{.information = all_.information(in, in),
                                              .gradient = (all_.gradient + back)(in),
                                              .at = all_.at(in),
                                              .squared_residual = out.dot(2 * all_.gradient + back)};
        const inference::Bounds bounds{bounds_.lowest(in) - knobs.at, bounds_.highest(in) - knobs.at};
        return inference::logEvidence(knobs, inference::boundedStep(knobs, 0, bounds)) +
               logPrior(problem_, effects.size());
    }

private:
    const Problem& problem_;
    inference::Bounds bounds_;
    inference::QuadraticModel all_;
    std::vector<std::vector<Eigen::Index>> places_;  // of the knobs of each effect
};

// Evaluates sets and returns the best of them, best first.
std::vector<PromisingSet> best(const ModelOfAllKnobs& model, const std::set<Effects>& sets, int threads) {
    std::vector<PromisingSet> all;
    for (const Effects& effects : sets) all.push_back({effects});
    inParallel(all.size(), threads, [&](std::size_t i) { all[i].promised = model(all[i].effects); });
    std::stable_sort(all.begin(), all.end(),
                     [](const PromisingSet& a, const PromisingSet& b) { return a.promised > b.promised; });
    all.resize(std::min(all.size(), kMostPromising));
    return all;
}

// Each set with each further effect.
std::set<Effects> extended(const std::vector<PromisingSet>& sets, const Effects& some) {
    std::set<Effects> larger;
    for (const PromisingSet& set : sets) {
        for (const std::size_t further : some) {
            Effects effects = set.effects;
            effects.insert(std::upper_bound(effects.begin(), effects.end(), further), further);
            if (std::adjacent_find(effects.begin(), effects.end()) == effects.end()) larger.insert(std::move(effects));
        }
    }
    return larger;
}

}  // namespace

std::vector<PromisingSet> promisingSets(const Calibration& car, const Linearisation& here, const Candidate& about,
                                        const Effects& some) {
    const ModelOfAllKnobs model(car, here, about.fit);
    const int threads = car.problem.replays.threads;
    std::vector<PromisingSet> singles;
    for (const std::size_t effect : some) singles.push_back({{effect}});
    std::vector<PromisingSet> pairs = best(model, extended(singles, some), threads);
    std::set<Effects> sets;
    for (const PromisingSet& one : singles) sets.insert(one.effects);
    for (const PromisingSet& one : pairs) sets.insert(one.effects);
    pairs.resize(std::min(pairs.size(), kExtended));
    sets.merge(extended(pairs, some));
    std::vector<PromisingSet> all = best(model, sets, threads);
    const double now = model(about.effects);
    for (PromisingSet& one : all) one.promised -= now;
    return all;
}

}  // namespace tread::diagnose::select
