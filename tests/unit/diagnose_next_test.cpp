// What to drive next, on a car of three lines: a steering ratio and an understeer that look alike at one speed.
#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/answer/diagnosis.h"
#include "diagnose/answer/diagnosis_json.h"
#include "diagnose/answer/diagnosis_text.h"
#include "diagnose/catalogue/effect.h"
#include "diagnose/diagnose.h"
#include "diagnose/options.h"
#include "shared/simple_car.h"

namespace tread::diagnose_next_test {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::diagnosisText;
using diagnose::answer::NextDrive;
using diagnose::answer::RankedEffect;
using diagnose::answer::Verdict;
using diagnose::catalogue::Effect;

using simple_car::slalom;

const std::vector<Effect> kLookAlikes{
    simple_car::effect("ratio", "steering.ratio"),
    {"understeer", "", "", {{.paths = {"steering.play"}, .typical = 8e-4}}},
};

Diagnosis diagnosed(const std::vector<Scenario>& drives, const std::vector<diagnose::PossibleDrive>& possible) {
    VehicleParams truth = simple_car::Case{}.nominal.vehicle;
    truth.steering.play = 8e-4;  // as a ratio that is 12 % larger at 20 m/s
    const simple_car::Case made = simple_car::recorded(truth, drives, 5);
    diagnose::Options options = simple_car::options();
    options.possible_next = possible;
    return diagnose::diagnosisOf(made.nominal, made.file, made.recorded, kLookAlikes, options);
}

TEST(NextDrive, SeparatesWhatOneSpeedCannot) {
    const std::vector<diagnose::PossibleDrive> possible{
        {"the same again", slalom(20)}, {"slower", slalom(15)}, {"much slower", slalom(6)}};
    const Diagnosis open = diagnosed({slalom(20), slalom(20)}, possible);
    EXPECT_EQ(open.verdict, Verdict::ambiguous) << open.answer;
    ASSERT_EQ(open.next.size(), 1u);
    EXPECT_TRUE(open.next[0].scenario == "slower" || open.next[0].scenario == "much slower") << open.next[0].scenario;
    EXPECT_GT(open.next[0].nats, 6);
    EXPECT_NE(diagnosisText(open).find("NEXT      " + open.next[0].scenario + " would separate"), std::string::npos);

    // Driven, it does.
    const Scenario advised = open.next[0].scenario == "slower" ? slalom(15) : slalom(6);
    const Diagnosis settled = diagnosed({slalom(20), slalom(20), advised}, possible);
    EXPECT_EQ(settled.verdict, Verdict::explained) << settled.answer;
    EXPECT_EQ(settled.causes, std::vector<std::string>{"understeer"});
    const auto evidence = [](const Diagnosis& d, const std::string& name) {
        for (const RankedEffect& one : d.effects)
            if (one.name == name) return one.log_evidence;
        return 0.0;
    };
    const double gained = evidence(settled, "understeer") - evidence(settled, "ratio") -
                          (evidence(open, "understeer") - evidence(open, "ratio"));
    // The gain of a true cause is normal, with twice its mean as variance.
    EXPECT_GT(gained, open.next[0].nats - 2 * std::sqrt(2 * open.next[0].nats)) << "what was promised, less chance";
}

TEST(NextDrive, IsNotMuchFasterThanTheRecordings) {
    const std::vector<Scenario> drives{slalom(20), slalom(20)};
    EXPECT_TRUE(diagnosed(drives, {{"more than twice as fast", slalom(41)}}).next.empty());
    const Diagnosis faster = diagnosed(drives, {{"more than twice as fast", slalom(41)}, {"faster", slalom(30)}});
    ASSERT_EQ(faster.next.size(), 1u);
    EXPECT_EQ(faster.next[0].scenario, "faster");
    EXPECT_FALSE(diagnosed(drives, {{"nearly twice as fast", slalom(39)}}).next.empty());
}

TEST(NextDrive, IsNotAskedWhereNothingIsPossible) {
    const simple_car::Case made = simple_car::recorded(simple_car::Case{}.nominal.vehicle, {slalom(20)}, 1);
    EXPECT_TRUE(
        diagnose::diagnosisOf(made.nominal, made.file, made.recorded, kLookAlikes, simple_car::options()).next.empty());
}

TEST(NextDrive, ShowsWhatTheDrivesCouldNotShow) {
    Scenario straight = slalom(20);
    straight.phases.front().steering = {};
    const simple_car::Case made = simple_car::recorded(simple_car::Case{}.nominal.vehicle, {straight, straight}, 2);
    diagnose::Options options = simple_car::options();
    options.possible_next = {{"straight on", straight}, {"slalom", slalom(20)}};
    const Diagnosis d = diagnose::diagnosisOf(made.nominal, made.file, made.recorded, kLookAlikes, options);
    EXPECT_EQ(d.verdict, Verdict::not_testable) << d.answer;
    ASSERT_FALSE(d.next.empty());
    for (const NextDrive& next : d.next) EXPECT_EQ(next.scenario, "slalom");
}

}  // namespace
}  // namespace tread::diagnose_next_test
