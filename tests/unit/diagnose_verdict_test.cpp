// Verdicts about a linear car that something pushes besides: what its effects explain, and what remains.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/diagnose.h"
#include "diagnose/settings.h"
#include "shared/linear_car.h"

namespace tread::diagnose_verdict_test {
namespace {

using diagnose::kSettings;
using diagnose::answer::Diagnosis;
using diagnose::answer::Verdict;
using diagnose::catalogue::Effect;
using simple_car::effect;

const Effect kRatio{"ratio", "", "", {{.paths = {"steering.ratio"}, .typical = 0.25, .relative = true}}};

// Drives of a car whose ratio is so many times the nominal one, and which a roll moment pushes that no steering
// causes, N m.
simple_car::Case pushedCase(double ratio, double moment, const std::vector<double>& speeds = {15, 22}) {
    VehicleParams truth = linear_car::nominal();
    truth.steering.ratio *= ratio;
    return linear_car::recorded(
        truth, 3,
        [=](const VehicleParams& car, const Scenario& scenario, const Recorder& recorder, const Pushing&) {
            const double phase = scenario.start.speed;  // another push in each drive
            linear_car::drivePushed(car, scenario, recorder, [=](double t, const VehicleInput&, const VehicleOutput&) {
                const double shape =
                    std::sin(5 * t + phase) + std::sin(9 * t + 2 * phase) + std::sin(13 * t + 3 * phase);
                return Push{.moment = {moment * shape, 0, 0}};
            });
        },
        speeds);
}

Diagnosis diagnosed(const simple_car::Case& made) {
    diagnose::Options options = linear_car::options();
    options.simulate = linear_car::drivePushed;
    return diagnose::diagnosisOf(made.nominal, made.file, made.recorded, {kRatio, effect("drag", "aero.drag_area")},
                                 options);
}

TEST(VerdictOnAPushedCar, IsExplainedWithoutAPush) {
    const Diagnosis d = diagnosed(pushedCase(1.5, 0));
    EXPECT_EQ(d.verdict, Verdict::explained) << d.answer;
    EXPECT_EQ(d.causes, std::vector<std::string>{"ratio"});
    EXPECT_LT(d.unexplained.beyond_ordinary, 6);
    EXPECT_LT(d.training.remainder.share, 0.05);
}

TEST(VerdictOnAPushedCar, IsPartlyExplainedWhereAnEffectExplainsMost) {
    const Diagnosis d = diagnosed(pushedCase(1.5, 900, {14, 15, 16, 17, 18, 19, 20, 21, 22, 23}));
    EXPECT_EQ(d.verdict, Verdict::partly_explained) << d.answer;
    EXPECT_EQ(d.causes, std::vector<std::string>{"ratio"});
    EXPECT_TRUE(d.answer.starts_with("Mostly ratio (p = 0.")) << d.answer;
    EXPECT_TRUE(d.answer.ends_with(" % of the gap remains unexplained")) << d.answer;
    EXPECT_GT(d.unexplained.beyond_ordinary, 6);
    EXPECT_GT(d.unexplained.sizes.at("roll"), 5);
    EXPECT_GT(d.training.causes.share, 0.5);
    EXPECT_GT(d.training.remainder.share, 0.05);
    // It closes the share c of what is left without it; an unknown cause alone may be that much like it (D32a).
    const double c = d.training.causes.share / (d.training.causes.share + d.training.remainder.share),
                 alike = kSettings.none / kSettings.prior(1) * 4 * std::log(10) * c * (1 - c);
    EXPECT_NEAR(d.effects.front().probability, 1 / (1 + alike), 0.01);
    EXPECT_NE(std::find(d.credible_set.begin(), d.credible_set.end(), "unknown"), d.credible_set.end());
}

TEST(VerdictOnAPushedCar, IsUnknownWhereNoEffectActsOrMostRemains) {
    const Diagnosis pushed = diagnosed(pushedCase(1, 1800));
    EXPECT_EQ(pushed.verdict, Verdict::unknown) << pushed.answer;
    EXPECT_TRUE(pushed.causes.empty());
    EXPECT_GT(pushed.probability_of_unknown, 0.95);
    const Diagnosis mostly = diagnosed(pushedCase(1.3, 3000));
    EXPECT_EQ(mostly.verdict, Verdict::unknown) << mostly.answer;
}

// An effect with opposite values in the two drives explains each of them, and predicts neither.
TEST(VerdictOnAPushedCar, DoesNotNameAnEffectThatDoesNotPredict) {
    simple_car::Case made = pushedCase(2, 0);
    made.recorded.logs[1] = pushedCase(0.3, 0).recorded.logs[1];
    const Diagnosis d = diagnosed(made);
    EXPECT_TRUE(d.causes.empty()) << d.answer;
    EXPECT_EQ(d.verdict, Verdict::unknown);
}

// The ratio of this car differs in the drives that are fitted, and not in the one held out.
TEST(VerdictOnAPushedCar, SaysWhyAnEffectWithEvidenceIsNotTheAnswer) {
    simple_car::Case made = pushedCase(1.5, 0, {15, 22, 18});
    made.file.recordings[2].hold_out = true;
    made.recorded.logs[2] = pushedCase(1, 0, {15, 22, 18}).recorded.logs[2];
    const Diagnosis d = diagnosed(made);
    EXPECT_TRUE(d.causes.empty()) << d.answer;
    const auto ratio = std::find_if(d.ruled_out.begin(), d.ruled_out.end(),
                                    [](const auto& one) { return one.effects == std::vector<std::string>{"ratio"}; });
    ASSERT_NE(ratio, d.ruled_out.end());
    EXPECT_GT(ratio->log_evidence, kSettings.effect);
    EXPECT_NE(ratio->reason.find("drives"), std::string::npos) << ratio->reason;
}

}  // namespace
}  // namespace tread::diagnose_verdict_test
