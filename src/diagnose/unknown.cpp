#include "diagnose/unknown.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnose/thresholds.h"

namespace tread {
namespace {

constexpr std::array<double, 6> kAllLarger{1.6, 2.5, 4, 8, 16, 50};
constexpr std::array<double, 3> kOneLarger{4, 15, 50};
constexpr double kLeastShare = 0.02;  // of the information, that a drive must carry to have a say
constexpr double kWider = 2;          // times the spread of an effect's size, that an imitation of it has
// Standard deviation of a value from drive to drive, as a share of it: of a true effect (the fit is linear there), and
// of an imitation.
constexpr double kSame = 0.1, kVaried = 0.5;
constexpr double kJumps = 0.04;  // of what is explained, that varies all the same: controllers set in or do not

// Nats that larger disturbances gain on top of a model.
double inflation(const Study& study, const Fit& fit) {
    const auto usual = study.uncertainty.sizes;
    const double now = logEvidenceOf(fit, study.uncertainty, usual);
    double best = -kInfinity;
    const auto look = [&](const std::array<double, kDisturbances>& sizes) {
        best = std::max(best, logEvidenceOf(fit, study.uncertainty, sizes) - now);
    };
    for (const double factor : kAllLarger) {
        std::array<double, kDisturbances> sizes = usual;
        for (double& size : sizes) size *= factor;
        look(sizes);
    }
    for (std::size_t kind = 0; kind < kDisturbances; ++kind) {
        for (const double factor : kOneLarger) {
            std::array<double, kDisturbances> sizes = usual;
            sizes[kind] *= factor;
            look(sizes);
        }
    }
    return best;
}

}  // namespace

Outside outside(const Study& study, const Search& found) {
    const Candidate& best = found.best();
    // No law is trusted in more detail than one more effect would be.
    const double doubt = kThresholds.doubt(2, best.log_evidence, study.bench.compared());
    ForceLaw law = forceLaw(study, found.none().fit);
    law.gain -= best.log_evidence + doubt;
    const double larger = inflation(study, best.fit), gain = std::max(law.gain, larger);
    if (law.gain <= kThresholds.unknown) {
        law = forceLaw(study, best.fit);
        law.gain -= doubt;
        law.generalised_force.clear();  // of what the effects leave only
    }
    if (law.gain < std::max(larger, kThresholds.unknown)) law = {.gain = law.gain};
    return {.gain = gain, .law = std::move(law)};
}

Constancy constancy(const Study& study, const Fit& fit) {
    const Eigen::Index knobs = static_cast<Eigen::Index>(fit.knobs.size());
    if (knobs == 0) return {};
    // One column per drive: the fitted direction there, and nothing elsewhere.
    const auto n = static_cast<Eigen::Index>(fit.free.size()), nuisances = n - knobs;
    const auto drives = static_cast<Eigen::Index>(fit.grams.size());
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(n);
    direction.tail(knobs) = fit.at(fit.knobs).normalized();
    if (direction.isZero(0)) direction(nuisances) = 1;
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(nuisances + drives + 1, nuisances + drives + 1);
    const Eigen::Index last = nuisances + drives;
    for (Eigen::Index d = 0; d < drives; ++d) {
        const auto index = static_cast<std::size_t>(d);
        const Eigen::MatrixXd one =
            whitened(fit.grams[index], study.uncertainty.sizesOf(index, study.uncertainty.sizes)).products;
        Eigen::MatrixXd pick = Eigen::MatrixXd::Zero(n + 1, nuisances + 2);
        pick.topLeftCorner(nuisances, nuisances).setIdentity();
        pick.block(0, nuisances, n, 1) = direction;
        pick(n, nuisances + 1) = 1;
        const Eigen::MatrixXd here = pick.transpose() * one * pick;
        std::vector<Eigen::Index> places(static_cast<std::size_t>(nuisances));
        std::iota(places.begin(), places.end(), 0);
        places.push_back(nuisances + d), places.push_back(last);
        products(places, places) += here;
    }
    // The prior pulls the nuisances back.
    for (Eigen::Index i = 0; i < nuisances; ++i) {
        products(i, last) -= fit.at(fit.free[static_cast<std::size_t>(i)]);
        products(last, i) = products(i, last);
    }
    std::vector<Eigen::Index> out(static_cast<std::size_t>(nuisances));
    std::iota(out.begin(), out.end(), 0);
    const Eigen::MatrixXd left = marginalised({products, 0}, out).products;

    std::vector<Eigen::Index> informed;
    double information = 0;
    for (Eigen::Index d = 0; d < drives; ++d) information += left(nuisances + d, nuisances + d);
    for (Eigen::Index d = 0; d < drives; ++d)
        if (left(nuisances + d, nuisances + d) > kLeastShare * information) informed.push_back(nuisances + d);
    if (informed.size() < 2) return {};
    // Each drive its own value, against one for all.
    const Eigen::MatrixXd each = left(informed, informed);
    const Eigen::VectorXd gradient = left(informed, last);
    const double apart = gradient.dot(each.ldlt().solve(gradient));
    const double together = gradient.sum() * gradient.sum() / each.sum();
    Constancy result{std::max(0.0, apart - together), static_cast<double>(informed.size() - 1), 1, 0};
    const double told = fit.at(fit.knobs).squaredNorm() * each.sum();  // squared value over its variance
    result.spread = std::sqrt(result.q / result.degrees_of_freedom / std::max(told, 1e-12));
    result.p = chiSquaredTail(result.q, result.degrees_of_freedom);
    return result;
}

double imitationGain(const Candidate& candidate, const Constancy& same, bool compared) {
    double gain = 0;
    if (!compared) {
        for (const Eigen::Index k : candidate.fit.knobs) {
            const double size = candidate.fit.at(k);
            gain += 0.5 * size * size * (1 - 1 / (kWider * kWider)) - std::log(kWider);
        }
    }
    if (same.degrees_of_freedom == 0 || same.spread == 0) return gain;
    // Likelihood ratio of two spreads, as if every drive that has a say knew the value equally well.
    const double known = same.q / same.degrees_of_freedom / (same.spread * same.spread);  // squares over variance
    const double of_drive = known / (same.degrees_of_freedom + 1);
    const double one_value = compared ? kThresholds.structure : kSame;
    const double as_same = 1 + one_value * one_value * of_drive, as_varied = 1 + kVaried * kVaried * of_drive;
    const double varied =
        0.5 * same.q * (1 / as_same - 1 / as_varied) - 0.5 * same.degrees_of_freedom * std::log(as_varied / as_same);
    return gain + (varied > 0 ? std::max(0.0, varied - kJumps * candidate.log_evidence) : varied);
}

double chiSquaredTail(double x, double degrees_of_freedom) {
    // Regularised upper incomplete gamma function Q(a, z): series below a + 1, continued fraction (Lentz) above.
    const double a = 0.5 * degrees_of_freedom, z = 0.5 * x;
    if (z <= 0) return 1;
    const double front = std::exp(-z + a * std::log(z) - std::lgamma(a));
    constexpr int kMost = 500;
    constexpr double kSmall = 1e-15, kTiny = 1e-300;
    if (z < a + 1) {
        double term = 1 / a, sum = term;
        for (int n = 1; n < kMost && std::abs(term) > kSmall * std::abs(sum); ++n) sum += term *= z / (a + n);
        return 1 - front * sum;
    }
    double b = z + 1 - a, c = 1 / kTiny, d = 1 / b, h = d;
    for (int n = 1; n < kMost; ++n) {
        const double an = -n * (n - a);
        b += 2;
        d = an * d + b, c = b + an / c;
        d = 1 / (std::abs(d) < kTiny ? kTiny : d);
        if (std::abs(c) < kTiny) c = kTiny;
        h *= d * c;
        if (std::abs(d * c - 1) < kSmall) break;
    }
    return front * h;
}

}  // namespace tread
