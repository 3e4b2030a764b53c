// Noise of drives that are not equally noisy: vibration grows with the speed.
#include "diagnose/model/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/math/random.h"

namespace tread::diagnose_noise_test {
namespace {

using diagnose::model::rowNoise;
using diagnose::model::Rows;
using recording::RecordedDrive;

// Noise that is found in drives of one channel, whose rows are white noise of these standard deviations.
class Drives {
public:
    explicit Drives(double told = 0) : told_(told) {}

    void add(double deviation, int rows, Random& random) {
        RecordedDrive& drive = drives_.emplace_back();
        drive.recording = &recording_;
        drive.measured.resize(rows);
        for (double& one : drive.measured) one = deviation * random.normal();
        drive.channels = {
            {.name = "rows", .measured = {}, .noise = told_, .times = std::vector<double>(static_cast<size_t>(rows))}};
    }
    std::vector<double> found() const {
        Rows model;
        for (const RecordedDrive& drive : drives_) model.emplace_back(Eigen::VectorXd::Zero(drive.rows()));
        std::vector<double> each;
        for (const auto& one : rowNoise(drives_, model, std::vector<double>(drives_.size(), kInfinity)))
            each.push_back(one.deviation(0));
        return each;
    }

private:
    double told_;
    recording::Recording recording_;
    std::vector<RecordedDrive> drives_;
};

TEST(RowNoise, IsThatOfEachDriveWhereTheyDiffer) {
    Random random(5);
    Drives drives;
    const std::vector<double> truth{1, 1, 1, 2, 2, 4};
    for (const double deviation : truth) drives.add(deviation, 400, random);
    const std::vector<double> found = drives.found();
    for (std::size_t d = 0; d < truth.size(); ++d) EXPECT_NEAR(found[d] / truth[d], 1, 0.2) << d;
}

// Few rows tell the noise of a drive inexactly, and the other drives tell something about it. What is found is nearer
// to the truth than the estimate of each drive and than what they have in common.
TEST(RowNoise, IsNearerToTheTruthThanEachDriveByItselfOrAllTogether) {
    constexpr double kDiffer = 0.3;  // standard deviation of the logarithm
    constexpr int kDrives = 10, kRows = 50, kDraws = 300;
    Random random(6);
    double together = 0, alone = 0, found_off = 0;
    for (int draw = 0; draw < kDraws; ++draw) {
        Drives drives;
        std::vector<double> logs;
        for (int d = 0; d < kDrives; ++d) {
            Drives one;
            const double log_deviation = kDiffer * random.normal();
            Random same = random;
            drives.add(std::exp(log_deviation), kRows, random);
            one.add(std::exp(log_deviation), kRows, same);
            logs.push_back(log_deviation);
            together += std::pow(log_deviation, 2);
            alone += std::pow(std::log(one.found().front()) - log_deviation, 2);
        }
        const std::vector<double> found = drives.found();
        for (int d = 0; d < kDrives; ++d) found_off += std::pow(std::log(found[d]) - logs[d], 2);
    }
    // Of a normal distribution about a known mean, the best estimate has 1/(1/together + 1/alone).
    EXPECT_LT(found_off, 1.25 / (1 / together + 1 / alone));
    EXPECT_LT(found_off, 0.85 * std::min(together, alone));
}

TEST(RowNoise, IsTheSameInDrivesThatAreAlike) {
    Random random(7);
    double squares = 0;
    for (int draw = 0; draw < 50; ++draw) {
        Drives drives;
        for (int d = 0; d < 8; ++d) drives.add(1, 100, random);
        for (const double one : drives.found()) squares += std::pow(std::log(one), 2) / (50 * 8);
    }
    EXPECT_LT(squares, 0.4 * 2.1 / 100) << "of an estimate from one drive";
}

TEST(RowNoise, IsTheUsualOneWhereADriveIsTooShortToTell) {
    Random random(8);
    Drives drives;
    for (const double deviation : {1.0, 2.0, 4.0}) drives.add(deviation, 400, random);
    drives.add(100, 8, random);
    EXPECT_NEAR(drives.found().back(), 2, 0.3);
}

TEST(RowNoise, IsNotLessThanTheInstrumentHas) {
    Random random(9);
    Drives drives(1.5);
    for (const double deviation : {0.5, 1.0, 4.0}) drives.add(deviation, 400, random);
    const std::vector<double> found = drives.found();
    EXPECT_DOUBLE_EQ(found[0], 1.5);
    EXPECT_DOUBLE_EQ(found[1], 1.5);
    EXPECT_NEAR(found[2], 4, 0.6);
}

}  // namespace
}  // namespace tread::diagnose_noise_test
