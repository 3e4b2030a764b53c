#include "diagnose/study.h"

#include <cmath>
#include <numeric>

namespace tread {
namespace {

constexpr double kSizeSpread = 0.5;  // of the logarithm of a size about that of the usual one
constexpr double kLargestFactor = 3;
constexpr int kSweeps = 6;

}  // namespace

std::vector<DriveGram> everything(const Study& study, const Ground& ground) {
    const std::vector<Eigen::Index> knobs = study.allKnobs();
    std::vector<DriveGram> grams;
    for (std::size_t d = 0; d < ground.grams.size(); ++d) {
        Eigen::MatrixXd further(ground.about.rows[d].size(), static_cast<Eigen::Index>(knobs.size()) + 1);
        further.leftCols(further.cols() - 1) = ground.about.columns[d](Eigen::all, knobs);
        further.leftCols(further.cols() - 1).array().colwise() /= study.uncertainty.noise[d].array();
        further.rightCols(1) = residual(study.bench, study.uncertainty, ground.about.rows, d);
        grams.push_back(extended(ground.grams[d], ground.columns[d], study.uncertainty.directions[d], further));
    }
    return grams;
}

std::array<double, kDisturbances> disturbanceSizes(const std::vector<DriveGram>& grams,
                                                   const Uncertainty& uncertainty) {
    std::array<double, kDisturbances> logs{};
    std::vector<Eigen::Index> free(static_cast<std::size_t>(grams.front().columns.cols() - 1));
    std::iota(free.begin(), free.end(), 0);
    const auto sizes = [](const std::array<double, kDisturbances>& of) {
        std::array<double, kDisturbances> result{};
        for (std::size_t i = 0; i < of.size(); ++i) result[i] = std::exp(of[i]);
        return result;
    };
    const auto merit = [&](const std::array<double, kDisturbances>& of) {
        double prior = 0;
        for (const double one : of) prior += 0.5 * one * one / (kSizeSpread * kSizeSpread);
        const Gram gram = total(grams, uncertainty, sizes(of));
        return logEvidence(gram, gram.products.cols() - 1, free) - prior;
    };
    double best = merit(logs), step = 0.6;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        bool moved = false;
        for (double& one : logs) {
            for (const double by : {step, -step}) {
                const double before = one;
                if (std::abs(before + by) > std::log(kLargestFactor)) continue;
                one = before + by;
                const double now = merit(logs);
                if (now > best) {
                    best = now, moved = true;
                    break;
                }
                one = before;
            }
        }
        if (!moved) step /= 2;
    }
    return sizes(logs);
}

}  // namespace tread
