// Verdicts about a linear car that something pushes besides: what its effects explain, and what remains.
#include <gtest/gtest.h>

#include <cmath>

#include "diagnose/diagnose.h"
#include "shared/linear_car.h"

namespace tread {
namespace {

using diagnose::answer::Diagnosis;
using diagnose::answer::Verdict;
using diagnose::catalogue::Effect;
using simple_car::effect;

// Two drives of a car whose ratio is so many times the nominal one, and which a roll moment pushes that no steering
// causes, N m.
simple_car::Case pushedCase(double ratio, double moment) {
    VehicleParams truth = linear_car::nominal();
    truth.steering.ratio *= ratio;
    return linear_car::recorded(
        truth, 3, [=](const VehicleParams& car, const Scenario& scenario, const Recorder& recorder, const Pushing&) {
            const double phase = scenario.start.speed;  // another push in each drive
            linear_car::drivePushed(car, scenario, recorder, [=](double t, const VehicleInput&, const VehicleOutput&) {
                const double shape =
                    std::sin(5 * t + phase) + std::sin(9 * t + 2 * phase) + std::sin(13 * t + 3 * phase);
                return Push{.moment = {moment * shape, 0, 0}};
            });
        });
}

Diagnosis diagnosed(const simple_car::Case& made) {
    diagnose::Options options = linear_car::options();
    options.simulate = linear_car::drivePushed;
    return diagnose::diagnosisOf(made.nominal, made.file, made.recorded,
                                 {effect("ratio", "steering.ratio"), effect("drag", "aero.drag_area")}, options);
}

TEST(VerdictOnAPushedCar, IsExplainedWithoutAPush) {
    const Diagnosis d = diagnosed(pushedCase(1.5, 0));
    EXPECT_EQ(d.verdict, Verdict::explained) << d.answer;
    EXPECT_EQ(d.causes, std::vector<std::string>{"ratio"});
    EXPECT_LT(d.unexplained.beyond_ordinary, 6);
    EXPECT_LT(d.training.remainder.share, 0.05);
}

TEST(VerdictOnAPushedCar, IsPartlyExplainedWhereAnEffectExplainsMost) {
    const Diagnosis d = diagnosed(pushedCase(1.5, 600));
    EXPECT_EQ(d.verdict, Verdict::partly_explained) << d.answer;
    EXPECT_EQ(d.causes, std::vector<std::string>{"ratio"});
    EXPECT_TRUE(d.answer.starts_with("Mostly ratio ")) << d.answer;
    EXPECT_TRUE(d.answer.ends_with(" % of the gap remains unexplained")) << d.answer;
    EXPECT_GT(d.unexplained.beyond_ordinary, 6);
    EXPECT_GT(d.unexplained.sizes.at("roll"), 5);
    EXPECT_GT(d.training.causes.share, 0.5);
    EXPECT_GT(d.training.remainder.share, 0.05);
    EXPECT_NE(std::find(d.credible_set.begin(), d.credible_set.end(), "unknown"), d.credible_set.end());
}

TEST(VerdictOnAPushedCar, IsUnknownWhereNoEffectActsOrMostRemains) {
    const Diagnosis pushed = diagnosed(pushedCase(1, 600));
    EXPECT_EQ(pushed.verdict, Verdict::unknown) << pushed.answer;
    EXPECT_TRUE(pushed.causes.empty());
    EXPECT_GT(pushed.probability_of_unknown, 0.95);
    const Diagnosis mostly = diagnosed(pushedCase(1.3, 3000));
    EXPECT_EQ(mostly.verdict, Verdict::unknown) << mostly.answer;
}

// An effect with opposite values in the two drives explains each of them, and predicts neither.
TEST(VerdictOnAPushedCar, DoesNotNameAnEffectThatDoesNotPredict) {
    simple_car::Case made = pushedCase(1.5, 0);
    made.recorded.logs[1] = pushedCase(0.7, 0).recorded.logs[1];
    const Diagnosis d = diagnosed(made);
    EXPECT_TRUE(d.causes.empty()) << d.answer;
    EXPECT_EQ(d.verdict, Verdict::unknown);
}

}  // namespace
}  // namespace tread
