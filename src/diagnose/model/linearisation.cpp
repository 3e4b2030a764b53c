#include "diagnose/model/linearisation.h"

#include "base/threads/parallel.h"

namespace tread::diagnose::model {
namespace {

// Squared signal-to-noise ratio of a nuisance at one prior standard deviation, above which its column is computed again
// in a drive. Raising this saves replays; more columns stay those of the former point.
constexpr double kWorthDriving = 0.1;
// Half the Fisher information, nats, below which a nuisance is left out. Raising this leaves out nuisances that imitate
// part of an effect.
constexpr double kNegligible = 0.01;

// For each nuisance, the drives in which it matters enough to compute its column again.
std::vector<std::vector<bool>> worthDriving(const Linearisation& about, const Uncertainty& uncertainty, int threads) {
    const std::size_t drives = about.products.size();
    const Eigen::Index nuisances = std::ssize(about.nuisances);
    Eigen::MatrixXd squares(nuisances, std::ssize(about.products));
    inParallel(drives, threads, [&](std::size_t d) {
        squares.col(static_cast<Eigen::Index>(d)) =
            normalEquations(uncertainty, d, inference::firstColumns(about.products[d], nuisances), uncertainty.sizes)
                .products.diagonal();
    });
    std::vector<std::vector<bool>> worth(about.nuisances.size(), std::vector<bool>(drives));
    for (std::size_t d = 0; d < drives; ++d)
        for (std::size_t i = 0; i < worth.size(); ++i)
            worth[i][d] = squares(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(d)) > kWorthDriving;
    return worth;
}

}  // namespace

Linearisation linearisation(Sensitivities about, const std::vector<Eigen::Index>& nuisances,
                            const std::vector<Eigen::Index>& knobs, const Uncertainty& uncertainty, int threads) {
    const std::size_t drives = uncertainty.noise.size();
    Linearisation result{std::move(about), nuisances, joined(nuisances, knobs), {}, {}};
    result.columns.resize(drives), result.products.resize(drives);
    inParallel(drives, threads, [&](std::size_t d) {
        result.columns[d] = uncertainty.noise[d].over(result.about.columns[d](Eigen::all, result.parameters));
        result.products[d] = productsOf(uncertainty, d, result.columns[d]);
    });
    return result;
}

Linearisation relinearised(const Linearisation& before, Sensitivities about, const Uncertainty& uncertainty,
                           int threads) {
    const std::size_t drives = uncertainty.noise.size();
    Linearisation result{std::move(about), before.nuisances, before.parameters, {}, {}, before.imperfections};
    result.columns.resize(drives), result.products.resize(drives);
    const Eigen::Index nuisances = std::ssize(before.nuisances), knobs = std::ssize(before.parameters) - nuisances;
    inParallel(drives, threads, [&](std::size_t d) {
        Eigen::MatrixXd& columns = result.columns[d] = before.columns[d];
        columns.leftCols(nuisances) = uncertainty.noise[d].over(result.about.columns[d](Eigen::all, before.nuisances));
        result.products[d] =
            inference::extendedInFront(columns.leftCols(nuisances), inference::lastColumns(before.products[d], knobs),
                                       columns.rightCols(knobs), uncertainty.directions[d]);
    });
    return result;
}

std::vector<Eigen::Index> relevantNuisances(const std::vector<Eigen::Index>& nuisances, const Sensitivities& about,
                                            const Uncertainty& uncertainty, int threads) {
    const Linearisation all = linearisation(about, nuisances, {}, uncertainty, threads);
    const NormalEquations sum = normalEquations(uncertainty, all.products, uncertainty.sizes, threads);
    std::vector<Eigen::Index> kept;
    for (std::size_t i = 0; i < nuisances.size(); ++i)
        if (0.5 * sum.products(i, i) > kNegligible) kept.push_back(nuisances[i]);
    return kept;
}

Sensitivities nuisancesAt(const Replays& replays, Drives drives, const Deviation& at, const Rows* rows,
                          const Linearisation& before, const Uncertainty& uncertainty,
                          const std::function<void(double)>& progress) {
    return sensitivities(replays, drives, at,
                         {.parameters = before.nuisances,
                          .worth = worthDriving(before, uncertainty, replays.threads),
                          .elsewhere = &before.about,
                          .rows = rows},
                         progress);
}

Eigen::MatrixXd columnsAndResidual(Drives drives, const Uncertainty& uncertainty, const Sensitivities& about,
                                   const std::vector<Eigen::Index>& parameters, const Rows& rows, std::size_t drive) {
    const Eigen::Index n = std::ssize(parameters);
    Eigen::MatrixXd all(rows[drive].size(), n + 1);
    all.leftCols(n) = uncertainty.noise[drive].over(about.columns[drive](Eigen::all, parameters));
    all.rightCols(1) = residual(drives, uncertainty, rows, drive);
    return all;
}

std::vector<DriveProducts> productsWithResidual(Drives drives, const Linearisation& linearisation,
                                                const Uncertainty& uncertainty) {
    std::vector<DriveProducts> products;
    for (std::size_t d = 0; d < drives.size(); ++d)
        products.push_back(inference::extended(linearisation.products[d], linearisation.columns[d],
                                               uncertainty.directions[d],
                                               residual(drives, uncertainty, linearisation.about.rows, d)));
    return products;
}

}  // namespace tread::diagnose::model
