// Making the cases of a blind check: draws, drives, key.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/fields/numbers.h"
#include "blind/detectability/detectable_effects.h"
#include "blind/faults/outsiders.h"
#include "blind/make/make_cases.h"
#include "blind/world/instruments.h"
#include "diagnose/catalogue/effect.h"
#include "recording/subject.h"
#include "shared/scratch.h"
#include "shared/vehicles.h"
#include "store/sha256.h"
#include "tread/problem.h"

namespace tread::blind_make_test {
namespace {

using blind::detectability::detectableEffects;
using blind::drives::caseDrives;
using blind::drives::Drive;
using blind::drives::DriveSet;
using blind::drives::driveSetNamed;
using blind::drives::kIdeal;
using blind::drives::measure;
using blind::faults::drawCase;
using blind::faults::Drawing;
using blind::faults::DrawnCase;
using blind::faults::Outsider;
using blind::faults::outsiders;
using blind::key::CaseKey;
using blind::key::CaseKind;
using blind::key::caseKindNamed;
using blind::key::Family;
using blind::key::keyText;
using blind::key::parseKey;
using blind::key::SealedKey;
using blind::make::CaseRecording;
using blind::make::drawnCase;
using blind::make::makeCases;
using blind::make::Order;
using blind::make::recordingsOf;
using blind::world::InstrumentSheet;
using blind::world::instrumentSheets;
using blind::world::Truth;
using blind::world::World;
using diagnose::catalogue::Direction;
using diagnose::catalogue::Effect;
using recording::numberAt;
using recording::Subject;

const std::vector<Effect> kEffects{
    {"heavier", "", "", {{{"mass"}, 0.1, true, Direction::up}}},
    {"late_gyro", "", "", {{{"instruments.yaw_rate.delay"}, 0.02, false, Direction::up}}},
    {"ratio", "", "", {{{"steering.ratio"}, 0.05, true, Direction::either}}},
};

DrawnCase drawn(CaseKind kind, std::uint64_t seed, const Drawing& drawing = {}) {
    Random random(seed);
    return drawCase(reference::compact(), kEffects, kind, random, drawing);
}

constexpr Drawing kAssumed{.world = World::assumed};

double largestDifference(const Log& a, const Log& b, std::string_view channel) {
    const auto &x = a.find(channel)->values, &y = b.find(channel)->values;
    double largest = 0;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) largest = std::max(largest, std::abs(x[i] - y[i]));
    return largest;
}

// Sum of squared differences of one channel over its noise.
double squaredChange(const Log& a, const Log& b, const InstrumentSheet& sheet) {
    const auto &x = a.find(sheet.channel)->values, &y = b.find(sheet.channel)->values;
    double sum = 0;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) sum += std::pow((x[i] - y[i]) / sheet.noise, 2);
    return sum;
}

TEST(BlindMake, HashIsThatOfTheStandard) {
    // FIPS 180-4, examples of NIST.
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(BlindMake, EveryNumberWithAToleranceErrsWithinItAsAssumed) {
    Subject nominal{.vehicle = reference::compact(), .road = {}, .wind = {}, .instruments = {}};
    DrawnCase none = drawn(CaseKind::none, 3, kAssumed);
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
        for (const auto& [drawing, smallest, largest] :
             {std::tuple(Drawing{}, 0.4, 2.5), std::tuple(kAssumed, 0.6, 1.6)}) {
            const DrawnCase one = drawn(CaseKind::one, seed, drawing), two = drawn(CaseKind::two, seed, drawing);
            const DrawnCase small = drawn(CaseKind::small, seed, drawing);
            const DrawnCase outside = drawn(CaseKind::outside, seed, drawing);
            const DrawnCase mixed = drawn(CaseKind::mixed, seed, drawing);
            ASSERT_EQ(one.key.effects.size(), 1u);
            ASSERT_EQ(small.key.effects.size(), 1u);
            ASSERT_EQ(two.key.effects.size(), 2u);
            EXPECT_NE(two.key.effects[0], two.key.effects[1]);
            for (const auto& [path, number] : one.key.numbers) {
                EXPECT_GE(std::abs(number.change), smallest) << path;
                EXPECT_LE(std::abs(number.change), largest) << path;
                if (path != "steering.ratio") {
                    EXPECT_GT(number.change, 0) << path;
                }
            }
            for (const auto& [path, number] : small.key.numbers) EXPECT_LE(std::abs(number.change), 0.15) << path;
            EXPECT_FALSE(outside.key.outsider.empty());
            EXPECT_TRUE(outside.key.effects.empty());
            EXPECT_FALSE(mixed.key.outsider.empty());
            EXPECT_EQ(mixed.key.effects.size(), 1u);
        }
    }
}

TEST(BlindMake, SecondFamilyIsDrawnInAFrozenCheckOnly) {
    std::map<Family, int> open, frozen;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        ++open[drawn(CaseKind::outside, seed).key.family];
        ++frozen[drawn(CaseKind::outside, seed, {.frozen = true}).key.family];
    }
    EXPECT_EQ(open[Family::second], 0);
    EXPECT_NEAR(frozen[Family::second], 30, 12) << "three standard deviations of an even draw";
    EXPECT_GE(outsiders(Family::first).size(), 5u);
    EXPECT_GE(outsiders(Family::second).size(), 6u);
}

TEST(BlindMake, CaseWithoutOneOfItsFaultsIsTheSameBesides) {
    DrawnCase two = drawn(CaseKind::two, 4), mixed = drawn(CaseKind::mixed, 4);
    ASSERT_EQ(two.without.size(), 2u);
    for (auto& [name, truth] : two.without) {
        const std::vector<Number> with = numbers(two.truth.car), without = numbers(truth.car);
        const Effect& effect = *std::find_if(kEffects.begin(), kEffects.end(),
                                             [&, &wanted = name](const Effect& e) { return e.name == wanted; });
        for (std::size_t i = 0; i < with.size(); ++i) {
            const bool moved = with[i].path == effect.knobs[0].paths[0];
            if (std::isfinite(*with[i].value)) {
                EXPECT_EQ(*with[i].value != *without[i].value, moved) << with[i].path;
            }
        }
    }
    EXPECT_EQ(mixed.without.size(), 2u);
}

// Checksums over all numbers of a car and over its readings at one instant: cases of World::assumed stay reproducible.
TEST(BlindMake, AssumedCasesAreThoseOfBefore) {
    struct Before {
        CaseKind kind;
        std::string planted;
        double numbers, readings;
    };
    const std::vector<Before> list{
        {CaseKind::one, "ratio", 595.92111657412863, 431.36574040945067},
        {CaseKind::two, "ratio+heavier", 595.92128776701088, 432.00294014938652},
        {CaseKind::none, "", 595.93653288377448, 432.0062131597204},
        {CaseKind::outside, "yaw_gust", 595.93653288377448, 431.20710188968872},
        {CaseKind::small, "ratio", 595.93521592330387, 431.95231628333647},
    };
    const std::vector<Drive> drives = caseDrives();
    const std::vector<CaseRecording> recordings = recordingsOf(drives, 7, 2);
    for (const Before& before : list) {
        DrawnCase now = drawnCase(7, 2, before.kind, reference::compact(), kEffects, 0, kAssumed);
        std::string planted = now.key.outsider;
        for (auto effect = now.key.effects.rbegin(); effect != now.key.effects.rend(); ++effect)
            planted = *effect + (planted.empty() ? "" : "+") + planted;
        EXPECT_EQ(planted, before.planted);
        double sum = 0, place = 1, readings = 0;
        for (const Number& number : numbers(now.truth.car)) {
            place = place == 7 ? 1 : place + 1;
            if (std::isfinite(*number.value)) sum += *number.value * place / (1 + std::abs(*number.value));
        }
        const Log log = measure(now.truth, *recordings[3].drive, recordings[3].seed);
        for (const Channel& channel : log.channels) readings += channel.values[300];
        // Compilers round differently, and the drive propagates it.
        EXPECT_NEAR(sum, before.numbers, 1e-9);
        EXPECT_NEAR(readings, before.readings, 1e-6);
    }
}

TEST(BlindMake, PlantedNumberIsThatOfTheCarThatIsDriven) {
    DrawnCase one = drawn(CaseKind::one, 5);
    for (const auto& [path, number] : one.key.numbers) EXPECT_EQ(*numberAt(one.truth.car, path), number.value);
}

TEST(BlindMake, EveryDriveHoldsItsGearAndEndsInTime) {
    const DrawnCase none = drawn(CaseKind::none, 1);
    int training = 0, held_out = 0;
    for (const Drive& drive : caseDrives()) {
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
        for (const Drive& drive : caseDrives(set)) {
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
    EXPECT_THROW(driveSetNamed("step_stear"), LoadError);
}

TEST(BlindMake, EveryOutsiderDrivesAllDrivesAndShows) {
    const DrawnCase none = drawn(CaseKind::none, 1);
    const std::vector<Drive> drives = caseDrives();
    std::vector<Log> without;
    for (const Drive& drive : drives) without.push_back(measure(none.truth, drive, 1, kIdeal));
    for (const Outsider& outsider : outsiders()) {
        Truth truth = none.truth;
        Random random(4);
        outsider.plant(truth, random);
        double squares = 0;  // sum of squared changes over the noise
        for (std::size_t i = 0; i < drives.size(); ++i) {
            const Log with = measure(truth, drives[i], 1, kIdeal);
            for (const Channel& channel : with.channels)
                for (const double value : channel.values)
                    ASSERT_TRUE(std::isfinite(value)) << outsider.name << ' ' << drives[i].name << ' ' << channel.name;
            for (const InstrumentSheet& sheet : instrumentSheets()) squares += squaredChange(with, without[i], sheet);
        }
        // Clearly visible: noise alone hides changes of the order of 10.
        EXPECT_GT(std::sqrt(squares), 60) << outsider.name;
    }
}

TEST(BlindMake, OutsidersAreDeterministic) {
    const DrawnCase none = drawn(CaseKind::none, 1);
    const Drive drive = caseDrives()[4];  // brakes in a turn
    for (const Outsider& outsider : outsiders()) {
        const auto driven = [&](std::uint64_t seed) {
            Truth truth = none.truth;
            Random random(seed);
            outsider.plant(truth, random);
            return measure(truth, drive, 3);
        };
        const Log first = driven(4), again = driven(4);
        for (std::size_t i = 0; i < first.channels.size(); ++i)
            EXPECT_EQ(first.channels[i].values, again.channels[i].values) << outsider.name;
    }
}

TEST(BlindMake, SameSeedMakesTheSameFilesAndAnotherOneOthers) {
    const Scratch scratch;
    const auto make = [&](const std::string& folder, std::uint64_t seed) {
        Order order;
        order.cases = 1;
        order.seed = seed;
        order.kinds = {CaseKind::one};
        order.drives = DriveSet::coast_and_accelerate;
        const SealedKey key = makeCases(order, reference::compact(), kEffects, scratch.path(folder));
        return keyText(key) + contentOf(scratch.path(folder + "/case_001/coast_down_120.csv"));
    };
    EXPECT_EQ(make("a", 1), make("b", 1));
    EXPECT_NE(make("a", 1), make("c", 2));
}

TEST(BlindMake, CaseIsDrawnAgainFromItsSeedAndKind) {
    const Scratch scratch;
    Order order;
    order.cases = 3;
    order.seed = 9;
    order.kinds = {CaseKind::none, CaseKind::one, CaseKind::mixed};
    order.drives = DriveSet::coast_and_accelerate;
    const SealedKey key = makeCases(order, reference::compact(), kEffects, scratch.path("cases"));
    const std::vector<Effect> shown = detectableEffects(reference::compact(), kEffects, caseDrives(order.drives));
    for (int i = 0; i < order.cases; ++i) {
        const CaseKey& made = key.cases[static_cast<std::size_t>(i)];
        CaseKey again = drawnCase(9, i, made.kind, reference::compact(), shown).key;
        EXPECT_EQ(made.shows.size(), made.effects.size() + (made.outsider.empty() ? 0 : 1));
        again.shows = made.shows;  // computed, not drawn
        EXPECT_EQ(again, made);
    }
}

TEST(BlindMake, RepeatsAreNotAlike) {
    const DrawnCase none = drawn(CaseKind::none, 1);
    const std::vector<Drive> drives = caseDrives();
    const auto recordings = recordingsOf(drives, 1, 0);
    ASSERT_EQ(recordings[0].drive, recordings[1].drive);
    const Log first = measure(none.truth, *recordings[0].drive, recordings[0].seed);
    const Log second = measure(none.truth, *recordings[1].drive, recordings[1].seed);
    EXPECT_GT(largestDifference(first, second, "chassis.vx"), 0.01);
}

TEST(BlindMake, KeyReadsBack) {
    SealedKey key;
    key.tread_version = "0.1";
    key.seed = 42;
    key.vehicle = "car.yaml";
    key.generator = "another";
    key.drives = DriveSet::step_steers;
    key.cases.push_back(drawn(CaseKind::two, 1).key);
    key.cases.push_back(drawn(CaseKind::outside, 1).key);
    EXPECT_EQ(keyText(parseKey(keyText(key), "key.json")), keyText(key));
    EXPECT_THROW(parseKey("{\"seed\": 1}", "key.json"), LoadError);
    EXPECT_THROW(caseKindNamed("three"), LoadError);
}

}  // namespace
}  // namespace tread::blind_make_test
