// The worked example of src/diagnose/README.md: two drives of three rows, one nuisance parameter, one effect parameter,
// one disturbance of size 2 in each drive. Expected values are rational numbers or logarithms of such, by hand; those
// that leave out a drive or search for a size are from the dense covariance of all rows, computed by another program.
#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/select/posterior.h"
#include "diagnose/select/prediction.h"
#include "diagnose/select/what_remains.h"
#include "inference/bounded_step.h"
#include "inference/laplace.h"
#include "inference/normal_equations.h"
#include "shared/linear_drives.h"
#include "shared/linear_model.h"

namespace tread::diagnose_worked_example_test {
namespace {

using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::Candidate;
using diagnose::select::Fit;
using diagnose::select::Posterior;
using diagnose::select::posterior;
using diagnose::select::predicted;
using diagnose::select::Prediction;
using diagnose::select::predictiveDensities;
using diagnose::select::Remains;
using diagnose::select::Screen;
using diagnose::select::screen;
using diagnose::select::Search;
using diagnose::select::whatRemains;
using inference::boundedStep;
using inference::marginalised;
using inference::NormalEquations;
using inference::normalEquations;
using inference::productsOf;
using inference::QuadraticModel;
using linear_drives::candidateOf;
using linear_drives::doubtAgainst;
using linear_drives::fitOf;
using linear_drives::LinearDrive;
using linear_drives::resizedFitOf;
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

    NormalEquations both() const { return first.equations(2) + second.equations(2); }
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
        return boundedStep(model, 0, {lowest, limits});
    };
    expectEqual(step(8), VectorXd{{256 / 243.0, 106 / 81.0}});
    expectEqual(step(0.5), VectorXd{{43 / 27.0, 0.5}});
    const MatrixXd covariance = (MatrixXd::Identity(2, 2) + model.information).inverse();
    EXPECT_NEAR(std::sqrt(covariance(1, 1)), 1 / 3.0, kExact);
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

TEST(WorkedExample, DoubtAndPosteriorOfACatalogueOfThisEffect) {
    const ExampleDiagnosis example;
    const Search found{{candidateOf(example.car, {0}), candidateOf(example.car, {})}};
    const double value = 106 / 81.0;
    EXPECT_NEAR(found.best().fit.at(1), value, kExact);
    // What the effect changes, 2 and 10 times the square of its value, of which the nuisance cannot imitate 14/9 and 6.
    const double error = 0.0025 * value * value;
    const double believed = 14 / 9.0 / (1 + 2 * error) + 6 / (1 + 10 * error);
    const double doubted = doubtAgainst(found.none().fit, example.car, found.best().fit);
    EXPECT_NEAR(doubted, (14 / 9.0 + 6) / believed, kExact);
    EXPECT_NEAR(doubted, 1.03557, 5e-6);
    const Posterior result = posterior(example.car, found, {true, true});
    EXPECT_EQ(result.variance_factor, 1);
    EXPECT_NEAR(result.ofNothing(), 0.000649, 5e-7);
    EXPECT_NEAR(result.of(0), 0.999351, 5e-7);
}

TEST(WorkedExample, EffectPredictsEachDriveFromTheOther) {
    const ExampleDiagnosis example;
    const Fit with = fitOf(example.car, {0}), without = fitOf(example.car, {});
    const std::vector<double> densities = predictiveDensities(example.car, with),
                              before = predictiveDensities(example.car, without);
    EXPECT_NEAR(densities[0], -4.29865, 5e-6);
    EXPECT_NEAR(densities[1], -3.50039, 5e-6);
    EXPECT_NEAR(before[0], -7.65190, 5e-6);
    EXPECT_NEAR(before[1], -8.16676, 5e-6);
    const Prediction prediction = predicted(example.car, with, without);
    EXPECT_NEAR(prediction.gain, 8.01962, 5e-6);
    EXPECT_NEAR(prediction.sd, 1.31313, 5e-6);
    EXPECT_TRUE(prediction.tested) << "the second drive tells 54 of 68";
    EXPECT_NEAR(prediction.others, 3.35325, 5e-6) << "that of the first drive from the second";
}

TEST(WorkedExample, SizesOfTheRemainder) {
    const ExampleDiagnosis example;
    const auto lateral = placeOf(diagnose::model::Disturbed::lateral);
    EXPECT_NEAR(resizedFitOf(example.car, {0}).sizes[lateral], 0.918401, 5e-7);
    EXPECT_NEAR(resizedFitOf(example.car, {}).sizes[lateral], 0.618109, 5e-7);
}

// The evidence is largest at 0.851 of the usual size, which neither prior limits. That it may be above costs the wide
// prior a little.
TEST(WorkedExample, RemainderIsOrdinary) {
    ExampleDiagnosis example;
    example.car.structure_error = 0;
    const diagnose::select::Candidate model{.effects = {0}, .fit = resizedFitOf(example.car, {0}), .fitted = true};
    const Remains remains = whatRemains(example.car, model, {model.fit.at, model.fit.rows});
    EXPECT_NEAR(remains.beyond_ordinary, -0.1213, 5e-4);
    EXPECT_NEAR(remains.probability(), 0.1, 1e-4);
}

}  // namespace
}  // namespace tread::diagnose_worked_example_test
