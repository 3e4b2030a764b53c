// What a screen promises before it has seen the rows, against what it finds in 10^4 draws of them.
#include <gtest/gtest.h>

#include <cmath>

#include "base/math/random.h"
#include "diagnose/select/screen.h"
#include "shared/linear_drives.h"

namespace tread::diagnose_expected_evidence_test {
namespace {

using diagnose::model::Problem;
using diagnose::select::Calibration;
using diagnose::select::gainsOver;
using diagnose::select::screen;
using linear_drives::LinearDrive;

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kDraws = 10000;
constexpr double kDisturbed = 1.5;  // times the usual size
constexpr double kEnough = 5;       // nats

VectorXd normals(Eigen::Index count, Random& random) {
    VectorXd all(count);
    for (double& one : all) one = random.normal();
    return all;
}

MatrixXd someColumns(Eigen::Index rows, Eigen::Index columns, double size, Random& random) {
    return size * normals(rows * columns, random).reshaped(rows, columns);
}

// Two drives of twelve rows: two nuisances, one effect, three impulses of a disturbance each.
struct Drawn {
    std::vector<LinearDrive> drives = [] {
        Random random(21);
        std::vector<LinearDrive> all;
        for (int d = 0; d < 2; ++d)
            all.push_back({someColumns(12, 2, 0.8, random), someColumns(12, 1, 1.3, random), VectorXd::Zero(12),
                           someColumns(12, 3, 0.7, random)});
        return all;
    }();
    Problem problem = linear_drives::problemOf(drives);
    Calibration car = linear_drives::calibrationOf(problem, drives, kDisturbed);

    // Rows of a car with the effect of a size, everything else as its prior draws it.
    void draw(double size, Random& random) {
        const VectorXd nuisances = normals(2, random);
        for (std::size_t d = 0; d < drives.size(); ++d)
            problem.drives[d].measured = drives[d].nuisances * nuisances + size * drives[d].effects +
                                         kDisturbed * drives[d].disturbances * normals(3, random) + normals(12, random);
    }
};

// Information about the effect when everything else is marginalised: from the full covariance of all 24 rows.
double informationOf(const Drawn& drawn) {
    MatrixXd covariance = MatrixXd::Identity(24, 24);
    MatrixXd nuisances(24, 2);
    VectorXd effect(24);
    for (Eigen::Index d = 0; d < 2; ++d) {
        const LinearDrive& drive = drawn.drives[d];
        nuisances.middleRows(12 * d, 12) = drive.nuisances;
        effect.segment(12 * d, 12) = drive.effects;
        covariance.block(12 * d, 12 * d, 12, 12) +=
            kDisturbed * kDisturbed * drive.disturbances * drive.disturbances.transpose();
    }
    covariance += nuisances * nuisances.transpose();
    return effect.dot(covariance.inverse() * effect);
}

TEST(ExpectedEvidence, IsHalfTheInformationThatTheFullCovarianceLeaves) {
    const Drawn drawn;
    EXPECT_NEAR(screen(drawn.car).expected_evidence.front(), 0.5 * informationOf(drawn), 1e-9);
}

// (D44) and the mean of (D25), whose gradient is distributed as N(I size, I).
TEST(ExpectedEvidence, GainsOfDrawnCarsAreDistributedAsItSays) {
    Drawn drawn;
    const double information = 2 * screen(drawn.car).expected_evidence.front();
    ASSERT_GT(information, 5);
    ASSERT_LT(information, 50);
    const double freedom = 0.5 * std::log(1 + information);
    const double z = std::sqrt(2 * (kEnough + freedom) * (1 + information) / information);
    const auto normal = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2)); };
    Random random(22);
    for (const double size : {0.0, 0.6, 1.0, 1.6}) {
        double sum = 0, squares = 0, found = 0;
        for (int i = 0; i < kDraws; ++i) {
            drawn.draw(size, random);
            const double gain =
                gainsOver(drawn.car, drawn.car.about, drawn.car.fit, drawn.car.uncertainty.sizes).front();
            sum += gain, squares += gain * gain;
            found += gain >= kEnough ? 1 : 0;
        }
        const double mean = sum / kDraws, error = std::sqrt((squares / kDraws - mean * mean) / kDraws);
        const double expected =
            0.5 * (information + information * information * size * size) / (1 + information) - freedom;
        EXPECT_NEAR(mean, expected, 3 * error) << size;
        const double shift = size * std::sqrt(information), p = normal(shift - z) + normal(-shift - z);
        EXPECT_NEAR(found / kDraws, p, 3 * std::sqrt(p * (1 - p) / kDraws)) << size;
    }
}

}  // namespace
}  // namespace tread::diagnose_expected_evidence_test
