// Sizes of the remainder: of the disturbances, and of the errors of the model's forces. They are estimated from what a
// model leaves, together with its parameters, so that the evidence of a model counts on its own remainder.
#pragma once

#include <cmath>

#include "diagnose/model/uncertainty.h"
#include "diagnose/settings.h"

namespace tread::diagnose::model {

// Prior of sizes: their logarithms are normal about those of the usual sizes (D26), or only those above are limited.
struct SizesPrior {
    double spread = 1;  // standard deviation of the logarithm
    bool above_only = false;

    // Of a kind: instruments are better known than roads, wind and forces.
    double spreadOf(Disturbed kind) const { return isInstruments(kind) ? kSettings.reading_spread * spread : spread; }
    // Standard deviations by which the size of a kind exceeds the usual one.
    double deviations(Disturbed kind, double size) const { return std::log(size) / spreadOf(kind); }
    double pull(double log_size) const { return pull(log_size, spread); }
    double pull(Disturbed kind, double log_size) const { return pull(log_size, spreadOf(kind)); }

private:
    double pull(double log_size, double within) const {
        return above_only && log_size < 0 ? 0 : log_size / (within * within);
    }
};
inline constexpr SizesPrior kWidePrior{kSettings.size_spread, false};
inline constexpr SizesPrior kLargePrior{kSettings.size_spread, true}, kOrdinaryPrior{kSettings.ordinary_spread, true};

// Logarithm of the prior density of sizes.
double logPrior(const Sizes& sizes, const SizesPrior& prior);

// What a model leaves, by kind: squared impulses, and the number of them that the data determine. Their difference is
// the gradient of the evidence in the logarithm of a size, their sum the information about it.
struct Left {
    Sizes squares{}, determined{};

    double information(std::size_t kind) const { return squares[kind] + determined[kind]; }
};
// `products`: per drive, of the columns of the free parameters, then the residual. The parameters are marginalised.
Left leftBy(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products, const Sizes& sizes,
            int threads);
// The same of products that are marginalised already.
Left leftBy(const Uncertainty& uncertainty, const std::vector<inference::MarginalProducts>& marginal, int threads);

// Sizes closer to the maximum of the evidence of a model at its best point. One step towards the fixed point of MacKay
// (1992) for variances (D26a).
Sizes improvedSizes(const Uncertainty& uncertainty, const std::vector<DriveProducts>& products, const Sizes& sizes,
                    int threads, const SizesPrior& prior = kWidePrior);
Sizes improvedSizes(const Sizes& sizes, const Left& left, const SizesPrior& prior = kWidePrior);

// Sizes of what a model leaves at a fixed point. A fit that starts far from the car begins with them, so that it is not
// forced onto what it cannot explain.
Sizes sizesAt(Drives drives, const Uncertainty& uncertainty, const Rows& rows, int threads);

// Largest change of the logarithm of a size.
double changeOf(const Sizes& from, const Sizes& to);

}  // namespace tread::diagnose::model
