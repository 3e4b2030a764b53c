// How much of the variance of a metric each factor accounts for.
//
// With the design of sampling: sobol_indices, the indices of Sobol: first order after Saltelli et al. (Computer Physics
// Communications 181, 2010), total after Jansen (Computer Physics Communications 117, 1999). Otherwise the main effect:
// the variance of the mean of the metric over classes of the factor, less what classes of that size show by chance
// (epsilon squared of Kelley, 1935). Both are shares of the variance, with a 95 % confidence interval from a bootstrap
// with a fixed seed.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tread::campaign {

struct Share {
    double value = 0;  // NaN: cannot be estimated
    double low = 0, high = 0;
};

struct SobolIndices {
    Share first;
    Share total;
};

// `values`: in blocks of A, B and A with each of the columns of B in turn. Blocks with a value that is not a number are
// left out.
std::vector<SobolIndices> sobolIndices(std::span<const double> values, std::size_t factors);

// What becomes a class of a factor: each of its listed values; or neighbours among values that were drawn, at least
// five in each class, so that factors drawn together are told apart.
enum class Values { listed, drawn };

// Main effect of a factor, from at most twenty classes.
Share mainEffect(std::span<const double> factor, std::span<const double> metric, Values values);

// Mean of the metric in each of these classes over the mean of the factor there, for a chart.
struct ClassMeans {
    std::vector<double> factor, metric;
};
ClassMeans classMeans(std::span<const double> factor, std::span<const double> metric, Values values);

}  // namespace tread::campaign
