#include "inference/chi_squared.h"

#include <cmath>

namespace tread::inference {
namespace {

constexpr int kMostTerms = 500;
constexpr double kSmall = 1e-15;  // relative size of a term or correction that ends the sum
constexpr double kTiny = 1e-300;  // replaces a denominator of zero

// P(a, z), lower, without its factor in front.
double series(double a, double z) {
    double term = 1 / a, sum = term;
    for (int n = 1; n < kMostTerms && std::abs(term) > kSmall * std::abs(sum); ++n) sum += term *= z / (a + n);
    return sum;
}

// Q(a, z), upper, without its factor in front.
double continuedFraction(double a, double z) {
    double b = z + 1 - a, c = 1 / kTiny, d = 1 / b, h = d;
    for (int n = 1; n < kMostTerms; ++n) {
        const double an = -n * (n - a);
        b += 2;
        d = an * d + b, c = b + an / c;
        d = 1 / (std::abs(d) < kTiny ? kTiny : d);
        if (std::abs(c) < kTiny) c = kTiny;
        h *= d * c;
        if (std::abs(d * c - 1) < kSmall) break;
    }
    return h;
}

}  // namespace

double chiSquaredTail(double x, double degrees_of_freedom) {
    const double a = 0.5 * degrees_of_freedom, z = 0.5 * x;
    if (z <= 0) return 1;
    const double front = std::exp(-z + a * std::log(z) - std::lgamma(a));
    return z < a + 1 ? 1 - front * series(a, z) : front * continuedFraction(a, z);
}

}  // namespace tread::inference
