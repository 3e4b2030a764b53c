// What drives could show of each effect, on a car of two lines.
#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/precheck.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/diagnose.h"
#include "diagnose/precheck.h"
#include "diagnose/settings.h"
#include "shared/simple_car.h"

namespace tread::diagnose_precheck_test {
namespace {

using diagnose::kSettings;
using diagnose::kTestable;

using diagnose::answer::ConfusablePair;
using diagnose::answer::Diagnosis;
using diagnose::answer::Precheck;
using diagnose::answer::precheckText;
using diagnose::answer::Visibility;
using diagnose::answer::visibility;
using diagnose::catalogue::Effect;
using diagnose::catalogue::Knob;

using simple_car::effect;

constexpr double kNominalRatio = 16.5;

double dragArea() {
    return loadVehicle(sourceFile("vehicles/compact.yaml")).aero.drag_area;
}

Precheck checked(const simple_car::Case& made, const std::vector<Effect>& effects, int threads = 2) {
    return diagnose::precheckOf(made.nominal, made.file, made.recorded, effects, simple_car::options(threads));
}

TEST(Precheck, WhatNoDriveExcitesIsNotSeenAndWhatTheyDoIs) {
    const simple_car::Case made = simple_car::recorded(kNominalRatio, dragArea(), 3);
    const Precheck seen =
        checked(made, {effect("ratio", "steering.ratio"), effect("brakes", "brakes.full_pedal_torque")});
    EXPECT_GT(seen.expected_evidence.at("ratio"), kTestable);
    EXPECT_EQ(seen.expected_evidence.at("brakes"), 0) << "this car has none";
    const std::string text = precheckText(seen);
    const std::size_t hidden = text.find("NOT SEEN");
    ASSERT_NE(hidden, std::string::npos) << text;
    EXPECT_LT(text.find("ratio"), hidden) << text;
    EXPECT_GT(text.find("brakes"), hidden) << text;
    EXPECT_TRUE(seen.confusable.empty());
}

TEST(Precheck, EffectsWithTheSameTraceArePairedAndTheOthersAreNot) {
    // Yaw rate is speed times angle over ratio and wheelbase: by first order the two cannot be told apart.
    const simple_car::Case made = simple_car::recorded(kNominalRatio, dragArea(), 3);
    const Precheck seen = checked(
        made, {effect("ratio", "steering.ratio"), effect("wheelbase", "wheelbase"), effect("drag", "aero.drag_area")});
    ASSERT_EQ(seen.confusable.size(), 1u);
    const ConfusablePair& pair = seen.confusable.front();
    EXPECT_EQ(pair.a, "ratio");
    EXPECT_EQ(pair.b, "wheelbase");
    EXPECT_GT(pair.cosine, 0.99);
    EXPECT_LT(pair.separation, kSettings.clear);
    EXPECT_NE(precheckText(seen).find("ALIKE     ratio and wheelbase"), std::string::npos);
}

TEST(Precheck, PairsLookAlikeAndAreNearEachOther) {
    const simple_car::Case made = simple_car::recorded(kNominalRatio, dragArea(), 3);
    // The one does what the other does, and slows the car down besides.
    const auto alike = [&](double typical) {
        const Knob turns{.paths = {"steering.ratio"}, .typical = typical, .relative = true},
            turns_and_slows{.paths = {"wheelbase", "aero.drag_area"}, .typical = typical, .relative = true};
        return checked(made, {{"one", "", "", {turns}}, {"other", "", "", {turns_and_slows}}}).confusable;
    };
    const std::vector<ConfusablePair> near = alike(0.06), far = alike(0.6);
    ASSERT_EQ(near.size(), 1u);
    EXPECT_LT(near.front().separation, kSettings.clear);
    EXPECT_TRUE(far.empty());
    // What one of them hardly shows is hard to tell from anything.
    const Precheck faint = checked(made, {{"understeer", "", "", {{.paths = {"steering.play"}, .typical = 5.2e-5}}},
                                          effect("ratio", "steering.ratio")});
    EXPECT_GT(faint.expected_evidence.at("understeer"), kSettings.clear);
    EXPECT_LT(faint.expected_evidence.at("understeer"), 1.1 * kSettings.clear);
    EXPECT_TRUE(faint.confusable.empty());
}

TEST(Precheck, PromisesAtLeastTheNatsThatDiagnosesFindWhenTheEffectIsThereAtItsTypicalSize) {
    // Understeer: what the tolerances of ratio and wheelbase cannot imitate at all speeds.
    constexpr double kTypical = 1.5e-4;
    const Effect understeer{"understeer", "", "", {{.paths = {"steering.play"}, .typical = kTypical}}};
    VehicleParams truth = simple_car::Case{}.nominal.vehicle;
    truth.steering.play = kTypical;
    constexpr std::uint64_t kCars = 5;
    double promised = 0, found = 0;
    for (std::uint64_t seed = 1; seed <= kCars; ++seed) {
        const simple_car::Case made =
            simple_car::recorded(truth, {simple_car::slalom(15), simple_car::slalom(20), simple_car::slalom(25)}, seed);
        promised += checked(made, {understeer}).expected_evidence.at("understeer") / kCars;
        const Diagnosis d =
            diagnose::diagnosisOf(made.nominal, made.file, made.recorded, {understeer}, simple_car::options());
        found += d.effects.front().log_evidence / kCars;
    }
    // By chance the evidence of one car differs by the root of twice what is promised; half the logarithm of its
    // information goes to the knob's freedom. A model without the effect may take some of it for a drift of the gyro.
    EXPECT_LT(found, promised - 0.5 * std::log(1 + 2 * promised) + 2 * std::sqrt(2 * promised / kCars));
    // However clearly the drives show it, an imperfection of its size instead costs about 16 nats.
    EXPECT_GT(found, std::min(0.5 * promised, 10.0));
}

TEST(Precheck, DoesNotDependOnWhatTheRecordedCarWas) {
    const std::vector<Effect> effects{effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")};
    const Precheck nominal = checked(simple_car::recorded(kNominalRatio, dragArea(), 3), effects),
                   other = checked(simple_car::recorded(14.5, 1.2 * dragArea(), 3), effects);
    for (const auto& [name, nats] : nominal.expected_evidence)
        EXPECT_NEAR(other.expected_evidence.at(name), nats, 0.05 * nats)
            << name << ": only their noise is taken from drives";
}

TEST(Precheck, IsTheSameToTheBitForOneAndTwoThreads) {
    const simple_car::Case made = simple_car::recorded(14.5, dragArea(), 3);
    const std::vector<Effect> effects{effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")};
    EXPECT_EQ(checked(made, effects, 1).expected_evidence, checked(made, effects, 2).expected_evidence);
}

TEST(Visibility, GroupsStandInOrderOfWhatToExpect) {
    const Visibility groups = visibility({{"a", 1}, {"b", 1e3}, {"c", 1e4}, {"d", 0}});
    ASSERT_EQ(groups.found.size(), 2u);
    EXPECT_EQ(groups.found.front().first, "c");
    ASSERT_EQ(groups.hidden.size(), 2u);
    EXPECT_EQ(groups.hidden.back().first, "d");
}

}  // namespace
}  // namespace tread::diagnose_precheck_test
