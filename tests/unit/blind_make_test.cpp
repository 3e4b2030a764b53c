// The cases of a blind check: what is drawn, what is driven, what is sealed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/numbers.h"
#include "blind/make.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "shared/scratch.h"
#include "shared/vehicles.h"
#include "store/sha256.h"
#include "tread/problem.h"

namespace tread {
namespace {

using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using recording::numberAt;
using recording::Subject;

const std::vector<Effect> kEffects{
    {"heavier", "", "", {{{"mass"}, 0.1, true, Direction::up}}},
    {"late_gyro", "", "", {{{"instruments.yaw_rate.delay"}, 0.02, false, Direction::up}}},
    {"ratio", "", "", {{{"steering.ratio"}, 0.05, true, Direction::either}}},
};

DrawnCase drawn(CaseKind kind, std::uint64_t seed) {
    Random random(seed);
    return drawCase(reference::compact(), kEffects, kind, random);
}

double largestDifference(const Log& a, const Log& b, std::string_view channel) {
    const auto &x = a.find(channel)->values, &y = b.find(channel)->values;
    double largest = 0;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
    return largest;
}

TEST(BlindMake, HashIsThatOfTheStandard) {
    // FIPS 180-4, examples of NIST.
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(BlindMake, EveryNumberWithAToleranceErrsWithinIt) {
    Subject nominal{.vehicle = reference::compact(), .road = {}, .wind = {}, .instruments = {}};
    DrawnCase none = drawn(CaseKind::none, 3);
    const std::vector<Number> known = numbers(nominal), real = numbers(none.truth.car);
    ASSERT_EQ(known.size(), real.size());
    int erring = 0;
    for (std::size_t i = 0; i < known.size(); ++i) {
        const double tolerance = known[i].about.tolerance * std::abs(*known[i].value);
        if (!(tolerance > 0)) continue;
        const double error = std::abs(*real[i].value - *known[i].value);
        EXPECT_LE(error, tolerance * (1 + 1e-12)) << known[i].path;
        if (known[i].about.limits.allow(*known[i].value + tolerance)) {
            EXPECT_GT(error, 0) << known[i].path;
            ++erring;
        }
    }
    EXPECT_GT(erring, 30);
    EXPECT_NE(none.truth.car.instruments.yaw_rate.bias, 0);
    EXPECT_TRUE(none.key.effects.empty());
    EXPECT_TRUE(none.key.numbers.empty());
}

TEST(BlindMake, KindsPlantWhatTheySay) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const DrawnCase one = drawn(CaseKind::one, seed), two = drawn(CaseKind::two, seed);
        const DrawnCase small = drawn(CaseKind::small, seed), outside = drawn(CaseKind::outside, seed);
        ASSERT_EQ(one.key.effects.size(), 1u);
        ASSERT_EQ(small.key.effects.size(), 1u);
        ASSERT_EQ(two.key.effects.size(), 2u);
        EXPECT_NE(two.key.effects[0], two.key.effects[1]);
        for (const auto& [path, number] : one.key.numbers) {
            EXPECT_GE(std::abs(number.change), 0.6) << path;
            EXPECT_LE(std::abs(number.change), 1.6) << path;
            if (path != "steering.ratio") {
                EXPECT_GT(number.change, 0) << path;
            }
        }
        for (const auto& [path, number] : small.key.numbers) EXPECT_LE(std::abs(number.change), 0.15) << path;
        EXPECT_FALSE(outside.key.outsider.empty());
        EXPECT_TRUE(outside.key.effects.empty());
    }
}

TEST(BlindMake, PlantedNumberIsThatOfTheCarThatIsDriven) {
    DrawnCase one = drawn(CaseKind::one, 5);
    for (const auto& [path, number] : one.key.numbers) EXPECT_EQ(*numberAt(one.truth.car, path), number.value);
}

TEST(BlindMake, EveryDriveHoldsItsGearAndEndsInTime) {
    const DrawnCase none = drawn(CaseKind::none, 1);
    int training = 0, held_out = 0;
    for (const Drive& drive : blindDrives()) {
        const Log log = measure(none.truth, drive, 7);
        const std::vector<double>& gear = log.find("driveline.gear")->values;
        EXPECT_EQ(*std::min_element(gear.begin(), gear.end()), *std::max_element(gear.begin(), gear.end()))
            << drive.name;
        const double duration = log.channels.front().values.back();
        EXPECT_GE(duration, 3) << drive.name;
        EXPECT_LE(duration, 12) << drive.name;
        (drive.hold_out ? held_out : training) += 1;
    }
    EXPECT_GE(training, 8);
    EXPECT_GE(held_out, 2);
}

TEST(BlindMake, SmallSetsOfDrivesAreTwoToLearnFromAndTheSameToJudge) {
    const auto names = [](DriveSet set, bool held_out) {
        std::vector<std::string> found;
        for (const Drive& drive : blindDrives(set)) {
            if (drive.hold_out != held_out) continue;
            found.push_back(drive.name);
            EXPECT_TRUE(set == DriveSet::all || drive.repeats == 1) << drive.name;
        }
        return found;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(names(DriveSet::step_steers, false), (Names{"step_steer_80", "step_steer_110"}));
    EXPECT_EQ(names(DriveSet::coast_and_accelerate, false), (Names{"coast_down_120", "acceleration_50"}));
    for (const DriveSet set : {DriveSet::step_steers, DriveSet::coast_and_accelerate})
        EXPECT_EQ(names(set, true), names(DriveSet::all, true));
    EXPECT_THROW(driveSet("step_stear"), LoadError);
}

TEST(BlindMake, EveryOutsiderShowsInTheLogs) {
    const DrawnCase none = drawn(CaseKind::none, 1);
    const std::vector<Drive> drives = blindDrives();
    for (const Outsider& outsider : outsiders()) {
        Truth truth = none.truth;
        Random random(4);
        outsider.plant(truth, random);
        double most = 0;  // in standard deviations of the noise
        for (const std::size_t which : {std::size_t{0}, std::size_t{2}, std::size_t{5}}) {
            const Drive& drive = drives[which];
            const Log with = measure(truth, drive, 1, kIdeal), without = measure(none.truth, drive, 1, kIdeal);
            most = std::max({most, largestDifference(with, without, "chassis.yaw_rate") / 0.002,
                             largestDifference(with, without, "wheel.front_left.spin") / 0.1,
                             largestDifference(with, without, "wheel.rear_left.spin") / 0.1});
        }
        EXPECT_GT(most, 4) << outsider.name;
    }
}

TEST(BlindMake, SameSeedMakesTheSameFilesAndAnotherOneOthers) {
    const Scratch scratch;
    const auto make = [&](const std::string& folder, std::uint64_t seed) {
        BlindOrder order;
        order.cases = 1;
        order.seed = seed;
        order.kinds = {CaseKind::one};
        const BlindKey key = makeCases(order, reference::compact(), kEffects, scratch.path(folder));
        return keyText(key) + contentOf(scratch.path(folder + "/case_001/step_steer_80_2.csv"));
    };
    EXPECT_EQ(make("a", 1), make("b", 1));
    EXPECT_NE(make("a", 1), make("c", 2));
}

TEST(BlindMake, CaseIsDrawnAgainFromItsSeedAndKind) {
    const Scratch scratch;
    BlindOrder order;
    order.cases = 3;
    order.seed = 9;
    const BlindKey key = makeCases(order, reference::compact(), kEffects, scratch.path("cases"));
    for (int i = 0; i < order.cases; ++i) {
        const CaseKey& made = key.cases[static_cast<std::size_t>(i)];
        EXPECT_EQ(drawnCase(9, i, made.kind, reference::compact(), kEffects).key, made);
    }
}

TEST(BlindMake, RepeatsAreNotAlike) {
    const DrawnCase none = drawn(CaseKind::none, 1);
    const std::vector<Drive> drives = blindDrives();
    const auto recordings = recordingsOf(drives, 1, 0);
    ASSERT_EQ(recordings[0].drive, recordings[1].drive);
    const Log first = measure(none.truth, *recordings[0].drive, recordings[0].seed);
    const Log second = measure(none.truth, *recordings[1].drive, recordings[1].seed);
    EXPECT_GT(largestDifference(first, second, "chassis.vx"), 0.01);
}

TEST(BlindMake, KeyReadsBack) {
    BlindKey key;
    key.tread_version = "0.1";
    key.seed = 42;
    key.vehicle = "car.yaml";
    key.generator = "another";
    key.drives = DriveSet::step_steers;
    key.cases.push_back(drawn(CaseKind::two, 1).key);
    key.cases.push_back(drawn(CaseKind::outside, 1).key);
    EXPECT_EQ(keyText(parseKey(keyText(key), "key.json")), keyText(key));
    EXPECT_THROW(parseKey("{\"seed\": 1}", "key.json"), LoadError);
    EXPECT_THROW(caseKind("three"), LoadError);
}

}  // namespace
}  // namespace tread
