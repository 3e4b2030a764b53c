// The detectability formula against its dense form, closed forms and random draws.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/math/random.h"
#include "blind/detectability/detectability.h"
#include "blind/world/reading_noise.h"

namespace tread::blind_detectability_test {
namespace {

using blind::detectability::detectabilities;
using blind::detectability::DriveColumns;
using blind::detectability::kRivalSizes;
using blind::detectability::Rival;
using blind::key::Detectability;
using blind::world::blockCovariance;
using blind::world::blockMeans;
using blind::world::ReadingNoise;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd drawn(Random& random, Index rows, Index columns) {
    MatrixXd all(rows, columns);
    for (double& value : all.reshaped()) value = random.normal();
    return all;
}

// Two channels of these many rows with correlated noise, two pushes, three tolerances, two rivals of two and one
// columns, and one change.
DriveColumns toy(Random& random, Index first, Index second) {
    DriveColumns drive;
    for (const Index rows : {first, second}) {
        const MatrixXd mixed = drawn(random, rows, rows);
        drive.noise.push_back(MatrixXd::Identity(rows, rows) + 0.1 * mixed * mixed.transpose());
    }
    const Index rows = first + second;
    drive.pushes = drawn(random, rows, 2);
    drive.tolerances = drawn(random, rows, 3);
    drive.rivals = drawn(random, rows, 3);
    drive.changes = 2 * drawn(random, rows, 1);
    return drive;
}

MatrixXd sigma(const DriveColumns& drive) {
    const Index first = drive.noise[0].rows(), rows = drive.changes.rows();
    MatrixXd all = MatrixXd::Zero(rows, rows);
    all.topLeftCorner(first, first) = drive.noise[0];
    all.bottomRightCorner(rows - first, rows - first) = drive.noise[1];
    return all + drive.pushes * drive.pushes.transpose();
}

// All drives in one matrix.
double dense(const std::vector<DriveColumns>& drives, const std::vector<Index>& free_rivals) {
    Index rows = 0, row = 0;
    for (const DriveColumns& drive : drives) rows += drive.changes.rows();
    const Index tolerances = drives[0].tolerances.cols();
    MatrixXd all = MatrixXd::Zero(rows, rows);
    MatrixXd free(rows, tolerances + static_cast<Index>(free_rivals.size()));
    VectorXd delta(rows);
    for (const DriveColumns& drive : drives) {
        const Index here = drive.changes.rows();
        all.block(row, row, here, here) = sigma(drive);
        free.block(row, 0, here, tolerances) = drive.tolerances;
        for (std::size_t i = 0; i < free_rivals.size(); ++i)
            free.block(row, tolerances + static_cast<Index>(i), here, 1) =
                kRivalSizes * drive.rivals.col(free_rivals[i]);
        delta.segment(row, here) = drive.changes;
        row += here;
    }
    all += free * free.transpose();
    return 0.5 * delta.dot(all.inverse() * delta);
}

const std::vector<Rival> kRivals{{"pair", {0, 1}}, {"single", {2}}};

TEST(BlindDetectability, NatsAndSeparationAreThoseOfTheDenseFormula) {
    Random random(1);
    const std::vector<DriveColumns> drives{toy(random, 5, 7), toy(random, 9, 4)};
    const Detectability shown = detectabilities(drives, kRivals, {{"fault", {}, {}}}).at("fault");
    EXPECT_NEAR(shown.nats, dense(drives, {}), 1e-10);
    const double pair = dense(drives, {0, 1}), single = dense(drives, {2});
    EXPECT_EQ(shown.rival, pair < single ? "pair" : "single");
    EXPECT_NEAR(shown.separation, std::min(pair, single), 1e-10);
    EXPECT_LT(shown.separation, shown.nats);
}

TEST(BlindDetectability, WhoIsExcludedIsNoRival) {
    Random random(1);
    const std::vector<DriveColumns> drives{toy(random, 5, 7)};
    const auto among = [&](const std::vector<std::string>& excluded_rivals) {
        return detectabilities(drives, kRivals, {{"fault", {}, excluded_rivals}}).at("fault");
    };
    EXPECT_EQ(among({"pair"}).rival, "single");
    EXPECT_EQ(among({"single"}).rival, "pair");
    const Detectability alone = among({"pair", "single"});
    EXPECT_EQ(alone.rival, "");
    EXPECT_EQ(alone.separation, alone.nats);
}

TEST(BlindDetectability, WhatAToleranceImitatesFullyLeavesNothing) {
    Random random(2);
    DriveColumns drive = toy(random, 6, 6);
    drive.tolerances.col(1) = 1e5 * drive.changes;
    const Detectability shown = detectabilities({drive}, kRivals, {{"fault", {}, {}}}).at("fault");
    EXPECT_NEAR(shown.nats, 0, 1e-8);
    EXPECT_NEAR(shown.separation, 0, 1e-8);
}

TEST(BlindDetectability, WhatAToleranceImitatesIsWorthItsSurprise) {
    // Then only the size speaks: with k standard deviations of the tolerance 1/2 k^2 in the limit of no noise.
    Random random(2);
    DriveColumns drive = toy(random, 6, 6);
    drive.changes *= 1e4;
    drive.tolerances.col(1) = drive.changes / 5;
    EXPECT_NEAR(detectabilities({drive}, {}, {{"fault", {}, {}}}).at("fault").nats, 12.5, 1e-3);
}

TEST(BlindDetectability, RivalThatIsTheSameSeparatesByItsSizeAlone) {
    Random random(3);
    DriveColumns drive = toy(random, 6, 6);
    drive.changes *= 1e4;
    drive.rivals.col(2) = drive.changes;
    const Detectability shown = detectabilities({drive}, kRivals, {{"fault", {}, {}}}).at("fault");
    EXPECT_EQ(shown.rival, "single");
    EXPECT_NEAR(shown.separation, 0.5 / (kRivalSizes * kRivalSizes), 1e-4);
}

TEST(BlindDetectability, TheSizeOfAnEffectBesideIsFree) {
    // Beside the effect "single", whose change is the second one: its knob and its change join the tolerances.
    Random random(8);
    DriveColumns both = toy(random, 6, 7), one = both;
    const VectorXd change = both.changes, beside = drawn(random, 13, 1);
    both.changes.resize(13, 2);
    both.changes << change, beside;
    one.tolerances.resize(13, 5);
    one.tolerances << both.tolerances, kRivalSizes * both.rivals.col(2), kRivalSizes * beside;
    const auto found = detectabilities({both}, kRivals, {{"fault", {"single"}, {"single"}}, {"single", {}, {}}});
    EXPECT_NEAR(found.at("fault").nats, dense({one}, {}), 1e-10);
    EXPECT_NEAR(found.at("fault").separation, dense({one}, {0, 1}), 1e-10);
    EXPECT_EQ(found.at("fault").rival, "pair");
    EXPECT_LT(found.at("fault").nats,
              detectabilities({both}, kRivals, {{"fault", {}, {}}, {"single", {}, {}}}).at("fault").nats);
}

TEST(BlindDetectability, TwiceTheChangeShowsFourTimes) {
    Random random(4);
    DriveColumns drive = toy(random, 6, 8), twice = drive;
    twice.changes *= 2;
    const Detectability one = detectabilities({drive}, kRivals, {{"fault", {}, {}}}).at("fault");
    const Detectability two = detectabilities({twice}, kRivals, {{"fault", {}, {}}}).at("fault");
    EXPECT_NEAR(two.nats / one.nats, 4, 1e-10);
    EXPECT_NEAR(two.separation / one.separation, 4, 1e-10);
}

TEST(BlindDetectability, RepeatsAreDrivesAndAReferenceDoublesTheNoise) {
    Random random(5);
    const DriveColumns drive = toy(random, 6, 8);
    DriveColumns twice = drive, compared = drive, doubled = drive;
    twice.times = 2;
    compared.times = 0.5;
    for (MatrixXd& noise : doubled.noise) noise *= 2;
    doubled.pushes *= std::numbers::sqrt2;
    const auto nats = [](const std::vector<DriveColumns>& drives) {
        return detectabilities(drives, {}, {{"fault", {}, {}}}).at("fault").nats;
    };
    EXPECT_NEAR(nats({twice}), nats({drive, drive}), 1e-10);
    EXPECT_NEAR(nats({compared}), nats({doubled}), 1e-10);
}

TEST(BlindDetectability, EvidenceOfDrawsHasTheExpectedMean) {
    // Log likelihood of the truth with the fault over that without it, of readings that are drawn.
    Random random(6);
    const DriveColumns drive = toy(random, 10, 10);
    const MatrixXd all = sigma(drive) + drive.tolerances * drive.tolerances.transpose();
    const MatrixXd factor = all.llt().matrixL(), inverse = all.inverse();
    const VectorXd delta = drive.changes;
    constexpr int kDraws = 200;
    double sum = 0, squares = 0;
    for (int i = 0; i < kDraws; ++i) {
        const VectorXd y = delta + factor * drawn(random, delta.size(), 1);
        const double gain = 0.5 * y.dot(inverse * y) - 0.5 * (y - delta).dot(inverse * (y - delta));
        sum += gain, squares += gain * gain;
    }
    const double mean = sum / kDraws, sd = std::sqrt(squares / kDraws - mean * mean);
    const double nats = detectabilities({drive}, {}, {{"fault", {}, {}}}).at("fault").nats;
    EXPECT_NEAR(mean, nats, 3 * sd / std::sqrt(kDraws));
    EXPECT_NEAR(sd, std::sqrt(2 * nats), 0.2 * std::sqrt(2 * nats)) << "of a normal distribution";
}

// ---- Noise of readings ---------------------------------------------------------------------------------------------

std::vector<double> timesOf(std::size_t count) {
    std::vector<double> times;
    for (std::size_t i = 0; i < count; ++i) times.push_back(0.01 * static_cast<double>(i));
    return times;
}

TEST(BlindReadingNoise, BlocksAreMeansOverFiftyMilliseconds) {
    const std::vector<double> times = timesOf(11);
    std::vector<double> readings;
    for (int i = 0; i < 11; ++i) readings.push_back(i);
    const VectorXd means = blockMeans(times, readings);
    ASSERT_EQ(means.size(), 3);
    EXPECT_DOUBLE_EQ(means(0), 2);
    EXPECT_DOUBLE_EQ(means(1), 7);
    EXPECT_DOUBLE_EQ(means(2), 10);
}

TEST(BlindReadingNoise, WhiteNoiseAndStepsOfAReadingAverageOut) {
    const std::vector<double> times = timesOf(20), still(20, 3.0);
    const MatrixXd covariance = blockCovariance({.level = 0.2, .resolution = 0.06}, times, still);
    const double variance = (0.04 + 0.0036 / 12) / 5;
    EXPECT_TRUE(covariance.isApprox(variance * MatrixXd::Identity(4, 4), 1e-12)) << covariance;
}

TEST(BlindReadingNoise, JitterCountsBySlope) {
    const std::vector<double> times = timesOf(20);
    std::vector<double> rising;
    for (const double time : times) rising.push_back(4 * time);
    const MatrixXd covariance = blockCovariance({.level = 0.1, .jitter = 0.002}, times, rising);
    EXPECT_NEAR(covariance(1, 1), (0.01 + 16 * 4e-6) / 5, 1e-12);
    EXPECT_NEAR(covariance(1, 2), 0, 1e-15);
}

TEST(BlindReadingNoise, ColouredAndShakenReadingsVaryAsDrawsDo) {
    const ReadingNoise noise{
        .level = 0.3, .correlation = 0.7, .shaking = 0.2, .frequency = 8, .frequency_band = 0.5, .engine = 0.25};
    const std::vector<double> times = timesOf(30), still(30, 0.0);
    std::vector<double> phase;
    for (const double time : times) phase.push_back(2 * std::numbers::pi * (17 * time + 4 * time * time));
    const MatrixXd expected = blockCovariance(noise, times, still, phase);
    constexpr int kDraws = 20000;
    MatrixXd found = MatrixXd::Zero(6, 6);
    Random random(7);
    for (int n = 0; n < kDraws; ++n) {
        const double first = 2 * std::numbers::pi * random.uniform(), second = 2 * std::numbers::pi * random.uniform();
        const double frequency = 8 + 0.5 * (2 * random.uniform() - 1);
        double error = noise.level * random.normal();
        std::vector<double> readings;
        for (std::size_t i = 0; i < times.size(); ++i) {
            readings.push_back(error + noise.shaking * std::sin(2 * std::numbers::pi * frequency * times[i] + first) +
                               noise.engine * std::sin(phase[i] + second));
            error = noise.correlation * error +
                    noise.level * std::sqrt(1 - noise.correlation * noise.correlation) * random.normal();
        }
        const VectorXd means = blockMeans(times, readings);
        found += means * means.transpose() / kDraws;
    }
    // Standard error of a covariance: about sqrt(2 / draws) of the variances.
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 4 * std::sqrt(2.0 / kDraws) * expected.diagonal().maxCoeff());
}

}  // namespace
}  // namespace tread::blind_detectability_test
