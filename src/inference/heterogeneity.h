// Does one value fit all drives? Cochran's Q of the values that the drives ask for separately (W. G. Cochran, The
// combination of estimates from different experiments, Biometrics 10, 1954), and the spread between them (J. P. T.
// Higgins, S. G. Thompson, Quantifying heterogeneity in a meta-analysis, Statistics in Medicine 21, 2002).
#pragma once

#include <Eigen/Dense>

namespace tread::inference {

struct Heterogeneity {
    double q = 0;
    double degrees_of_freedom = 0;
    double p = 1;  // probability that chance alone gives such a Q or a larger one
    // Root of Q per degree of freedom times the relative standard error of the common value; chance is not subtracted.
    double spread = 0;
};

// `information` and `gradient` are those of one value per drive about a common value with the square `squared_value`;
// the nuisance parameters are marginalised. Drives with less than `least_share` of the information are ignored (D37),
// (D38).
Heterogeneity heterogeneity(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient, double squared_value,
                            double least_share);

// Logarithm of the Bayes factor of a value that varies between drives by the share `wide` of itself, over one that
// varies by the share `narrow`. Assumes that all drives determine the value equally well (D39).
double logBayesFactorOfSpread(const Heterogeneity& found, double wide, double narrow);

}  // namespace tread::inference
