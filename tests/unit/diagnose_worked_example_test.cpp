// The worked example of src/diagnose/README.md: two drives of three rows, one nuisance parameter, one effect parameter,
// one disturbance of size 2 in each drive. All expected values are rational numbers or logarithms of such, by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/select/posterior.h"
#include "diagnose/select/search.h"
#include "diagnose/select/unknown_cause.h"
#include "inference/bounded_step.h"
#include "inference/heterogeneity.h"
#include "inference/laplace.h"
#include "inference/normal_equations.h"
#include "shared/linear_drives.h"
#include "shared/linear_model.h"

namespace tread {
namespace {

using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Fit;
using diagnose::select::Hypothesis;
using diagnose::select::lookAlikeGain;
using diagnose::select::Posterior;
using diagnose::select::posterior;
using diagnose::select::Screen;
using diagnose::select::screen;
using diagnose::select::Search;
using diagnose::select::Sizes;
using inference::boundedStep;
using inference::Heterogeneity;
using inference::heterogeneity;
using inference::logBayesFactorOfSpread;
using inference::marginalised;
using inference::NormalEquations;
using inference::normalEquations;
using inference::productsOf;
using inference::QuadraticModel;
using linear_drives::candidateOf;
using linear_drives::LinearDrive;
using linear_model::logEvidence;
using linear_model::quadraticOf;

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kExact = 1e-12;

struct Drive {
    MatrixXd columns;  // nuisance, effect, residual
    MatrixXd disturbance;

    NormalEquations equations(double size) const {
        return normalEquations(productsOf(columns, disturbance), VectorXd::Constant(1, size));
    }
};

struct Example {
    Drive first{MatrixXd{{0, 1, 3}, {0, 1, 0}, {3, 2, 5}}, MatrixXd{{0}, {1}, {1}}};
    Drive second{MatrixXd{{3, 1, 6}, {3, 2, 6}, {1, 3, 5}}, MatrixXd{{1}, {1}, {0}}};

    NormalEquations both(double size = 2) const { return first.equations(size) + second.equations(size); }
};

void expectEqual(const MatrixXd& found, const MatrixXd& expected) {
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), kExact) << found;
}

TEST(WorkedExample, ProductsInTheMetricOfTheDisturbances) {
    const Example example;
    expectEqual(example.first.equations(2).products,
                MatrixXd{{5, 2, 25 / 3.0}, {2, 2, 19 / 3.0}, {25 / 3.0, 19 / 3.0, 206 / 9.0}});
    expectEqual(example.second.equations(2).products, MatrixXd{{3, 4, 9}, {4, 10, 17}, {9, 17, 33}});
    EXPECT_NEAR(example.both().log_determinant, 2 * std::log(9), kExact);
}

TEST(WorkedExample, InformationEvidenceAndGainOfTheEffect) {
    const NormalEquations both = Example{}.both();
    const MatrixXd left = marginalised(both, {0}).products;
    const double information = left(1, 1), gradient = left(1, 2);
    EXPECT_NEAR(information, 8, kExact);
    EXPECT_NEAR(gradient, 106 / 9.0, kExact);
    const double none = logEvidence(both, 2, {0}), effect = logEvidence(both, 2, {0, 1});
    EXPECT_NEAR(none, -0.5 * (1823 / 81.0 + 3 * std::log(9)), kExact);
    EXPECT_NEAR(effect - none, 0.5 * gradient * gradient / (1 + information) - std::log(3), kExact);
    EXPECT_NEAR(effect - none, 6.60783, 5e-6);
    EXPECT_NEAR(0.5 * information, 4, kExact);  // expected evidence
}

TEST(WorkedExample, EstimateAndItsStandardDeviation) {
    const QuadraticModel model = quadraticOf(Example{}.both(), 2, {0, 1});
    const auto step = [&](double highest) {
        const VectorXd lowest{{-4, -8}}, limits{{4, highest}};
        return boundedStep(model, 0, lowest, limits);
    };
    expectEqual(step(8), VectorXd{{256 / 243.0, 106 / 81.0}});
    expectEqual(step(0.5), VectorXd{{43 / 27.0, 0.5}});
    const MatrixXd covariance = (MatrixXd::Identity(2, 2) + model.information).inverse();
    EXPECT_NEAR(std::sqrt(covariance(1, 1)), 1 / 3.0, kExact);
}

// The effect as two columns, each of one drive alone.
TEST(WorkedExample, HeterogeneityBetweenTheDrives) {
    Example example;
    for (Drive* drive : {&example.first, &example.second}) {
        const bool is_first = drive == &example.first;
        MatrixXd apart = MatrixXd::Zero(3, 4);
        apart.col(0) = drive->columns.col(0);
        apart.col(is_first ? 1 : 2) = drive->columns.col(1);
        apart.col(3) = drive->columns.col(2);
        drive->columns = apart;
    }
    const MatrixXd left = marginalised(example.both(), {0}).products;
    const MatrixXd each = left.block(1, 1, 2, 2);
    const VectorXd gradient = left.block(1, 3, 2, 1);
    expectEqual(each, MatrixXd{{14 / 9.0, -8 / 9.0}, {-8 / 9.0, 74 / 9.0}});
    expectEqual(each.inverse() * gradient, VectorXd{{43 / 18.0, 25 / 18.0}});
    const double value = 106 / 81.0;
    const Heterogeneity found = heterogeneity(each, gradient, value * value, 0.02);
    EXPECT_NEAR(found.q, 1.5, kExact);
    EXPECT_EQ(found.degrees_of_freedom, 1);
    EXPECT_NEAR(found.p, std::erfc(std::sqrt(0.75)), kExact);
    EXPECT_NEAR(found.spread, 0.330887, 5e-7);
    EXPECT_NEAR(logBayesFactorOfSpread(found, 0.5, 0.1), -0.0403905, 5e-8);
}

TEST(WorkedExample, ResemblanceGainsLittle) {
    const double value = 106 / 81.0, q = 1.5, precision = value * value * 8;  // 8: information of both drives together
    const Heterogeneity same{.q = q, .degrees_of_freedom = 1, .p = 0.220671, .spread = std::sqrt(q / precision)};
    EXPECT_NEAR(same.spread, 0.330887, 5e-7);
    EXPECT_NEAR(lookAlikeGain(same, false), -0.0403905, 5e-8);
}

// The same drives as a diagnosis has them.
struct ExampleDiagnosis {
    std::vector<LinearDrive> drives = [] {
        std::vector<LinearDrive> all;
        for (const Drive& drive : {Example{}.first, Example{}.second})
            all.push_back({drive.columns.col(0), drive.columns.col(1), drive.columns.col(2), drive.disturbance});
        return all;
    }();
    Problem problem = linear_drives::problemOf(drives);
    Calibration car = linear_drives::calibrationOf(problem, drives, 2);
};

TEST(WorkedExample, ScreenPromisesAndGainsWhatIsComputedByHand) {
    const ExampleDiagnosis example;
    const Screen seen = screen(example.car);
    EXPECT_NEAR(seen.expected_evidence.front(), 4, kExact);
    EXPECT_NEAR(seen.gain.front(), 6.60783, 5e-6);
}

// (D44), of an expected evidence of 4: that the effect gains 5 nats at its typical size and at 1.6 of it.
TEST(WorkedExample, EffectIsFoundAsOftenAsItsExpectedEvidenceSays) {
    const double information = 2 * screen(ExampleDiagnosis{}.car).expected_evidence.front();
    const double z = std::sqrt(2 * (5 + 0.5 * std::log(1 + information)) * (1 + information) / information);
    EXPECT_NEAR(z, 3.70431, 5e-6);
    const auto normal = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2)); };
    const auto found = [&](double size) {
        const double shift = size * std::sqrt(information);
        return normal(shift - z) + normal(-shift - z);
    };
    EXPECT_NEAR(found(1), 0.190548, 5e-7);
    EXPECT_NEAR(found(1.6), 0.794228, 5e-7);
}

TEST(WorkedExample, PosteriorOfACatalogueOfThisEffect) {
    const ExampleDiagnosis example;
    const Search found{{candidateOf(example.car, {0}), candidateOf(example.car, {})}};
    EXPECT_NEAR(found.best().fit.at(1), 106 / 81.0, kExact);
    EXPECT_NEAR(diagnose::select::heterogeneity(example.car, found.best().fit).q, 1.5, kExact);
    const Posterior result = posterior(example.car, found, -0.656231);
    EXPECT_EQ(result.variance_factor, 1);
    const auto probability = [&](const Candidate* candidate, bool look_alike) {
        for (const Hypothesis& one : result.hypotheses)
            if (one.candidate == candidate && one.look_alike == look_alike) return one.probability;
        return -1.0;
    };
    EXPECT_NEAR(probability(&found.candidates[1], false), 0.000741, 5e-7);
    EXPECT_NEAR(probability(&found.candidates[0], false), 0.988429, 5e-7);
    EXPECT_NEAR(probability(&found.candidates[0], true), 0.010548, 5e-7);
    EXPECT_NEAR(probability(nullptr, false), 0.000282, 5e-7);
    EXPECT_NEAR(result.of(0), 0.988429, 5e-7);
}

TEST(WorkedExample, LargerDisturbancesAreLessLikely) {
    const Example example;
    const double usual = logEvidence(example.both(), 2, {0, 1}), larger = logEvidence(example.both(3.2), 2, {0, 1});
    EXPECT_NEAR(larger - usual, -0.656231, 5e-7);
    const ExampleDiagnosis diagnosis;
    const Fit fit = linear_drives::fitOf(diagnosis.car, {0});
    Sizes sizes = diagnosis.car.uncertainty.sizes;
    EXPECT_NEAR(logEvidence(fit, diagnosis.car.uncertainty, sizes), usual, 1e-9);
    for (double& size : sizes) size *= 1.6;
    EXPECT_NEAR(logEvidence(fit, diagnosis.car.uncertainty, sizes), larger, 1e-9);
}

}  // namespace
}  // namespace tread
