#include "diagnose/model/remainder.h"

#include <algorithm>
#include <cmath>

#include "base/threads/parallel.h"
#include "inference/laplace.h"

namespace tread::diagnose::model {
namespace {

constexpr double kLeastSize = 0.03;  // usual sizes; a kind this small does not act

constexpr int kMostSteps = 12;
constexpr double kSettled = 0.1;  // change of the logarithm of a size

// In one drive. `root`: of the information about the parameters from all drives.
Left leftIn(const Uncertainty& uncertainty, std::size_t drive, const inference::DisturbedProducts& here,
            const Eigen::MatrixXd& root) {
    Left left;
    const Eigen::VectorXd squares = here.estimates.rightCols(1).cwiseAbs2();
    // Freedom that the parameters take from the impulses.
    const Eigen::MatrixXd taken =
        inference::solvedBy(root, here.estimates.leftCols(here.estimates.cols() - 1).transpose());
    const std::vector<Disturbed>& kinds = uncertainty.disturbing[drive].kinds;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        left.squares[placeOf(kinds[i])] += squares(at);
        left.determined[placeOf(kinds[i])] += 1 - here.variances(at) - taken.col(at).squaredNorm();
    }
    return left;
}

Left leftBy(const Uncertainty& uncertainty, const std::vector<inference::DisturbedProducts>& each, int threads) {
    const std::size_t drives = each.size();
    const Eigen::Index free = each.front().products.cols() - 1;
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(free, free);
    for (const inference::DisturbedProducts& one : each) information += one.products.topLeftCorner(free, free);
    const Eigen::MatrixXd root = inference::factorOfPriorAnd(information).lower();
    std::vector<Left> lefts(drives);
    inParallel(drives, threads, [&](std::size_t d) { lefts[d] = leftIn(uncertainty, d, each[d], root); });
    Left all;
    for (std::size_t k = 0; k < kDisturbances; ++k)
        for (const Left& left : lefts)
            all.squares[k] += left.squares[k], all.determined[k] += std::max(0.0, left.determined[k]);
    return all;
}

}  // namespace

double logPrior(const Sizes& sizes, const SizesPrior& prior) {
    double sum = 0;
    for (const Disturbed kind : kAllDisturbed) {
        const double log_size = std::log(sizes[placeOf(kind)]);
        sum -= 0.5 * log_size * prior.pull(kind, log_size);
    }
    return sum;
}

Left leftBy(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products, const Sizes& sizes,
            int threads) {
    std::vector<inference::DisturbedProducts> each(products.size());
    inParallel(each.size(), threads, [&](std::size_t d) {
        each[d] = inference::disturbedProducts(products[d], uncertainty.sizesOf(d, sizes));
    });
    return leftBy(uncertainty, each, threads);
}

Left leftBy(const Uncertainty& uncertainty, const std::vector<inference::MarginalProducts>& marginal, int threads) {
    std::vector<inference::DisturbedProducts> each(marginal.size());
    inParallel(each.size(), threads, [&](std::size_t d) { each[d] = marginal[d].disturbed(); });
    return leftBy(uncertainty, each, threads);
}

Sizes improvedSizes(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products, const Sizes& sizes,
                    int threads, const SizesPrior& prior) {
    return improvedSizes(sizes, leftBy(uncertainty, products, sizes, threads), prior);
}

Sizes improvedSizes(const Sizes& sizes, const Left& left, const SizesPrior& prior) {
    Sizes better = sizes;
    for (const Disturbed kind : kAllDisturbed) {
        const std::size_t k = placeOf(kind);
        const double log_size = std::log(sizes[k]), off = prior.pull(kind, log_size);
        const double curvature = left.information(k) + (log_size == 0 ? 0 : off / log_size);
        if (curvature < 1e-9) continue;
        better[k] *= std::exp((left.squares[k] - left.determined[k] - off) / curvature);
        better[k] = std::max(better[k], kLeastSize);
    }
    return better;
}

Sizes sizesAt(Drives drives, const Uncertainty& uncertainty, const Rows& rows, int threads) {
    std::vector<DriveProducts> products;
    for (std::size_t d = 0; d < rows.size(); ++d)
        products.push_back(productsOf(uncertainty, d, residual(drives, uncertainty, rows, d)));
    Sizes sizes = uncertainty.sizes;
    for (int i = 0; i < kMostSteps; ++i) {
        const Sizes last = sizes;
        sizes = improvedSizes(uncertainty, products, last, threads);
        if (changeOf(last, sizes) < kSettled) break;
    }
    return sizes;
}

double changeOf(const Sizes& from, const Sizes& to) {
    double largest = 0;
    for (std::size_t k = 0; k < kDisturbances; ++k) largest = std::max(largest, std::abs(std::log(to[k] / from[k])));
    return largest;
}

}  // namespace tread::diagnose::model
